#pragma once
// The program m508: the device as a process, and the tools for what was sent to it.

namespace halftone::m508 {

/// Parses the arguments and does what they ask for. Returns the exit code for the shell
/// (terminal/exit_code.h).
int run_program(int argc, char** argv);

} // namespace halftone::m508
