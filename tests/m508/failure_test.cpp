#include "run.h"

#include <halftone/protocol/text.h>
#include <halftone/recording/write.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>

using namespace halftone;
using test::run_m508;
using test::Scratch;

namespace {

/// Files that the calls below may name; a call that fails leaves no others.
void fill(const Scratch& scratch) {
  scratch.write("good.txt", "clear\nmark \"here\"\n");
  scratch.write("good", test::as_text(protocol::assemble("clear\nmark \"here\"\n")));
  scratch.write("bad.txt", "clear\nwindow x=1 y=2 widht=3 height=4\n");
  auto damaged = encode(recording::Header{});
  scratch.write("good.m508", test::as_text(damaged));
  damaged.back() ^= 1;
  scratch.write("bad.m508", test::as_text(damaged));
  scratch.write("good-00000001.png", test::as_text(protocol::assemble("clear\n")));
  std::filesystem::create_symlink("good-00000001.png", scratch / "link");
  scratch.write("bus.toml", "[[bus]]\nname = \"x\"\n");
  scratch.write("bad.toml", "[[bus]]\nname = \"x\"\nbyte_per_second = 3\n");
}

struct Failure {
  std::vector<std::string> arguments;
  int exit_code;
  std::string message; ///< after "m508: "
};

} // namespace

TEST_CASE("what fails exits with its code, one line on stderr, nothing on stdout and no file") {
  const Failure failures[] = {
      {{}, 2, "a command is needed: serve, replay"},
      {{"play"}, 2, ""},
      {{"asm", "good.txt"}, 2, ""},
      {{"asm", "good.txt", "-o", "good.txt"}, 2, "-o good.txt: is an input, which would be lost"},
      {{"disasm", "good", "-o", "./good"}, 2, "-o ./good: is an input"},
      {{"disasm", "good.m508", "--replies"}, 2, "--replies: a recording holds commands"},
      {{"replay"}, 2, ""},
      {{"replay", "good", "--until", "x"}, 2, "--until: expected a command's number, mark:NAME or frame:N"},
      {{"replay", "good", "--until", "-1"}, 2, ""},
      {{"replay", "good", "--until", "frame:"}, 2, "--until: expected a command's number"},
      {{"replay", "good", "--until", "3"}, 2, "--until 3: the recording ends before, after command 2"},
      {{"replay", "good", "--until", "mark:there"}, 2, "--until mark:there: the recording ends before"},
      {{"replay", "good", "--until", "frame:9"}, 2, "--until frame:9: the recording ends before"},
      {{"replay", "good", "--each", "0", "-o", "x.png"}, 2, ""},
      {{"replay", "good", "--each", "-1", "-o", "x.png"}, 2, "--each: expected a whole number from 1 to "},
      {{"replay", "good", "--each", "010", "-o", "x.png"}, 2, "--each: expected a whole number from 1 to "},
      {{"who", "good", "010", "0"}, 2, "X: expected a whole number from 0 to 511, found 010"},
      {{"replay", "good", "--each", "1"}, 2, "--each: needs -o OUT.png"},
      {{"replay", "good", "--as", "seen", "-o", "x.png"}, 2, ""},
      {{"replay", "good", "--bus", "gpbi"}, 2, "--bus: unknown bus \"gpbi\"; known are rs232, gpib"},
      {{"replay", "good", "--buses", "bad.toml"}, 2, "--buses: needs --bus NAME"},
      {{"replay", "good", "-o", "good"}, 2, "-o good: is an input"},
      {{"replay", "good-00000001.png", "-o", "good.png", "--each", "1"},
       2,
       "--each good-00000001.png: is an"},
      {{"replay", "link", "-o", "good.png", "--each", "1"}, 2, "--each good-00000001.png: is an input"},
      {{"replay", "good", "--bus", "x", "--buses", "bus.toml", "-o", "bus.toml"}, 2, "-o bus.toml: is an"},
      {{"diff", "-", "-"}, 2, "standard input can be read once; save one of the inputs called - to a file"},
      {{"assert", "-", "-"}, 2, "standard input can be read once"},
      {{"stats", "-", "--buses", "-"}, 2, "standard input can be read once"},
      {{"replay", "nothing"}, 3, "nothing: No such file or directory"},
      {{"replay", "."}, 3, ".: is a folder"},
      {{"replay", "/proc/self/mem"}, 3, "/proc/self/mem: Input/output error"},
      {{"lint", "/dev/zero"}, 3, "/dev/zero: is no regular file, and has more than 256 MB; "},
      {{"replay", "bad.m508"}, 3, "bad.m508: byte 0: the checksum of the header is wrong"},
      {{"stats", "bad.m508"}, 3, "bad.m508: byte 0: the checksum of the header is wrong"},
      {{"disasm", "bad.m508"}, 3, "bad.m508: byte 0: the checksum of the header is wrong"},
      {{"asm", "bad.txt", "-o", "x"},
       3,
       "bad.txt:2:16: unknown operand \"widht\" of window; did you mean \"width\"?"},
      {{"asm", "nothing", "-o", "x"}, 3, "nothing: No such file"},
      {{"stats", "good", "--buses", "bad.toml"}, 3, "bad.toml:3:1: unknown key \"byte_per_second\" in bus"},
      {{"replay", "good", "--bus", "x", "--buses", "bad.toml"}, 3, "bad.toml:3:1: unknown key"},
      {{"stats", "good", "--buses", "nothing"}, 3, "nothing: No such file"},
      {{"asm", "good.txt", "-o", "no/x"}, 4, "no/x: cannot be written: the folder no does not exist"},
      {{"disasm", "good", "-o", "."}, 4, ".: cannot be written"},
      {{"replay", "good", "-o", "no/x.png"}, 4, "no/x.png: cannot be written"},
  };
  const Scratch scratch;
  fill(scratch);
  const auto names = scratch.names();
  for (const Failure& failure : failures) {
    const auto outcome = run_m508(scratch, failure.arguments);
    std::string call = "m508";
    for (const std::string& word : failure.arguments) call += " " + word;
    INFO(call << "\n" << outcome.err);
    CHECK(outcome.exit_code == failure.exit_code);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.starts_with("m508: " + failure.message));
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK(scratch.names() == names);
  }
}

TEST_CASE("the help of every command goes to stdout and has an example") {
  const Scratch scratch;
  for (const std::string command :
       {"serve", "replay", "who", "diff", "lint", "assert", "stats", "disasm", "asm"}) {
    const auto outcome = run_m508(scratch, {command, "--help"});
    INFO(outcome.out);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    CHECK(outcome.out.find("Example:\n  m508 " + command) != std::string::npos);
  }
}
