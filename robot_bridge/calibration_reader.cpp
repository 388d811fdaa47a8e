// The calibration file's reader: docs/formats/calibration.md.

#include "experiment/field_reader.hpp"
#include "robot_bridge/calibration.hpp"
#include "robot_bridge/calibration_fields.hpp"
#include "science/problems/controlled_quadruped.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace lamprey::robot_bridge {

namespace {

using experiment::InvalidInput;
using experiment::kind_name;
using experiment::Problem;
using experiment::YamlEntry;
using experiment::YamlNode;
using Kind = YamlNode::Kind;

constexpr std::int32_t highest_dynamixel_id = 252;
constexpr double fastest_slew = 1e6;  // of any servo, in device units per second

/// What a device family takes.
struct Family {
  DeviceFamily family;
  std::vector<std::int32_t> bauds;  ///< none: of no meaning
  std::int32_t highest_channel;
  double lowest_device;
  double highest_device;
  std::string_view unit;
  bool whole_limits;  ///< the device takes whole numbers only
};

const std::vector<Family>& families() {
  static const std::vector<Family> rows = {{DeviceFamily::mock, {}, highest_dynamixel_id, -1e6, 1e6, "", false},
                                           {DeviceFamily::ssc32, {9600, 38400, 115200}, 31, 500, 2500, "µs", true},
                                           {DeviceFamily::dynamixel,
                                            {9600, 57600, 115200, 1000000, 2000000, 3000000, 4000000},
                                            highest_dynamixel_id,
                                            0,
                                            4095,
                                            "ticks",
                                            true}};
  return rows;
}

/// Where a field within another stands.
std::string path(const std::string& holder, const std::string& name) {
  return holder + "." + name;
}

class CalibrationReader {
 public:
  CalibrationReader(const std::string& file, std::vector<Problem> problems) : fields_(file, std::move(problems)) {}

  /// Throws all problems, those given included.
  Calibration read(const YamlNode& root) {
    if (root.kind != Kind::mapping) {
      fields_.refuse(root, "",
                     "a calibration is a mapping of driver, baud, joints and so on; this is " + kind_name(root));
    } else if (read_driver(root)) {
      read_fields(root);
    }
    fields_.throw_if_any();
    return calibration_;
  }

 private:
  bool read_driver(const YamlNode& root) {
    Names names;
    for (const auto& row : families()) names.push_back(to_text(row.family));
    const auto* node = root.find("driver");
    if (node == nullptr) {
      fields_.refuse(root, "driver", "is missing; it takes one of " + joined(names));
      return false;
    }
    const auto chosen = fields_.read_choice(*node, "driver", names);
    if (!chosen) return false;
    family_ = &families()[*chosen];
    calibration_.family = family_->family;
    if (family_->family == DeviceFamily::mock) calibration_ = mock_calibration();
    return true;
  }

  bool is_mock() const { return family_->family == DeviceFamily::mock; }
  bool is_dynamixel() const { return family_->family == DeviceFamily::dynamixel; }

  void read_fields(const YamlNode& root) {
    static const Names known = {"driver", "baud", "joints", "feet", "contact_board"};
    for (const auto& entry : root.entries) {
      if (entry.key == "baud") {
        read_baud(entry.value);
      } else if (entry.key == "joints") {
        read_joints(entry.value);
      } else if (entry.key == "feet") {
        read_feet(entry);
      } else if (entry.key == "contact_board") {
        read_board(entry);
      } else if (entry.key != "driver") {
        fields_.refuse_unknown(entry, "", "field", known);
      }
    }
    if (root.find("baud") == nullptr && !is_mock()) fields_.refuse(root, "baud", "is missing; " + takes_bauds());
    if (root.find("joints") == nullptr && !is_mock()) {
      fields_.refuse(root, "joints", "is missing; it takes all eight joints");
    }
    check_board(root);
  }

  std::string takes_bauds() const {
    std::string text;
    for (const auto baud : family_->bauds) text += (text.empty() ? "" : ", ") + std::to_string(baud);
    return "it takes one of " + text;
  }

  void read_baud(const YamlNode& node) {
    const auto& bauds = family_->bauds;
    if (bauds.empty()) {
      if (const auto baud = fields_.read_whole(node, "baud", 1, 100'000'000)) calibration_.baud = *baud;
      return;
    }
    const auto number = number_of(node);
    const auto found = std::ranges::find_if(bauds, [&](std::int32_t baud) { return number == double{1.0} * baud; });
    if (found == bauds.end())
      return fields_.refuse(node, "baud", kind_name(node) + " is not allowed; " + takes_bauds());
    calibration_.baud = *found;
  }

