#pragma once
// Commands as a line for people.

#include <halftone/protocol/decoder.h>

#include <string>

namespace halftone::inspect {

/// As the disassembler writes it, without the sequence number and with long data cut off; a rejection as what
/// is wrong with it.
std::string text_of(const protocol::Item& item);

} // namespace halftone::inspect
