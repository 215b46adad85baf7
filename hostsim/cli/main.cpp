#include <halftone/cli/program.h>

int main(int argc, char** argv) { return halftone::cli::run_program(argc, argv); }
