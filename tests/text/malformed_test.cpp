#include <halftone/protocol/text.h>

#include <catch2/catch.hpp>

#include <string>

using namespace halftone;

namespace {

struct Malformed {
  std::string text;
  int line;
  int column;
  std::string problem; ///< the message begins with it, after the place
};

} // namespace

TEST_CASE("text that is wrong is refused with its place and advice") {
  const Malformed cases[] = {
      {"clera", 1, 1, "unknown command \"clera\"; did you mean \"clear\"?"},
      {"clear\n  #3 colour", 2, 6, "unknown command \"colour\"; known are identify, reset,"},
      {"#x clear", 1, 2, "the number after # is a number from 0 to 4294967295, found \"x\""},
      {"#4294967296 clear", 1, 2, "the number after # is a number from 0 to 4294967295"},
      {"#3", 1, 3, "expected the name of a command, and the line ends here"},
      {"#3 zeros 4", 1, 1, "\"zeros\" has no sequence number"},
      {"zeros", 1, 6, "expected how many zeros"},
      {"zeros 0", 1, 7, "the count of zeros is a number from 1 to 65536"},
      {"zeros 65537", 1, 7, "the count of zeros is a number from 1 to 65536"},
      {"zeros 1 2", 1, 9, "expected the end of the line, found \"2\""},
      {"bytes", 1, 6, "expected bytes of two hexadecimal digits"},
      {"bytes 4d 3", 1, 10, "expected 2 hexadecimal digits, found \"3\""},
      {"bytes 4d 3g", 1, 10, "expected 2 hexadecimal digits, found \"3g\""},
      {"bytes 00*65537", 1, 7, "with these there are more bytes than the 65536 allowed here"},
      {"bytes 00*", 1, 10, "how often bytes are repeated is a number from 1 to 4294967295"},
      {"bytes 00*0", 1, 10, "how often bytes are repeated is a number from 1 to 4294967295"},
      {"bytes 00*99999999999999999999", 1, 10, "how often bytes are repeated is a number"},
      {"frame", 1, 6, "expected an opcode"},
      {"frame 0x100", 1, 7, "the opcode is a number from 0 to 255"},
      {"frame 1 00*4097", 1, 9, "with these there are more bytes than the 4096 allowed here"},
      {"clear x=1", 1, 7, "expected the end of the line"},
      {"window x=1 y=2 width=3", 1, 23, "expected height=..., and the line ends here"},
      {"window x=1 y=2 widht=3 height=4", 1, 16,
       "unknown operand \"widht\" of window; did you mean \"width\"?"},
      {"window x=1 y=2 qqqqq=3 height=4", 1, 16, "unknown operand \"qqqqq\" of window; known are x, y,"},
      {"window 1 2 3 4", 1, 8, "expected x=... y=... width=... height=..., found \"1\""},
      {"window x=1 y=2 x=3 width=4", 1, 16, "there is a second x"},
      {"window x=512 y=0 width=1 height=1", 1, 10, "x is a number from 0 to 511, found \"512\""},
      {"window x=-1 y=0 width=1 height=1", 1, 10, "x is a number from 0 to 511, found \"-1\""},
      {"window x= y=0 width=1 height=1", 1, 10, "x is a number from 0 to 511, found \"\""},
      {"window x=9 y=0 width=504 height=1", 1, 22, "x + width is at most 512; a frame that is to be refused"},
      {"mark", 1, 5, "expected 1 to 64 characters in quotes"},
      {"mark here", 1, 6, "name is a text in quotes, found \"here\""},
      {"mark \"here", 1, 6, "the quotes are not closed"},
      {"mark \"a\"b", 1, 8, "expected a blank after the quotes"},
      {"mark \"a\\n\"", 1, 8, "a backslash stands before"},
      {"mark \"\\x0a\"", 1, 6, "name is printable ASCII"},
      {"mark \"\tx\"", 1, 7, "only printable ASCII may stand in quotes"},
      {"mark \"\"", 1, 6, "expected 1 to 64 characters in quotes, found 0"},
      {"mark \"" + std::string(65, 'x') + "\"", 1, 6, "expected 1 to 64 characters in quotes, found 65"},
      {"pixels", 1, 7, "expected 1 to 1365 units of 6 hexadecimal digits"},
      {"pixels ff00", 1, 8, "expected 6 hexadecimal digits, found \"ff00\""},
      {"pixels 000000*1366", 1, 8, "with these there are more bytes"},
      {"lut channels=7 first=255 00 00", 1, 26, "expected 1 to 1 units of 2 hexadecimal digits, found 2"},
      {"lut channels=0 first=255 00", 1, 14, "channels is a number from 1 to 7"},
      {"cursor_pattern 00*31", 1, 16, "expected 32 to 32 units of 2 hexadecimal digits, found 31"},
      {".trace version=1", 1, 1, "unknown command \".trace\""},
      {std::string("\0\x01\xff", 3), 1, 1, "unknown command \"\\x00\\x01\\xff\""},
  };
  for (const Malformed& malformed : cases) {
    INFO(malformed.text);
    try {
      protocol::assemble(malformed.text, "t.txt");
      FAIL("accepted");
    } catch (const protocol::TextError& error) {
      CHECK(error.line == malformed.line);
      CHECK(error.column == malformed.column);
      CHECK_THAT(error.what(),
                 Catch::StartsWith("t.txt:" + std::to_string(malformed.line) + ":" +
                                   std::to_string(malformed.column) + ": " + malformed.problem));
      CHECK(std::string(error.what()).find('\n') == std::string::npos);
    }
  }
}
