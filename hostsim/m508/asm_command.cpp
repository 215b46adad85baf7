// m508 asm: a stream or a recording from text.

#include "commands.h"
#include "input.h"

#include <halftone/file/write.h>
#include <halftone/recording/text.h>
#include <halftone/recording/write.h>
#include <halftone/terminal/output_file.h>

#include <memory>
#include <span>
#include <string>

namespace halftone::m508 {

namespace {

struct Options {
  std::string file;
  std::string output;
};

ExitCode run(const Options& options) {
  check_files({{"-o", options.output}}, {options.file});
  const recording::Bytes bytes = encode(recording::assemble(read_text(options.file), options.file));
  const terminal::SignalShelter shelter;
  file::write_whole(options.output, std::as_bytes(std::span(bytes)));
  return ExitCode::done;
}

} // namespace

Command add_asm(Arguments program) {
  Arguments command = program.add_subcommand("asm", "Make a stream of commands, or a recording, of text");
  const auto options = std::make_shared<Options>();
  command.add_option("FILE", options->file, "Text (docs/text-form.md), - for standard input")
      .required()
      .type_name("");
  command
      .add_option("-o,--output", options->output, "Raw stream; a recording where the text begins with .trace")
      .required()
      .type_name("OUT");
  command.footer("Example:\n  m508 asm test.txt -o test.stream");
  return {command, [options] { return run(*options); }};
}

} // namespace halftone::m508
