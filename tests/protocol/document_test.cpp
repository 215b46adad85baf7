#include "document.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

namespace {

/// What stands in docs/protocol.md between the two comments that enclose a generated section.
std::string section(const std::string& name) {
  std::ifstream file(HALFTONE_SOURCE_DIR "/docs/protocol.md");
  REQUIRE(file);
  std::ostringstream text;
  text << file.rdbuf();
  const std::string begin = "<!-- begin " + name + " -->\n\n", end = "<!-- end " + name + " -->";
  const std::string document = text.str();
  const std::size_t first = document.find(begin);
  REQUIRE(first != std::string::npos);
  const std::size_t last = document.find(end, first);
  REQUIRE(last != std::string::npos);
  return document.substr(first + begin.size(), last - first - begin.size());
}

void require_current(const std::string& name, const std::string& wanted) {
  if (section(name) == wanted) return;
  std::cout << wanted; // not in the message: Catch breaks lines
  FAIL("docs/protocol.md is not current: the text above should stand between its comments \"" << name
                                                                                              << "\"");
}

} // namespace

TEST_CASE("docs/protocol.md describes the opcode table as it is") {
  require_current("opcodes", halftone::test::document_opcodes());
}

TEST_CASE("docs/protocol.md lists the error codes as they are") {
  require_current("errors", halftone::test::document_faults() + "\n");
}
