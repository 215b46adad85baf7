#include <halftone/terminal/limits.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <sstream>
#include <string>
#include <system_error>

namespace halftone::terminal {

namespace {

std::string judged(bool good, const std::string& expected, const std::string& text) {
  return good ? std::string() : "expected " + expected + ", found " + text;
}

Check number(const std::string& expected, const std::function<bool(double)>& accepts) {
  return [expected, accepts](const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    const bool whole_text = !text.empty() && end == text.c_str() + text.size();
    return judged(whole_text && std::isfinite(value) && accepts(value), expected, text);
  };
}

} // namespace

Check whole(std::uint64_t least, std::uint64_t most) {
  const std::string expected = "a whole number from " + std::to_string(least) + " to " + std::to_string(most);
  return [=](const std::string& text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool good = error == std::errc() && end == text.data() + text.size() && value >= least &&
                      value <= most && (text.size() == 1 || text[0] != '0');
    return judged(good, expected, text);
  };
}

Check zero_or_more() {
  return number("a number that is 0 or more", [](double value) { return value >= 0; });
}

Check above_zero(double most) {
  std::ostringstream expected;
  expected << "a number above 0, up to " << most;
  return number(expected.str(), [most](double value) { return value > 0 && value <= most; });
}

Check one_of(const std::vector<std::string>& names) {
  return [names](const std::string& text) {
    return judged(std::ranges::find(names, text) != names.end(), alternatives(names), text);
  };
}

std::string alternatives(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i != 0) text += i + 1 == names.size() ? " or " : ", ";
    text += names[i];
  }
  return text;
}

} // namespace halftone::terminal
