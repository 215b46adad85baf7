#include "document.h"

#include <catch2/catch.hpp>

#include <iostream>
#include <string>

namespace {

void require_current(const std::string& name, const std::string& wanted) {
  if (halftone::test::section_of_document(name) == wanted) return;
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
