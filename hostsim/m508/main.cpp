#include <halftone/m508/program.h>

int main(int argc, char** argv) { return halftone::m508::run_program(argc, argv); }
