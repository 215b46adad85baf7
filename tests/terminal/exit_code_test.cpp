#include <halftone/core/error.h>
#include <halftone/file/write.h>
#include <halftone/link/link.h>
#include <halftone/png/png.h>
#include <halftone/terminal/exit_code.h>

#include <catch2/catch.hpp>

#include <sstream>
#include <stdexcept>
#include <string>

namespace terminal = halftone::terminal;

namespace {

struct Answer {
  int code = -1;
  std::string message;
};

template<class Error>
Answer answer_to(const Error& error) {
  std::ostringstream errors;
  const terminal::ExitCode code = terminal::guarded(
      "halftone", [&]() -> terminal::ExitCode { throw error; }, errors);
  return {static_cast<int>(code), errors.str()};
}

} // namespace

TEST_CASE("every kind of error has its exit code") {
  CHECK(answer_to(terminal::ArgumentError("x")).code == 2);
  CHECK(answer_to(halftone::core::InputError({"a.toml", 1, 2}, "x")).code == 3);
  CHECK(answer_to(halftone::png::ReadError("x")).code == 3);
  CHECK(answer_to(terminal::OutputError("x")).code == 4);
  CHECK(answer_to(halftone::file::WriteError("x")).code == 4);
  CHECK(answer_to(halftone::link::DeviceError("x")).code == 5);
  CHECK(answer_to(halftone::link::Timeout("x")).code == 6);
}

TEST_CASE("what a command answers is its exit code, without a message") {
  std::ostringstream errors;
  CHECK(terminal::guarded(
            "halftone", [] { return terminal::ExitCode::no; }, errors) == terminal::ExitCode::no);
  CHECK(terminal::guarded(
            "halftone", [] { return terminal::ExitCode::done; }, errors) == terminal::ExitCode::done);
  CHECK(errors.str().empty());
}

TEST_CASE("an error is one line that begins with the program's name") {
  CHECK(answer_to(halftone::link::Timeout("mem:: no answer within 10 s")).message ==
        "halftone: mem:: no answer within 10 s\n");
}

TEST_CASE("an exception that no room announces passes through as the bug that it is") {
  CHECK_THROWS_AS(answer_to(std::logic_error("x")), std::logic_error);
}
