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

/// The same where it may be negative.
CLI::Validator whole_number_between(std::int64_t minimum, std::int64_t maximum);

/// A number from minimum to maximum.
CLI::Validator number(double minimum, double maximum);

/// A share above 0 and up to 1, or a percentage above 0% and up to 100%: "0.05", "5%".
CLI::Validator share();

/// What such a text stands for.
double share_of(const std::string& text);

/// A robot's name.
CLI::Validator robot_name();

/// One of the names.
CLI::Validator one_of(std::vector<std::string_view> names);

/// "'plam' is not known; did you mean 'plan'?" or, where nothing is near, "…; known are a, b, c".
std::string unknown_name(std::string_view kind, std::string_view name, const std::vector<std::string_view>& known);

}  // namespace lamprey::client
