#include "experiment/grid_reader.hpp"

#include "experiment/axis_sample.hpp"
#include "experiment/grid_expansion.hpp"
#include "experiment/sweep_validation.hpp"
#include "experiment/typed_value.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace lamprey::experiment {

namespace {

using Kind = YamlNode::Kind;

constexpr std::string_view zip_key = "zip";

/// The parameter that an axis names. An unknown name is looked for at the name, as is all else about an axis.
const Parameter* place_axis(FieldReader& fields, const std::string& path, const YamlEntry& entry) {
  fields.place_key(path, entry);
  return find_parameter(entry.key);
}

/// Reads a list, or a single value that stands for a list of one. `path`: of the axis, whose values' paths follow.
void read_values(FieldReader& fields, const std::string& path, const YamlNode& node, const Parameter* parameter,
                 idl::Axis& axis) {
  const auto read = [&](std::size_t i, const YamlNode& value) {
    fields.place(value_path(path, i), value);
    fields.read_value(value_path(path, i), value, parameter, *axis.add_values());
  };
  if (node.kind != Kind::list) return read(0, node);
  for (std::size_t i = 0; i < node.items.size(); ++i) read(i, node.items[i]);
}

/// Reads a part of a range; false if the entry is none.
bool read_range_part(FieldReader& fields, const std::string& path, const YamlEntry& entry, const Parameter* parameter,
                     idl::Axis& axis) {
  const auto read = [&](idl::Value& value) {
    fields.place(path, entry.value);
    fields.read_value(path, entry.value, parameter, value);
    return true;
  };
  if (entry.key == "from") return read(*axis.mutable_range()->mutable_from());
  if (entry.key == "to") return read(*axis.mutable_range()->mutable_to());
  if (entry.key == "step") return read(*axis.mutable_range()->mutable_step());
  return false;
}

void read_range(FieldReader& fields, const std::string& path, const YamlNode& node, const Parameter* parameter,
                idl::Axis& axis) {
  axis.mutable_range();
  for (const auto& entry : node.entries) {
    const std::string part = path + "." + printable(entry.key);
    if (read_range_part(fields, part, entry, parameter, axis)) continue;
    fields.place_key(part, entry);
    fields.refuse(part, "a range has from, to and step" + nearest_hint(entry.key, {"from", "to", "step", "where"}));
  }
}

/// A number as a specification has it.
idl::Value idl_value(const Value& number) {
  idl::Value value;
  if (const auto* whole = std::get_if<std::int64_t>(&number)) {
    value.set_integer(*whole);
  } else {
    value.set_real(std::get<double>(number));
  }
  return value;
}

/// A grid in which axes advance together or apply in a part of it only. Every value of a list is bound to the registry
/// here, since it must be told from the others; what else can be wrong with axes is left to the validator.
class ComposedGridReader {
 public:
  /// `room`: how many values samples may still have.
  ComposedGridReader(FieldReader& fields, std::string path, std::uint64_t seed, std::uint64_t& room)
      : fields_(fields), path_(std::move(path)), seed_(seed), room_(room) {}

  std::vector<GridPart> read(const YamlNode& node) {
    for (const auto& entry : node.entries) later_.insert(entry.key);
    for (const auto& entry : node.entries) {
      if (fields_.full()) break;
      later_.erase(entry.key);
      if (entry.key == zip_key) {
        read_zip(entry);
      } else {
        read_axis(entry);
      }
    }
    return std::move(parts_);
  }

 private:
  void read_axis(const YamlEntry& entry) {
    const std::string path = axis_path(path_, entry.key);
    const Parameter* parameter = place_axis(fields_, path, entry);
    if (parameter == nullptr) return fields_.refuse(path, unknown_parameter(entry.key));
    if (!named_once(path, *parameter, "is in this grid's zip too; keep one of them")) return;
    ComposedAxis axis;
    axis.axis.set_parameter(entry.key);
    if (entry.value.kind == Kind::mapping) {
      read_parts(path, entry.value, *parameter, axis);
    } else {
      read_list(path, entry.value, *parameter, axis);
      check_unique(path, axis, "in this axis");
    }
    if (!fields_.any_refused_within(path)) add({.columns = {std::move(axis)}, .zipped = false});
  }