  void read_joints(const YamlNode& node) {
    const auto names = science::problems::servo_names();
    const Names known(names.begin(), names.end());
    if (!fields_.is_mapping(node, "joints", "joints, such as " + names[0])) return;
    std::set<std::string, std::less<>> told;
    for (const auto& entry : node.entries) {
      const auto found = std::ranges::find(known, entry.key);
      if (found != known.end()) {
        told.insert(entry.key);
        read_joint(entry.value, path("joints", entry.key), static_cast<std::size_t>(found - known.begin()));
      } else {
        // A name that is written wrong is not missing too.
        told.insert(experiment::nearest_name(entry.key, known));
        fields_.refuse_unknown(entry, "joints", "joint", known);
      }
    }
    for (const auto name : known) {
      if (!told.contains(name)) fields_.refuse(node, path("joints", std::string(name)), "is missing");
    }
  }

  void read_joint(const YamlNode& node, const std::string& field, std::size_t servo) {
    static const Names known = {"channel",  "minimum",   "centre", "maximum",
                                "per_unit", "direction", "offset", "slew_rate"};
    if (!fields_.is_mapping(node, field, joined(known))) return;
    Joint joint;
    std::set<std::string, std::less<>> good = {"direction", "offset"};
    for (const auto& entry : node.entries) {
      if (std::ranges::find(known, entry.key) == known.end()) {
        fields_.refuse_unknown(entry, field, "field", known);
      } else if (read_joint_field(entry, path(field, entry.key), joint)) {
        good.insert(entry.key);
      } else {
        good.erase(entry.key);
      }
    }
    for (const auto name : known) {
      const bool optional = name == "direction" || name == "offset";
      if (!optional && node.find(name) == nullptr) fields_.refuse(node, path(field, std::string(name)), "is missing");
    }
    check_order(node, field, joint, good);
    if (good.contains("channel")) check_channel(*node.find("channel"), path(field, "channel"), joint.channel);
    calibration_.joints[servo] = joint;
  }

  /// Whether the field's value is good.
  bool read_joint_field(const YamlEntry& entry, const std::string& field, Joint& joint) {
    const YamlNode& node = entry.value;
    const Family& row = *family_;
    const std::string unit = row.unit.empty() ? "" : " (" + std::string(row.unit) + ")";
    const std::string per_second = row.unit.empty() ? "" : " (" + std::string(row.unit) + " per second)";
    const double width = row.highest_device - row.lowest_device;
    const auto keep = [](const std::optional<double>& number, double& kept) {
      if (number) kept = *number;
      return number.has_value();
    };
    if (entry.key == "channel") {
      const auto channel = fields_.read_whole(node, field, 0, row.highest_channel);
      if (channel) joint.channel = *channel;
      return channel.has_value();
    }
    if (entry.key == "direction") {
      const auto direction = number_of(node);
      if (direction == 1.0 || direction == -1.0) {
        joint.direction = *direction > 0 ? 1 : -1;
        return true;
      }
      fields_.refuse(node, field, kind_name(node) + " is not allowed; it takes 1 or -1");
      return false;
    }
    const auto limit = [&](bool whole) {
      return fields_.read_number(node, field, row.lowest_device, row.highest_device, unit, whole);
    };
    if (entry.key == "minimum") return keep(limit(row.whole_limits), joint.minimum);
    if (entry.key == "maximum") return keep(limit(row.whole_limits), joint.maximum);
    if (entry.key == "centre") return keep(limit(false), joint.centre);
    if (entry.key == "offset") return keep(fields_.read_number(node, field, -width, width, unit, false), joint.offset);
    if (entry.key == "per_unit") return keep(fields_.read_positive(node, field, width, unit), joint.per_unit);
    return keep(fields_.read_positive(node, field, fastest_slew, per_second), joint.slew_rate);
  }

  /// The leg must be able to stand.
  void check_order(const YamlNode& node, const std::string& field, const Joint& joint,
                   const std::set<std::string, std::less<>>& good) {
    for (const auto name : {"minimum", "centre", "maximum", "offset"}) {
      if (!good.contains(name)) return;
    }
    const double standing = joint.centre + joint.offset;
    if (joint.minimum < standing && standing < joint.maximum) return;
    fields_.refuse(*node.find("centre"), path(field, "centre"),
                   "where the leg stands, centre + offset = " + number_text(standing) +
                       ", is not between minimum and maximum, " + number_text(joint.minimum) + " and " +
                       number_text(joint.maximum));
  }

  void check_channel(const YamlNode& node, const std::string& field, std::int32_t channel) {
    const auto [first, is_new] = channels_.try_emplace(channel, field, node.line);
    if (is_new) return;
    fields_.refuse(node, field,
                   "channel " + std::to_string(channel) + " is taken: " + first->second.first + " has it, in line " +
                       std::to_string(first->second.second));
  }

