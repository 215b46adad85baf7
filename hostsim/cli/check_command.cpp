// halftone check: validates scene files.

#include "commands.h"

#include <halftone/core/error.h>
#include <halftone/scene/read.h>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace halftone::cli {

namespace {

ExitCode run(const std::vector<std::string>& scenes) {
  ExitCode result = ExitCode::done;
  for (const std::string& file : scenes) {
    try {
      scene::read_scene(file);
    } catch (const core::InputError& error) {
      std::cerr << "halftone: " << error.what() << '\n';
      result = ExitCode::bad_input;
    }
  }
  return result;
}

} // namespace

Command add_check(Arguments program) {
  Arguments command = program.add_subcommand(
      "check", "Validate scenes: one line for each bad file, silent where all are right");
  const auto scenes = std::make_shared<std::vector<std::string>>();
  command.add_option("SCENE", *scenes, "Scene files (.toml)").required().type_name("");
  command.footer("Example:\n  halftone check scenes/*.toml");
  return {command, [scenes] { return run(*scenes); }};
}

} // namespace halftone::cli
