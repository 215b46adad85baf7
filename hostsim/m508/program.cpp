#include <halftone/m508/program.h>

#include "commands.h"

namespace halftone::m508 {

int run_program(int argc, char** argv) {
  return terminal::run(
      {"m508",
       "The emulated 512 x 512 x 24 frame buffer as a process, and tools for what drivers send to it.",
       "m508 replay session.m508 -o screen.png",
       {
           add_serve,
           add_replay,
           add_stats,
           add_disasm,
           add_asm,
           add_who,
           add_diff,
           add_lint,
           add_assert,
       }},
      argc, argv);
}

} // namespace halftone::m508