  /// values, or from, to and step, or sample, from and to; and where.
  void read_parts(const std::string& path, const YamlNode& node, const Parameter& parameter, ComposedAxis& axis) {
    const YamlNode* sample = node.find("sample");
    const bool has_values = node.find("values") != nullptr;
    for (const auto& entry : node.entries) {
      const std::string part = path + "." + printable(entry.key);
      fields_.place(part, entry.value);
      if (entry.key == "values") {
        read_list(part, entry.value, parameter, axis);
        check_unique(part, axis, "in this axis");
      } else if (entry.key == "where") {
        read_where(part, entry.value, parameter, axis);
      } else if (entry.key != "sample" && !read_range_part(fields_, part, entry, &parameter, axis.axis)) {
        fields_.place_key(part, entry);
        fields_.refuse(part, "an axis has values; or from, to and step; or sample, from and to; and perhaps where" +
                                 nearest_hint(entry.key, {"values", "sample", "from", "to", "step", "where"}));
      }
    }
    if (has_values && (axis.axis.has_range() || sample != nullptr)) {
      fields_.refuse(path, "has both values and a range; keep one of them");
    } else if (sample != nullptr) {
      draw_sample(path, *sample, parameter, axis);
    } else if (!has_values && !axis.axis.has_range()) {
      fields_.refuse(path, "has no values: " + std::string(parameter.name) + " takes " + allowed_values(parameter));
    }
  }

  /// Puts a sample's values where its range is.
  void draw_sample(const std::string& path, const YamlNode& count_node, const Parameter& parameter,
                   ComposedAxis& axis) {
    if (!is_number(parameter.kind)) {
      return fields_.refuse(
          path, "a sample needs numbers: " + std::string(parameter.name) + " takes " + allowed_values(parameter));
    }
    const auto& range = axis.axis.range();
    if (range.has_step()) fields_.refuse(path + ".step", "a sample has no step; keep step or sample");
    const auto count = count_node.quoted ? idl::Value() : value_of_text(ParameterKind::integer, count_node.text);
    if (count.kind_case() != idl::Value::kInteger || count.integer() < 1 ||
        static_cast<std::uint64_t>(count.integer()) > room_) {
      fields_.refuse(path + ".sample", kind_name(count_node) + " is not allowed: sample takes a whole number from 1; " +
                                           "the axes of a sweep hold at most " + std::to_string(maximum_axis_values) +
                                           " values together");
    }
    const auto from = bound(path + ".from", parameter, range.from());
    const auto to = bound(path + ".to", parameter, range.to());
    if (fields_.any_refused_within(path)) return;
    if (*from > *to) {
      return fields_.refuse(
          path, "the range goes from " + to_text(*from) + " down to " + to_text(*to) + "; from must not be above to");
    }
    const auto wanted = static_cast<std::uint64_t>(count.integer());
    const auto values = axis_sample(parameter, seed_, wanted, *from, *to);
    if (!values) {
      return fields_.refuse(path + ".sample", "there are not " + std::to_string(wanted) + " different values from " +
                                                  to_text(*from) + " to " + to_text(*to));
    }
    room_ -= wanted;
    axis.axis.clear_range();
    axis.values = *values;
    for (const auto& value : *values) *axis.axis.add_values() = idl_value(value);
  }

  void read_list(const std::string& path, const YamlNode& node, const Parameter& parameter, ComposedAxis& axis) {
    if (node.kind == Kind::mapping) return fields_.refuse(path, "takes a list of values; this is a mapping");
    if (node.kind == Kind::list && node.items.empty()) {
      return fields_.refuse(path,
                            "has no values: " + std::string(parameter.name) + " takes " + allowed_values(parameter));
    }
    read_values(fields_, path, node, &parameter, axis.axis);
    for (int i = 0; i < axis.axis.values_size(); ++i) {
      if (const auto value = bound(value_path(path, static_cast<std::size_t>(i)), parameter, axis.axis.values(i))) {
        axis.values.push_back(*value);
      }
    }
  }

  std::optional<Value> bound(const std::string& path, const Parameter& parameter, const idl::Value& value) {
    // What is no single value has been refused when it was read.
    if (value.kind_case() == idl::Value::KIND_NOT_SET && fields_.any_refused_within(path)) return std::nullopt;
    auto typed = typed_value(parameter, value);
    if (auto* sound = std::get_if<Value>(&typed)) return std::move(*sound);
    fields_.refuse(path, std::get<Refusal>(typed).reason);
    return std::nullopt;
  }

  void check_unique(const std::string& path, const ComposedAxis& axis, std::string_view where) {
    std::set<Value> seen;
    for (std::size_t i = 0; i < axis.values.size(); ++i) {
      if (!seen.insert(axis.values[i]).second) {
        fields_.refuse(value_path(path, i), to_text(axis.values[i]) + " is " + std::string(where) + " twice");
      }
    }
  }

  bool named_once(const std::string& path, const Parameter& parameter, std::string message) {
    if (names_.insert(parameter.name).second) return true;
    fields_.refuse(path, std::move(message));
    return false;
  }

  void add(GridPart part) {
    parts_.push_back(std::move(part));
    for (const auto& column : parts_.back().columns) known_.emplace(column.axis.parameter(), column);
  }

  // ---- where

