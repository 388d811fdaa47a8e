#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// What the values of options must be; the messages say the value, the range and the nearest name.
namespace lamprey::client {

/// A whole number from minimum to maximum.
CLI::Validator whole_number(std::uint64_t minimum, std::uint64_t maximum);

/// A number from minimum to maximum.
CLI::Validator number(double minimum, double maximum);

/// One of the names.
CLI::Validator one_of(std::vector<std::string_view> names);

/// "'plam' is not known; did you mean 'plan'?" or, where nothing is near, "…; known are a, b, c".
std::string unknown_name(std::string_view kind, std::string_view name, const std::vector<std::string_view>& known);

}  // namespace lamprey::client
