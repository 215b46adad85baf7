#include "support/scratch.h"

#include <halftone/protocol/message.h>
#include <halftone/protocol/text.h>

#include <catch2/catch.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

using namespace halftone;
using protocol::assemble;
using protocol::disassemble;
using Bytes = std::vector<std::uint8_t>;

namespace {

/// The n-th block of code in docs/text-form.md.
std::string block(int n) {
  std::string text = test::contents(HALFTONE_SOURCE_DIR "/docs/text-form.md");
  for (int fence = 0; fence < 2 * n + 1; ++fence) text.erase(0, text.find("```") + 3);
  text.erase(0, text.find('\n') + 1);
  return text.substr(0, text.find("```"));
}

} // namespace

TEST_CASE("the example written by hand in docs/text-form.md is assembled to what the next one shows") {
  CHECK(disassemble(assemble(block(0))) == block(1));
}

TEST_CASE("the stream that the document takes apart has every kind of line") {
  const std::string text = block(2);
  CHECK(disassemble(assemble(text)) == text);
  for (const std::string_view kind : {"zeros ", "bytes ", "frame ", "; unknown opcode", "; out of limits"}) {
    INFO(kind);
    CHECK(text.find(kind) != std::string::npos);
  }
}

TEST_CASE("numbers may be left out, and go on from the last one") {
  CHECK(assemble("clear\nclear\n") == assemble("#1 clear\n#2 clear"));
  CHECK(assemble("#7 clear\nframe 0x77\nbytes 00\nclear") ==
        assemble("#7 clear\n#8 frame 119\nzeros 1\n#9 clear"));
  CHECK(assemble("#4294967295 clear\nclear") == assemble("#4294967295 clear\n#0 clear"));
}

TEST_CASE("blanks, comments, ends of lines, case of digits and order of operands mean nothing") {
  const Bytes wanted = assemble("#1 border thickness=2 red=255 green=0 blue=171\n#2 mark \"a;b\"");
  CHECK(
      assemble("\n; a comment\r\n\t#1  border blue=0xAB red=0xff green=0 thickness=2 ;x\r\n mark \"a;b\";") ==
      wanted);
}

TEST_CASE("equal units are written once, where that is shorter") {
  const std::string text = "#1 pixels ff0000*400 123456*2 000000*3\n";
  CHECK(disassemble(assemble(text)) == text);
  CHECK(assemble("pixels ff0000*2") == assemble("pixels ff0000 ff0000"));
  CHECK(disassemble(assemble("pixels 010203*2")) == "#1 pixels 010203*2\n");
}

TEST_CASE("quotes and backslashes in text are written with a backslash") {
  const std::string text = "#1 mark \"a \\\"b\\\\ c\"\n";
  CHECK(disassemble(assemble(text)) == text);
  CHECK(assemble("mark \"\\x41\"") == assemble("mark \"A\""));
}

TEST_CASE("no name stands for two things") {
  for (const protocol::OpcodeEntry& entry : protocol::opcode_table) {
    CHECK(protocol::find(entry.name) == &entry);
    CHECK(entry.name.size() <= 24); // nearest.cpp
    for (const std::string_view word : {"bytes", "zeros", "frame"}) CHECK(entry.name != word);
  }
}

TEST_CASE("nothing is the text form of nothing") {
  CHECK(disassemble(Bytes{}).empty());
  CHECK(assemble("").empty());
  CHECK(assemble("\n \n; only a comment").empty());
}