  void read_where(const std::string& path, const YamlNode& node, const Parameter& parameter, ComposedAxis& axis) {
    if (node.kind != Kind::mapping) {
      return fields_.refuse(
          path,
          "takes a mapping of axes that stand before this one to some of their values; this is " + kind_name(node));
    }
    if (node.entries.empty()) return fields_.refuse(path, "names no axis; leave it out");
    for (const auto& entry : node.entries) {
      const std::string part = axis_path(path, entry.key);
      fields_.place_key(part, entry);
      if (const auto* referred = referred_axis(part, entry.key, parameter)) {
        axis.where.push_back({.parameter = entry.key, .values = values_of_where(part, entry.value, *referred)});
      }
    }
  }

  /// The axis that a `where` names, or nullptr after it has been noted why there is none.
  const ComposedAxis* referred_axis(const std::string& path, const std::string& name, const Parameter& parameter) {
    const auto found = known_.find(name);
    if (found != known_.end() && !found->second.axis.has_range()) return &found->second;
    if (found != known_.end()) {
      fields_.refuse(path, "is a range; write its values as a list for `where` to tell them apart");
    } else if (find_parameter(name) == nullptr) {
      fields_.refuse(path, unknown_parameter(name));
    } else if (name == parameter.name) {
      fields_.refuse(path, "is this axis itself; `where` names axes that stand before it");
    } else if (later_.contains(name)) {
      fields_.refuse(path, "stands after " + std::string(parameter.name) + " in this grid; put it before");
    } else if (!names_.contains(name)) {
      fields_.refuse(path, "is no axis of this grid");
    }
    return nullptr;
  }

  std::vector<Value> values_of_where(const std::string& path, const YamlNode& node, const ComposedAxis& referred) {
    const Parameter& parameter = *find_parameter(referred.axis.parameter());
    ComposedAxis asked;
    read_list(path, node, parameter, asked);
    check_unique(path, asked, "named");
    auto known = referred.values;
    std::ranges::sort(known);
    for (std::size_t i = 0; i < asked.values.size() && !fields_.full(); ++i) {
      if (std::ranges::binary_search(known, asked.values[i])) continue;
      fields_.refuse(value_path(path, i), to_text(asked.values[i]) + " is not in this grid's axis of " +
                                              std::string(parameter.name) + "; add it there, or leave it out");
    }
    std::ranges::sort(asked.values);
    return asked.values;
  }

  // ---- zip

  void read_zip(const YamlEntry& entry) {
    const std::string path = axis_path(path_, zip_key);
    fields_.place(path, entry.value);
    if (entry.value.kind != Kind::mapping) {
      return fields_.refuse(
          path, "takes a mapping of parameters to lists of equal length; this is " + kind_name(entry.value));
    }
    if (entry.value.entries.empty()) return fields_.refuse(path, "has no parameters; leave it out");
    GridPart zip{.columns = {}, .zipped = true};
    for (const auto& column : entry.value.entries) read_column(path, column, zip);
    if (zip.columns.empty() || fields_.any_refused_within(path)) return;
    check_rows(path, zip);
    add(std::move(zip));
  }

  void read_column(const std::string& zip_path, const YamlEntry& entry, GridPart& zip) {
    const std::string path = axis_path(zip_path, entry.key);
    const Parameter* parameter = place_axis(fields_, path, entry);
    if (parameter == nullptr) return fields_.refuse(path, unknown_parameter(entry.key));
    // What the validator has to say about the axis is found at the column.
    fields_.place_key(axis_path(path_, entry.key), entry);
    if (!named_once(path, *parameter, "is an axis of this grid too; keep one of them")) return;
    if (entry.value.kind != Kind::list) {
      return fields_.refuse(path, "takes a list as long as the others of the zip; this is " + kind_name(entry.value));
    }
    ComposedAxis column;
    column.axis.set_parameter(entry.key);
    read_list(path, entry.value, *parameter, column);
    if (!zip.columns.empty() && column.axis.values_size() != zip.columns.front().axis.values_size()) {
      const auto& first = zip.columns.front().axis;
      return fields_.refuse(path, "has " + count(column.axis) + ", but " + first.parameter() + " has " + count(first) +
                                      ": the lists of a zip advance together");
    }
    zip.columns.push_back(std::move(column));
  }

  static std::string count(const idl::Axis& axis) {
    return std::to_string(axis.values_size()) + (axis.values_size() == 1 ? " value" : " values");
  }

  void check_rows(const std::string& path, const GridPart& zip) {
    std::set<std::vector<Value>> seen;
    for (std::size_t row = 0; row < zip.columns.front().values.size(); ++row) {
      std::vector<Value> values;
      std::string text;
      for (const auto& column : zip.columns) {
        values.push_back(column.values[row]);
        text += (text.empty() ? "" : ", ") + setting_text(*find_parameter(column.axis.parameter()), values.back());
      }
      if (seen.insert(std::move(values)).second) continue;
      fields_.refuse(value_path(axis_path(path, zip.columns.front().axis.parameter()), row),
                     "the zip has " + text + " twice");
    }
  }

