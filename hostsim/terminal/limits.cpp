#include <halftone/terminal/limits.h>

#include <charconv>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <system_error>

namespace halftone::terminal {

namespace {

CLI::Validator number(const std::string& expected, const std::function<bool(double)>& accepts) {
  return {[expected, accepts](std::string& text) {
            double value = 0;
            const bool good =
                CLI::detail::lexical_cast(text, value) && std::isfinite(value) && accepts(value);
            return good ? std::string() : "expected " + expected + ", found " + text;
          },
          std::string()};
}

} // namespace

CLI::Validator whole(std::uint64_t least, std::uint64_t most) {
  const std::string expected = "a whole number from " + std::to_string(least) + " to " + std::to_string(most);
  return {[=](std::string& text) {
            std::uint64_t value = 0;
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
            const bool good = error == std::errc() && end == text.data() + text.size() && value >= least &&
                              value <= most && (text.size() == 1 || text[0] != '0');
            return good ? std::string() : "expected " + expected + ", found " + text;
          },
          std::string()};
}

CLI::Validator zero_or_more() {
  return number("a number that is 0 or more", [](double value) { return value >= 0; });
}

CLI::Validator above_zero(double most) {
  std::ostringstream expected;
  expected << "a number above 0, up to " << most;
  return number(expected.str(), [most](double value) { return value > 0 && value <= most; });
}

} // namespace halftone::terminal
