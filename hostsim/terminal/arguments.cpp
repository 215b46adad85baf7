#include <halftone/terminal/arguments.h>

#include <CLI/CLI.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace halftone::terminal {

Option Option::required() {
  option_->required();
  return *this;
}

Option Option::check(const Check& check) {
  option_->check(CLI::Validator([check](std::string& text) { return check(text); }, std::string()));
  return *this;
}

Option Option::type_name(const std::string& name) {
  option_->type_name(name);
  return *this;
}

Arguments Arguments::add_subcommand(const std::string& name, const std::string& description) {
  return Arguments(*parser_->add_subcommand(name, description));
}

template<typename Value>
Option Arguments::add_option(const std::string& names, Value& value, const std::string& description) {
  return Option(*parser_->add_option(names, value, description));
}

template Option Arguments::add_option(const std::string&, std::string&, const std::string&);
template Option Arguments::add_option(const std::string&, std::vector<std::string>&, const std::string&);
template Option Arguments::add_option(const std::string&, std::uint16_t&, const std::string&);
template Option Arguments::add_option(const std::string&, int&, const std::string&);
template Option Arguments::add_option(const std::string&, double&, const std::string&);
template Option Arguments::add_option(const std::string&, std::uint64_t&, const std::string&);
template Option Arguments::add_option(const std::string&, std::optional<int>&, const std::string&);
template Option Arguments::add_option(const std::string&, std::optional<double>&, const std::string&);
template Option Arguments::add_option(const std::string&, std::optional<std::uint64_t>&, const std::string&);

void Arguments::add_flag(const std::string& names, bool& value, const std::string& description) {
  parser_->add_flag(names, value, description);
}

void Arguments::footer(const std::string& text) { parser_->footer(text); }

bool Arguments::parsed() const { return parser_->parsed(); }

} // namespace halftone::terminal
