#pragma once
// The program halftone: the host, which renders and drives the device.

namespace halftone::cli {

/// Parses the arguments and does what they ask for. Returns the exit code for the shell
/// (terminal/exit_code.h).
int run_program(int argc, char** argv);

} // namespace halftone::cli
