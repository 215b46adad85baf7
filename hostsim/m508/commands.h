#pragma once
// The commands of m508.

#include <halftone/terminal/program.h>

namespace halftone::m508 {

using terminal::ArgumentError;
using terminal::Command;
using terminal::ExitCode;
using terminal::OutputError;

Command add_serve(CLI::App& program);
Command add_disasm(CLI::App& program);
Command add_asm(CLI::App& program);
Command add_replay(CLI::App& program);
Command add_stats(CLI::App& program);
Command add_assert(CLI::App& program);
Command add_diff(CLI::App& program);
Command add_lint(CLI::App& program);
Command add_who(CLI::App& program);

} // namespace halftone::m508
