// docs/tutorial-device.md shows what the program prints: its commands are run and their output compared.
//
// In it, a block that begins with ```text NAME or ```toml NAME is a file; one that begins with ```console is
// a session of which every line after a "$ " is a command, and the others are what it prints. A block that
// begins with ```cmake, ```c or ```cpp and a NAME is an excerpt of that file in tests/package.

#include "program.h"

#include <catch2/catch.hpp>

#include <array>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>

using halftone::test::Bench;

namespace {

std::string run_shell(const Bench& bench, const std::string& command) {
  const std::string folder = std::filesystem::path(HALFTONE_PROGRAM).parent_path();
  const std::string call = "cd '" + bench.scratch.path().string() + "' && PATH='" + folder +
                           "':\"$PATH\" && { " + command + "\n} 2>&1";
  std::FILE* pipe = ::popen(call.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string out;
  std::array<char, 4096> buffer;
  for (std::size_t count = 0; (count = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    out.append(buffer.data(), count);
  ::pclose(pipe);
  return out;
}

/// A session with what is printed now.
std::string run_session(const Bench& bench, const std::string& session) {
  std::istringstream lines(session);
  std::string result;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("$ ")) result += line + '\n' + run_shell(bench, line.substr(2));
  return result;
}

} // namespace

TEST_CASE("docs/tutorial-device.md shows what the program prints") {
  const Bench bench;
  std::filesystem::create_directory_symlink(HALFTONE_SOURCE_DIR "/scenes", bench.scratch / "scenes");
  std::istringstream page(halftone::test::contents(HALFTONE_SOURCE_DIR "/docs/tutorial-device.md"));
  int sessions = 0;
  int excerpts = 0;
  int unheld = 0; ///< sessions that are not marked as such
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("```")) continue;
    std::istringstream heading(line.substr(3));
    std::string kind, name, block;
    heading >> kind >> name;
    for (std::string inner; std::getline(page, inner) && inner != "```";) block += inner + '\n';
    if (kind == "console") {
      ++sessions;
      CHECK(run_session(bench, block) == block);
    } else if (kind == "cmake" || kind == "c" || kind == "cpp") {
      ++excerpts;
      INFO(block << "is no part of tests/package/" << name);
      CHECK(halftone::test::contents(HALFTONE_SOURCE_DIR "/tests/package/" + name).find(block) !=
            std::string::npos);
    } else if (!name.empty()) {
      bench.file(name, block);
    } else if (block.find("\n$ ") != std::string::npos || block.starts_with("$ ")) {
      ++unheld;
    }
  }
  CHECK(sessions > 10);
  CHECK(excerpts == 3);
  CHECK(unheld == 0);
}
