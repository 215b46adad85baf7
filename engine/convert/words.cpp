#include "words.h"

#include <array>
#include <charconv>

namespace halftone::convert {

std::string text(double number) {
  std::array<char, 40> buffer; // 17 digits, sign, point, exponent
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
  std::string digits(buffer.data(), end);
  if (digits.find_first_of(".e") == std::string::npos) digits += ".0";
  return digits;
}

std::string text(const core::Vec3& v, char open, char close) {
  return open + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + close;
}

} // namespace halftone::convert
