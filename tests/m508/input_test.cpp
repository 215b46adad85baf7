#include "run.h"

#include <halftone/protocol/text.h>

#include <catch2/catch.hpp>

#include <filesystem>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace halftone;
using test::run_m508;
using test::Scratch;

TEST_CASE("a named pipe is read as a file is, such as that of a shell's <(command)") {
  const Scratch scratch;
  const std::string stream = test::as_text(protocol::assemble("clear\npixels 010203*500\n"));
  scratch.write("file", stream);
  const std::string pipe = scratch / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  std::thread writer([&] {
    const int end = ::open(pipe.c_str(), O_WRONLY | O_CLOEXEC); // waits for the reader
    const bool written = ::write(end, stream.data(), stream.size()) == static_cast<ssize_t>(stream.size());
    ::close(end);
    if (!written) std::filesystem::remove(scratch / "file");
  });
  const auto piped = run_m508(scratch, {"stats", "pipe", "--json"});
  const int late = ::open(pipe.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK); // if the program was none
  writer.join();
  ::close(late);
  CHECK(piped.exit_code == 0);
  CHECK(piped.out == run_m508(scratch, {"stats", "file", "--json"}).out);
}
