#include "support/scratch.h"

#include <halftone/recording/read.h>
#include <halftone/recording/text.h>
#include <halftone/recording/walk.h>
#include <halftone/recording/write.h>

#include <catch2/catch.hpp>

#include <iomanip>
#include <sstream>
#include <string>

using namespace halftone;
using device::Bytes;

namespace {

/// The n-th block of code in docs/trace-format.md.
std::string block(int n) {
  std::string text = test::contents(HALFTONE_SOURCE_DIR "/docs/trace-format.md");
  for (int fence = 0; fence < 2 * n + 1; ++fence) text.erase(0, text.find("```") + 3);
  text.erase(0, text.find('\n') + 1);
  return text.substr(0, text.find("```"));
}

/// The bytes of a dump: pairs of digits up to two blanks, and then words.
Bytes bytes_of(const std::string& dump) {
  Bytes bytes;
  std::istringstream lines(dump);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream pairs(line.substr(0, line.find("  ")));
    for (std::string pair; pairs >> pair;)
      bytes.push_back(static_cast<std::uint8_t>(std::stoi(pair, nullptr, 16)));
  }
  return bytes;
}

std::string hexadecimal(const Bytes& bytes) {
  std::ostringstream text;
  text << std::hex << std::uppercase << std::setfill('0');
  for (const std::uint8_t byte : bytes) text << std::setw(2) << int{byte} << ' ';
  return text.str();
}

} // namespace

TEST_CASE("the dump in docs/trace-format.md is the recording that the document says it is") {
  const Bytes dump = bytes_of(block(0));
  CHECK(hexadecimal(encode(recording::assemble(block(1)))) == hexadecimal(dump));
  CHECK(recording::disassemble(recording::read(dump, "dump")) == block(1));
  const recording::Trace trace = recording::read(dump, "dump");
  recording::Walk walk(trace, recording::States::compared);
  while (walk.next()) {
  }
  CHECK(!walk.departure());
  CHECK(walk.device().registers.commands == 1);
}
