#pragma once
// The sections of docs/protocol.md that are made from the tables.

#include <string>

namespace halftone::test {

/// Every opcode with its operands and a frame of it taken apart.
std::string document_opcodes();

/// The error codes.
std::string document_faults();

} // namespace halftone::test
