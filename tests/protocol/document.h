#pragma once
// docs/protocol.md, and its sections that are made from the tables.

#include <string>

namespace halftone::test {

/// What stands in docs/protocol.md between the two comments that enclose a section of this name. Throws
/// std::logic_error where there is none.
std::string section_of_document(const std::string& name);

/// Every opcode with its operands and a frame of it taken apart.
std::string document_opcodes();

/// The error codes.
std::string document_faults();

} // namespace halftone::test
