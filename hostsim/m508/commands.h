#pragma once
// The commands of m508.

#include <halftone/terminal/program.h>

namespace halftone::m508 {

using terminal::ArgumentError;
using terminal::Command;
using terminal::ExitCode;
using terminal::OutputError;

} // namespace halftone::m508
