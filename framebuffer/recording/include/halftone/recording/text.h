#pragma once
// The text form of recordings (docs/text-form.md): that of their data, and a directive for every other byte.
// assemble(disassemble(trace)) has the same bytes as the trace.

#include <halftone/recording/trace.h>

#include <string>
#include <string_view>

namespace halftone::recording {

/// Of a raw stream: its text form, without directives.
std::string disassemble(const Trace& trace);

/// A text that does not begin with the directive .trace is a raw stream. Throws protocol::TextError.
Trace assemble(std::string_view text, const std::string& file = {});

} // namespace halftone::recording