  FieldReader& fields_;
  std::string path_;
  std::uint64_t seed_;
  std::uint64_t& room_;
  std::vector<GridPart> parts_;
  std::map<std::string, ComposedAxis, std::less<>> known_;  ///< axes that could be read
  std::set<std::string_view> names_;                        ///< of the parameters met so far, sound or not
  std::set<std::string> later_;                             ///< keys of the grid that are still to come
};

bool is_composed(const YamlNode& grid) {
  return std::ranges::any_of(grid.entries, [](const YamlEntry& entry) {
    if (entry.key == zip_key) return true;
    return entry.value.kind == Kind::mapping &&
           (entry.value.find("values") != nullptr || entry.value.find("where") != nullptr ||
            entry.value.find("sample") != nullptr);
  });
}

class GridsReader {
 public:
  GridsReader(FieldReader& fields, idl::SweepSpecification& specification, std::vector<std::string>& grid_paths)
      : fields_(fields), specification_(specification), grid_paths_(grid_paths) {}

  void read(const YamlNode& node) {
    if (node.kind != Kind::list) {
      return fields_.refuse("grids", "takes a list of mappings of parameters to axes; this is " + kind_name(node));
    }
    if (node.items.empty()) fields_.refuse("grids", "has no grids; leave it out for one job per replicate");
    for (std::size_t i = 0; i < node.items.size() && !fields_.full(); ++i) {
      fields_.place(grid_path(i), node.items[i]);
      if (node.items[i].kind == Kind::mapping && is_composed(node.items[i])) {
        read_composed(grid_path(i), node.items[i]);
      } else {
        read_plain(grid_path(i), node.items[i]);
      }
    }
  }

 private:
  idl::Grid& add_grid(const std::string& path) {
    grid_paths_.push_back(path);
    return *specification_.add_grids();
  }

  void read_plain(const std::string& path, const YamlNode& node) {
    auto& grid = add_grid(path);
    if (node.kind != Kind::mapping) {
      return fields_.refuse(path, "a grid is a mapping of parameters to axes; this is " + kind_name(node));
    }
    for (const auto& entry : node.entries) {
      const std::string axis = axis_path(path, entry.key);
      const Parameter* parameter = place_axis(fields_, axis, entry);
      auto& plain = *grid.add_axes();
      plain.set_parameter(entry.key);
      if (entry.value.kind == Kind::mapping) {
        read_range(fields_, axis, entry.value, parameter, plain);
      } else {
        read_values(fields_, axis, entry.value, parameter, plain);
      }
    }
  }

  void read_composed(const std::string& path, const YamlNode& node) {
    const auto parts = ComposedGridReader(fields_, path, specification_.seed(), sample_room_).read(node);
    if (fields_.any_refused_within(path)) return;
    const auto grids = static_cast<std::size_t>(maximum_grids - std::min(specification_.grids_size(), maximum_grids));
    const auto plain = expanded(parts, grids, values_left_);
    if (!plain) {
      return fields_.refuse(path, "stands for too many plain grids: a sweep has at most " +
                                      std::to_string(maximum_grids) + ", with " + std::to_string(maximum_axis_values) +
                                      " values on all their axes together");
    }
    check_used(path, parts, *plain);
    for (const auto& grid : *plain) {
      for (const auto& axis : grid.axes()) values_left_ -= static_cast<std::uint64_t>(axis.values_size());
      add_grid(path) = grid;
    }
  }

  /// An axis that is in none of the grids would vanish without a word.
  void check_used(const std::string& path, const std::vector<GridPart>& parts, const std::vector<idl::Grid>& plain) {
    std::set<std::string_view> used;
    for (const auto& grid : plain) {
      for (const auto& axis : grid.axes()) used.insert(axis.parameter());
    }
    for (const auto& part : parts) {
      for (const auto& column : part.columns) {
        if (used.contains(column.axis.parameter())) continue;
        fields_.refuse(axis_path(path, column.axis.parameter()),
                       "applies nowhere: its `where` never holds in this grid");
      }
    }
  }

  FieldReader& fields_;
  idl::SweepSpecification& specification_;
  std::vector<std::string>& grid_paths_;
  std::uint64_t values_left_ = maximum_axis_values;
  std::uint64_t sample_room_ = maximum_axis_values;
};

}  // namespace

void read_grids(const YamlNode& node, FieldReader& fields, idl::SweepSpecification& specification,
                std::vector<std::string>& grid_paths) {
  GridsReader(fields, specification, grid_paths).read(node);
}

}  // namespace lamprey::experiment
