#pragma once
// One check against one state.

#include <halftone/inspect/check.h>

#include <halftone/recording/walk.h>

#include <functional>
#include <map>

namespace halftone::inspect {

using Counts = std::map<std::string, std::uint64_t, std::less<>>;

/// Counts a step under all names that it has.
void count(const recording::Step& step, Counts& counts);

/// Without the number.
Verdict judge(const Check& check, const device::Device& device, const Counts& counts);

} // namespace halftone::inspect
