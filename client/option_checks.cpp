#include "client/option_checks.hpp"

#include "client/output/formatting.hpp"
#include "experiment/problem.hpp"
#include "messaging/robot/robot_name.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

namespace lamprey::client {

namespace {

template <typename Number>
std::optional<Number> read(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

CLI::Validator whole_number(std::uint64_t minimum, std::uint64_t maximum) {
  const std::string range = maximum == std::numeric_limits<std::uint64_t>::max()
                                ? "from " + std::to_string(minimum) + " on"
                                : "from " + std::to_string(minimum) + " to " + std::to_string(maximum);
  return {[=](const std::string& text) -> std::string {
            const auto value = read<std::uint64_t>(text);
            if (value && *value >= minimum && *value <= maximum) return {};
            return "takes a whole number " + range + ", not '" + experiment::printable(text) + "'";
          },
          ""};
}

CLI::Validator whole_number_between(std::int64_t minimum, std::int64_t maximum) {
  return {[=](const std::string& text) -> std::string {
            const auto value = read<std::int64_t>(text);
            if (value && *value >= minimum && *value <= maximum) return {};
            return "takes a whole number from " + std::to_string(minimum) + " to " + std::to_string(maximum) +
                   ", not '" + experiment::printable(text) + "'";
          },
          ""};
}

CLI::Validator share() {
  return {[](const std::string& text) -> std::string {
            const double value = share_of(text);
            if (value > 0 && value <= 1) return {};
            return "takes a share above 0 and up to 1, or a percentage such as 5%, not '" +
                   experiment::printable(text) + "'";
          },
          ""};
}

double share_of(const std::string& text) {
  const bool percentage = text.ends_with('%');
  const auto value = read<double>(std::string_view(text).substr(0, text.size() - (percentage ? 1 : 0)));
  if (!value) return 0;
  return percentage ? *value / 100 : *value;
}

CLI::Validator number(double minimum, double maximum) {
  const std::string range = "from " + output::shortest(minimum) + " to " + output::shortest(maximum);
  return {[=](const std::string& text) -> std::string {
            const auto value = read<double>(text);
            if (value && *value >= minimum && *value <= maximum) return {};
            return "takes a number " + range + ", not '" + experiment::printable(text) + "'";
          },
          ""};
}

CLI::Validator robot_name() {
  return CLI::Validator(
      [](std::string& name) -> std::string {
        return messaging::is_valid_robot(name) ? "" : "'" + name + "' is no robot's name: 1 to 64 of A-Z a-z 0-9 _ . -";
      },
      "");
}

CLI::Validator one_of(std::vector<std::string_view> names) {
  return {[names = std::move(names)](const std::string& text) -> std::string {
            if (std::ranges::find(names, text) != names.end()) return {};
            std::vector<std::string> all(names.begin(), names.end());
            std::string message =
                "takes one of " + output::joined(all, ", ") + ", not '" + experiment::printable(text) + "'";
            if (const auto nearest = experiment::nearest_name(text, names); !nearest.empty()) {
              message += "; did you mean '" + nearest + "'?";
            }
            return message;
          },
          ""};
}

std::string unknown_name(std::string_view kind, std::string_view name, const std::vector<std::string_view>& known) {
  std::string message = "unknown " + std::string(kind) + " '" + experiment::printable(name) + "'";
  if (const auto nearest = experiment::nearest_name(name, known); !nearest.empty()) {
    return message + "; did you mean '" + nearest + "'?";
  }
  return message + "; known are " + output::joined({known.begin(), known.end()}, ", ");
}

}  // namespace lamprey::client
