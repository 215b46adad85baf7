#pragma once
// The commands of halftone, the host.

#include <halftone/terminal/program.h>

namespace halftone::cli {

using terminal::ArgumentError;
using terminal::Arguments;
using terminal::Command;
using terminal::ExitCode;

Command add_render(Arguments program);
Command add_view(Arguments program);
Command add_check(Arguments program);
Command add_compare(Arguments program);
Command add_convert(Arguments program);
Command add_info(Arguments program);

} // namespace halftone::cli
