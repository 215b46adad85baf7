#include "skip.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <optional>
#include <string>

namespace {

/// The environment of CI, or of somebody at home, for as long as it lives.
class Refusal {
public:
  explicit Refusal(const std::string& value) {
    if (const char* const old = std::getenv(name)) before_ = old;
    ::setenv(name, value.c_str(), 1);
  }
  ~Refusal() {
    if (before_)
      ::setenv(name, before_->c_str(), 1);
    else
      ::unsetenv(name);
  }
  Refusal(const Refusal&) = delete;
  Refusal& operator=(const Refusal&) = delete;

private:
  static constexpr const char* name = "HALFTONE_NO_SKIP";
  std::optional<std::string> before_;
};

} // namespace

TEST_CASE("a skip fails where none is allowed", "[!shouldfail]") {
  const Refusal refusal("1");
  halftone::test::skip("a trial of it");
}

TEST_CASE("a skip is said and no more where nothing is asked for") {
  const Refusal none("");
  halftone::test::skip("a trial of it");
}

TEST_CASE("what no machine can be asked for is a skip everywhere") {
  const Refusal refusal("1");
  halftone::test::skip_anywhere("a trial of it");
}
