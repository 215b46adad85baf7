#pragma once
// The program halftone. This room alone prints, to stdout and stderr.

namespace halftone::cli {

/// Parses the arguments and does what they ask for. Returns the exit code for the shell (exit_code.h).
int run_program(int argc, char** argv);

} // namespace halftone::cli
