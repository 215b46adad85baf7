#include <halftone/cli/program.h>

#include "commands.h"

namespace halftone::cli {

int run_program(int argc, char** argv) {
  return terminal::run(
      {"halftone",
       "Renders scenes by scanlines, with ray tracing only where a scene needs it, through an emulated\n"
       "512 x 512 x 24 frame buffer.",
       "halftone render scenes/fig9a.toml",
       {add_render, add_view, add_check, add_compare, add_convert, add_info}},
      argc, argv);
}

} // namespace halftone::cli
