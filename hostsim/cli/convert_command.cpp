// halftone convert: a scene in another format.

#include "commands.h"

#include <halftone/convert/povray.h>
#include <halftone/convert/toml.h>
#include <halftone/file/write.h>
#include <halftone/scene/read.h>
#include <halftone/terminal/output_file.h>

#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace halftone::cli {

namespace {

struct Options {
  std::string in;
  std::string out;
};

using Writer = std::string (*)(const scene::Scene&);

/// The format is told by the ending of the file's name.
Writer writer_for(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".pov") return convert::povray;
  if (ending == ".toml") return convert::toml;
  throw ArgumentError("OUT: expected a name that ends in .pov or .toml, found \"" +
                      terminal::one_line(file.string()) + "\"");
}

ExitCode run(const Options& options) {
  const Writer writer = writer_for(options.out);
  terminal::check_outputs({{"OUT", options.out}}, {options.in});
  const std::string text = writer(scene::read_scene(options.in));
  const terminal::SignalShelter shelter;
  file::write_whole(options.out, std::as_bytes(std::span(text)));
  return ExitCode::done;
}

} // namespace

Command add_convert(Arguments program) {
  Arguments command = program.add_subcommand(
      "convert", "Write a scene in another format: POV-Ray 3.7 (.pov), or TOML with every key (.toml)");
  const auto options = std::make_shared<Options>();
  command.add_option("IN", options->in, "Scene file (.toml)").required().type_name("");
  command.add_option("OUT", options->out, "File to write, .pov or .toml").required().type_name("");
  command.footer("Example:\n  halftone convert scenes/fig9b.toml fig9b.pov");
  return {command, [options] { return run(*options); }};
}

} // namespace halftone::cli
