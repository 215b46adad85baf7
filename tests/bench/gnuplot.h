#pragma once
// Plots, where gnuplot is installed.

#include <filesystem>
#include <optional>
#include <string>

namespace halftone::bench {

/// Runs a script of tests/bench in the folder, once for an SVG and once for a PNG: it is told which as
/// `kind`, besides the variables ("a=1; b='x'; "). What went wrong, if anything.
std::optional<std::string> gnuplot(const std::filesystem::path& folder, const std::string& script,
                                   const std::string& variables);

} // namespace halftone::bench
