#include <halftone/protocol/text.h>
#include <halftone/recording/text.h>
#include <halftone/recording/write.h>

#include <catch2/catch.hpp>

#include <string>

using namespace halftone;
using recording::assemble;
using recording::disassemble;

namespace {

const std::string head = ".trace version=1 profile=0 bus=\"b\" byte_picoseconds=1 frame_picoseconds=2\n";

} // namespace

TEST_CASE("data that end with an item have no size, others stand before the items they share") {
  const std::string text = head + ".begin \"me\"\n"
                                  ".data\n#1 clear\n#2 clear\n"
                                  ".state commands=2 checksum=99\n"
                                  ".data 0\n"
                                  ".data 5\n.state commands=2 checksum=99\n.data 8\n#3 clear\n"
                                  ".data\n#4 mark \"x\"\n"
                                  ".end \"closed\"\n"
                                  ".restart\n"
                                  ".cut_off 0100\n";
  const recording::Trace trace = assemble(text);
  CHECK(disassemble(trace) == text);
  CHECK(trace.records.size() == 10);
}

TEST_CASE("a recording written by hand needs no directives but the first") {
  const recording::Trace trace = assemble("; by hand\n" + head + "clear\nclear");
  CHECK(!trace.raw);
  CHECK(disassemble(trace) == head + ".data\n#1 clear\n#2 clear\n");
}

TEST_CASE("directives that are wrong are refused with their place and advice") {
  struct Malformed {
    std::string text;
    int line;
    std::string problem;
  };
  const Malformed cases[] = {
      {".begin \"x\"", 1, "only recordings have directives"},
      {"clear\n" + head, 2, "\".trace\" is the first line that is not empty"},
      {head + head, 2, "\".trace\" is the first line that is not empty"},
      {".trace version=2", 1, "version is a number from 1 to 1"},
      {".trace version=1 profile=1", 1, "profile is a number from 0 to 0"},
      {".trace version=1 profile=0 bus=b", 1, "bus is a text in quotes"},
      {".trace version=1 profile=0 bus=\"" + std::string(256, 'x') + "\"", 1,
       "the name of a bus has at most"},
      {".trace version=1 profile=0", 1, "expected bus=..., and the line ends here"},
      {head + ".begun \"x\"", 2, "unknown directive \".begun\"; known are"},
      {head + ".begin x", 2, "the peer is a text in quotes"},
      {head + ".data 5\n#1 clear", 2, "the items up to the next directive have 8 bytes more"},
      {head + ".data 5\n.data 9\n#1 clear", 3, "the items up to the next directive have too few bytes"},
      {head + ".data 5\n.begin \"x\"", 2, "the items up to the next directive have too few bytes"},
      {head + ".data 5\n.restart\n#1 clear", 2, "the items up to the next directive have too few bytes"},
      {head + ".data 5\n.data\nclear", 3, "\".data\" without a size stands alone"},
      {head + ".data 9999999", 2, "the size of data is a number from 0 to 1048576"},
      {head + ".begin \"x\"\n.snapshot 00", 3, "\".snapshot\" comes before the records"},
      {head + ".snapshot 00", 2, "the initial state cannot be unpacked"},
      {head + ".snapshot 0", 2, "expected bytes as hexadecimal digits"},
      {head + ".snapshot", 2, "expected bytes as hexadecimal digits"},
      {head + ".cut_off 00\nclear", 3, "nothing comes after \".cut_off\""},
      {head + ".cut_off 00\n.data 0", 3, "nothing comes after \".cut_off\""},
      {head + ".cut_off *3", 2, "expected bytes as hexadecimal digits"},
      {head + ".state commands=1", 2, "expected checksum=..."},
      {head + ".data\nclera", 3, "unknown command \"clera\"; did you mean \"clear\"?"},
  };
  for (const Malformed& malformed : cases) {
    INFO(malformed.text);
    try {
      assemble(malformed.text, "t.txt");
      FAIL("accepted");
    } catch (const protocol::TextError& error) {
      CHECK(error.line == malformed.line);
      CHECK_THAT(error.what(), Catch::StartsWith("t.txt:" + std::to_string(malformed.line) + ":"));
      CHECK_THAT(error.what(), Catch::Contains(": " + malformed.problem));
    }
  }
}

TEST_CASE("more data than a record holds need a second one") {
  std::string text = head;
  for (int i = 0; i < 17; ++i) text += "zeros 65536\n";
  CHECK_THROWS_WITH(assemble(text), Catch::Contains("put a \".data\" in between"));
}
