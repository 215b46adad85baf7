#include "junit.h"

#include <algorithm>
#include <sstream>
#include <string_view>

namespace halftone::m508 {

namespace {

/// For attributes. XML 1.0 has no place for control characters, however they are written; bytes above ASCII
/// come from TOML, which sees to it that they are UTF-8, or from a file's name, which nobody does.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
    }
  }
  for (const std::string_view barred : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"}) // U+FFFE, U+FFFF
    for (std::size_t at = result.find(barred); at != std::string::npos; at = result.find(barred, at))
      result.replace(at, barred.size(), "?");
  return result;
}

std::string in_ascii(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) > 0x7E; }, '?');
  return text;
}

} // namespace

std::string junit(const std::string& recording, const std::vector<inspect::Check>& checks,
                  const std::vector<inspect::Verdict>& verdicts) {
  const auto failures = std::ranges::count(verdicts, false, &inspect::Verdict::holds);
  const std::string suite = escaped(in_ascii(recording));
  std::ostringstream xml;
  const auto counts = [&](std::string_view element) {
    xml << '<' << element << " name=\"" << suite << "\" tests=\"" << verdicts.size() << "\" failures=\""
        << failures << "\" errors=\"0\">\n";
  };
  xml << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  counts("testsuites");
  counts("testsuite");
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    xml << "<testcase classname=\"" << suite << "\" name=\"" << escaped(checks[i].name) << '"';
    if (verdicts[i].holds)
      xml << "/>\n";
    else
      xml << ">\n<failure message=\"" << escaped(verdicts[i].message) << "\"/>\n</testcase>\n";
  }
  xml << "</testsuite>\n</testsuites>\n";
  return xml.str();
}

} // namespace halftone::m508