  void read_feet(const YamlEntry& feet) {
    if (is_mock()) return fields_.refuse(feet.line, feet.column, "feet", "the mock has no inputs; leave it out");
    if (!fields_.is_mapping(feet.value, "feet", "feet, such as front left")) return;
    const Names known(leg_names.begin(), leg_names.end());
    std::map<std::int32_t, std::string> taken;
    for (const auto& entry : feet.value.entries) {
      const auto found = std::ranges::find(known, entry.key);
      if (found == known.end()) {
        fields_.refuse_unknown(entry, "feet", "foot", known);
        continue;
      }
      const auto foot = read_foot(entry.value, path("feet", entry.key));
      if (!foot) continue;
      calibration_.feet[static_cast<std::size_t>(found - known.begin())] = foot;
      const auto [first, is_new] = taken.try_emplace(foot->channel, entry.key);
      if (!is_new) fields_.refuse(entry.value, path("feet", entry.key), "has the same input as " + first->second);
    }
  }

  std::optional<FootContact> read_foot(const YamlNode& node, const std::string& field) {
    static const Names inputs = {"A", "B", "C", "D", "E", "F"};
    static const Names levels = {"low", "high"};
    const std::string place_name = is_dynamixel() ? "bit" : "input";
    const Names known = {place_name, "closed"};
    if (!fields_.is_mapping(node, field, joined(known))) return std::nullopt;
    for (const auto& entry : node.entries) {
      if (std::ranges::find(known, entry.key) == known.end()) fields_.refuse_unknown(entry, field, "field", known);
    }
    FootContact foot;
    bool good = true;
    if (const auto* closed = node.find("closed")) {
      const auto level = fields_.read_choice(*closed, path(field, "closed"), levels);
      foot.closed_is_low = level == 0U;
      good = level.has_value();
    }
    const auto* place = node.find(place_name);
    if (place == nullptr) {
      fields_.refuse(node, path(field, place_name), "is missing");
      return std::nullopt;
    }
    std::optional<std::int32_t> channel;
    if (is_dynamixel()) {
      channel = fields_.read_whole(*place, path(field, place_name), 0, 7);
    } else if (const auto input = fields_.read_choice(*place, path(field, place_name), inputs)) {
      channel = static_cast<std::int32_t>(*input);
    }
    if (!channel || !good) return std::nullopt;
    foot.channel = *channel;
    return foot;
  }

  void read_board(const YamlEntry& board) {
    static const Names known = {"id", "address"};
    if (!is_dynamixel()) {
      return fields_.refuse(board.line, board.column, "contact_board", "only a dynamixel bus has one; leave it out");
    }
    if (!fields_.is_mapping(board.value, "contact_board", "id and address")) return;
    for (const auto& entry : board.value.entries) {
      if (std::ranges::find(known, entry.key) == known.end())
        fields_.refuse_unknown(entry, "contact_board", "field", known);
    }
    const auto number = [&](const std::string& name, std::int32_t highest) -> std::optional<std::int32_t> {
      const auto* node = board.value.find(name);
      if (node != nullptr) return fields_.read_whole(*node, path("contact_board", name), 0, highest);
      fields_.refuse(board.value, path("contact_board", name), "is missing");
      return std::nullopt;
    };
    const auto id = number("id", highest_dynamixel_id);
    const auto address = number("address", std::numeric_limits<std::uint16_t>::max());
    if (id && address) calibration_.contact_board = ContactBoard{.id = *id, .address = *address};
  }

  /// What joints, feet and board must be to each other, wherever they stand.
  void check_board(const YamlNode& root) {
    if (!is_dynamixel()) return;
    const auto* feet = root.find("feet");
    const auto* board = root.find("contact_board");
    if (feet != nullptr && board == nullptr) {
      fields_.refuse(*feet, "contact_board", "is missing; the feet's contacts are read from it");
    }
    if (const auto& read = calibration_.contact_board) {
      const auto joint = channels_.find(read->id);
      if (joint != channels_.end()) {
        fields_.refuse(*board->find("id"), "contact_board.id",
                       "id " + std::to_string(read->id) + " is taken: " + joint->second.first + " has it");
      }
    }
  }

  CalibrationFields fields_;
  const Family* family_ = nullptr;
  Calibration calibration_;
  std::map<std::int32_t, std::pair<std::string, int>> channels_;  ///< taken ones: the field, and its line
};

}  // namespace

DeviceNumbers device_numbers(DeviceFamily family) {
  const auto row = std::ranges::find(families(), family, &Family::family);
  return {.lowest = row->lowest_device, .highest = row->highest_device};
}

Calibration parse_calibration(const std::string& text, const std::string& file) {
  std::vector<Problem> problems;
  const YamlNode root = experiment::parse_yaml(text, file, problems);
  return CalibrationReader(file, std::move(problems)).read(root);
}

Calibration read_calibration(const std::string& path) {
  return parse_calibration(experiment::read_yaml_text(path), path);
}

}  // namespace lamprey::robot_bridge
