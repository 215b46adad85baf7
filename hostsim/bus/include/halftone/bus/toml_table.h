#pragma once
// Tables of a TOML file, taken key by key, with errors that tell the place and what would be right.

#include <toml++/toml.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halftone::bus {

/// Parses a file. Throws core::InputError.
toml::table parse_toml(std::string_view text, const std::string& file);

[[noreturn]] void fail(const std::string& file, const toml::node& at, const std::string& problem,
                       const std::string& advice = {});

/// An integer from least to most; `what` names it.
std::uint32_t integer(const std::string& file, const toml::node& node, const std::string& what,
                      std::uint32_t least, std::uint32_t most);

/// An array of as many integers as `least` has, each between least and most.
std::vector<std::uint32_t> integers(const std::string& file, const toml::node& node, const std::string& what,
                                    const std::vector<std::uint32_t>& least,
                                    const std::vector<std::uint32_t>& most);

/// A finite number from least to most, which are whole.
double number(const std::string& file, const toml::node& node, const std::string& what, double least,
              double most);

std::string text(const std::string& file, const toml::node& node, const std::string& what);

/// Throws where a key is none of these.
void require_known_keys(const std::string& file, const toml::table& table, const std::string& what,
                        const std::vector<std::string_view>& known);

} // namespace halftone::bus
