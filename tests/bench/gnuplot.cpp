#include "gnuplot.h"

#include "shell.h"

#include <cstdlib>

namespace halftone::bench {

std::optional<std::string> gnuplot(const std::filesystem::path& folder, const std::string& script,
                                   const std::string& variables) {
  if (std::system("gnuplot --version >/dev/null 2>&1") != 0)
    return "gnuplot is not installed (Debian: gnuplot-nox); there are no plots";
  for (const std::string kind : {"svg", "png"}) {
    const std::string command = "cd " + in_shell_quotes(folder.string()) + " && gnuplot -e \"" + variables +
                                "kind='" + kind + "'\" '" HALFTONE_SOURCE_DIR "/tests/bench/" + script +
                                "' 2>plot.log";
    if (std::system(command.c_str()) != 0) return "gnuplot failed on " + script + ": see plot.log";
  }
  return std::nullopt;
}

} // namespace halftone::bench
