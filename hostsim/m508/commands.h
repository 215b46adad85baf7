#pragma once
// The commands of m508.

#include <halftone/terminal/program.h>

namespace halftone::m508 {

using terminal::ArgumentError;
using terminal::Arguments;
using terminal::Command;
using terminal::ExitCode;
using terminal::OutputError;

Command add_serve(Arguments program);
Command add_disasm(Arguments program);
Command add_asm(Arguments program);
Command add_replay(Arguments program);
Command add_stats(Arguments program);
Command add_assert(Arguments program);
Command add_diff(Arguments program);
Command add_lint(Arguments program);
Command add_who(Arguments program);

} // namespace halftone::m508
