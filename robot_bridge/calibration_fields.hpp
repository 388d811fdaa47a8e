#pragma once

// What reading and writing a calibration file have in common, and what the reader needs for any field.

#include "experiment/yaml_tree.hpp"
#include "science/robots/quadruped.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lamprey::robot_bridge {

/// By science::robots::Leg.
inline constexpr std::array<std::string_view, science::robots::legs> leg_names = {"front left", "front right",
                                                                                  "back left", "back right"};

using Names = std::vector<std::string_view>;

/// "a, b, c".
std::string joined(const Names& names);

/// The shortest text without an exponent that reads back to the same number.
std::string number_text(double number);

/// The finite number that a node is, if any.
std::optional<double> number_of(const experiment::YamlNode& node);

/// Reads values of fields, and collects what is wrong with them, each with its place. `field` is the path for messages.
class CalibrationFields {
 public:
  /// `problems`: those met before.
  CalibrationFields(std::string file, std::vector<experiment::Problem> problems)
      : file_(std::move(file)), problems_(std::move(problems)) {}

  void refuse(int line, int column, const std::string& field, std::string message);
  void refuse(const experiment::YamlNode& node, const std::string& field, std::string message) {
    refuse(node.line, node.column, field, std::move(message));
  }
  /// `what` is it that is unknown: a field, a joint. `holder` is the field around it, or empty.
  void refuse_unknown(const experiment::YamlEntry& entry, const std::string& holder, std::string_view what,
                      const Names& known);

  /// Throws experiment::InvalidInput with all problems in the order of the file, if there are any.
  void throw_if_any();

  // These return nothing, or false, after the node has been refused.

  bool is_mapping(const experiment::YamlNode& node, const std::string& field, const std::string& takes);
  std::optional<double> read_number(const experiment::YamlNode& node, const std::string& field, double lowest,
                                    double highest, const std::string& unit, bool whole);
  std::optional<std::int32_t> read_whole(const experiment::YamlNode& node, const std::string& field,
                                         std::int32_t lowest, std::int32_t highest);
  /// More than 0.
  std::optional<double> read_positive(const experiment::YamlNode& node, const std::string& field, double highest,
                                      const std::string& unit);
  /// The number of the name among `known`.
  std::optional<std::size_t> read_choice(const experiment::YamlNode& node, const std::string& field,
                                         const Names& known);

 private:
  std::string file_;
  std::vector<experiment::Problem> problems_;
};

}  // namespace lamprey::robot_bridge
