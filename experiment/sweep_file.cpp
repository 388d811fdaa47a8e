#include "experiment/sweep.hpp"
#include "experiment/sweep_validation.hpp"
#include "experiment/yaml_tree.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>

namespace lamprey::experiment {

namespace {

using Kind = YamlNode::Kind;

constexpr std::string_view known_fields[] = {"name", "description", "seed", "base", "grids", "replicates"};
constexpr std::string_view range_fields[] = {"from", "to", "step"};

template <typename Number>
std::optional<Number> parse_number(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Whether YAML readers might take the number for octal: 010 is 8 to some of them.
bool looks_octal(std::string_view text) {
  const auto digits = text.starts_with('-') ? text.substr(1) : text;
  return digits.size() > 1 && digits[0] == '0' && digits[1] >= '0' && digits[1] <= '9';
}

std::string kind_name(const YamlNode& node) {
  switch (node.kind) {
    case Kind::null:
      return "nothing";
    case Kind::scalar:
      return "'" + printable(node.text) + "'";
    case Kind::list:
      return "a list";
    case Kind::mapping:
      return "a mapping";
  }
  return {};
}

/// Makes a specification of a YAML tree, and remembers where each field stands. What has the wrong shape is noted
/// here; values that are no numbers where they should be travel as text, for validate() to say what is allowed.
class SpecificationReader {
 public:
  explicit SpecificationReader(SweepFile& file) : specification_(file.specification), positions_(file.positions) {}

  std::vector<Problem> read(const YamlNode& root) {
    positions_[""] = {root.line, root.column};
    specification_.set_seed(1);
    specification_.set_replicates(1);
    if (root.kind != Kind::mapping) {
      refuse("", "a sweep file is a mapping of name, base, grids and so on; this is " + kind_name(root));
      return findings_.take();
    }
    for (const auto& entry : root.entries) read_field(entry);
    return findings_.take();
  }

 private:
  void place(const std::string& path, const YamlNode& node) { positions_[path] = {node.line, node.column}; }

  void refuse(const std::string& path, std::string message) { findings_.add(path, std::move(message)); }

  void read_field(const YamlEntry& entry) {
    place(entry.key, entry.value);
    if (entry.key == "name") {
      if (const auto* text = read_text(entry)) specification_.set_name(*text);
    } else if (entry.key == "description") {
      if (const auto* text = read_text(entry)) specification_.set_description(*text);
    } else if (entry.key == "seed") {
      read_count<std::uint64_t>(entry, 0, std::numeric_limits<std::uint64_t>::max(),
                                [&](std::uint64_t seed) { specification_.set_seed(seed); });
    } else if (entry.key == "replicates") {
      read_count<std::uint32_t>(entry, 1, maximum_replicates,
                                [&](std::uint32_t replicates) { specification_.set_replicates(replicates); });
    } else if (entry.key == "base") {
      read_base(entry.value);
    } else if (entry.key == "grids") {
      read_grids(entry.value);
    } else {
      refuse_unknown(entry);
    }
  }

  void refuse_unknown(const YamlEntry& entry) {
    const std::string path = printable(entry.key);
    positions_[path] = {entry.line, entry.column};
    const std::vector<std::string_view> known(std::begin(known_fields), std::end(known_fields));
    const std::string nearest = nearest_name(entry.key, known);
    if (find_parameter(entry.key) != nullptr) {
      refuse(path, "is a parameter; it belongs under base, or as an axis under grids");
    } else if (!nearest.empty()) {
      refuse(path, "unknown field '" + path + "'; did you mean '" + nearest + "'?");
    } else {
      refuse(path, "unknown field '" + path + "'; known are name, description, seed, base, grids, replicates");
    }
  }

  const std::string* read_text(const YamlEntry& entry) {
    if (entry.value.kind == Kind::scalar) return &entry.value.text;
    refuse(entry.key, "takes text; this is " + kind_name(entry.value));
    return nullptr;
  }

  template <typename Count, typename Use>
  void read_count(const YamlEntry& entry, Count minimum, Count maximum, const Use& use) {
    const auto& node = entry.value;
    const auto count = node.kind == Kind::scalar && !node.quoted && !looks_octal(node.text)
                           ? parse_number<Count>(node.text)
                           : std::nullopt;
    if (count && *count >= minimum && *count <= maximum) return use(*count);
    refuse(entry.key, kind_name(node) + " is not allowed: " + entry.key + " takes a whole number from " +
                          std::to_string(minimum) + " to " + std::to_string(maximum));
  }

  void read_base(const YamlNode& node) {
    if (node.kind != Kind::mapping) {
      return refuse("base", "takes a mapping of parameters to values; this is " + kind_name(node));
    }
    for (const auto& entry : node.entries) {
      const std::string path = base_path(entry.key);
      const Parameter* parameter = place_parameter(path, entry, entry.value);
      auto& setting = *specification_.add_base();
      setting.set_parameter(entry.key);
      read_value(path, entry.value, parameter, *setting.mutable_value());
    }
  }

  void read_grids(const YamlNode& node) {
    if (node.kind != Kind::list) {
      return refuse("grids", "takes a list of mappings of parameters to axes; this is " + kind_name(node));
    }
    if (node.items.empty()) refuse("grids", "has no grids; leave it out for one job per replicate");
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      const auto& item = node.items[i];
      place(grid_path(i), item);
      auto& grid = *specification_.add_grids();
      if (item.kind != Kind::mapping) {
        refuse(grid_path(i), "a grid is a mapping of parameters to axes; this is " + kind_name(item));
        continue;
      }
      for (const auto& entry : item.entries) read_axis(i, entry, *grid.add_axes());
    }
  }

  void read_axis(std::size_t grid, const YamlEntry& entry, idl::Axis& axis) {
    const std::string path = axis_path(grid, entry.key);
    YamlNode key_place;
    key_place.line = entry.line;
    key_place.column = entry.column;
    const Parameter* parameter = place_parameter(path, entry, key_place);
    axis.set_parameter(entry.key);
    if (entry.value.kind == Kind::mapping) return read_range(path, entry.value, parameter, *axis.mutable_range());
    if (entry.value.kind == Kind::list) {
      for (std::size_t i = 0; i < entry.value.items.size(); ++i) {
        place(value_path(path, i), entry.value.items[i]);
        read_value(value_path(path, i), entry.value.items[i], parameter, *axis.add_values());
      }
      return;
    }
    place(value_path(path, 0), entry.value);
    read_value(value_path(path, 0), entry.value, parameter, *axis.add_values());
  }

  void read_range(const std::string& path, const YamlNode& node, const Parameter* parameter, idl::Range& range) {
    for (const auto& entry : node.entries) {
      const std::string part = path + "." + printable(entry.key);
      place(part, entry.value);
      if (entry.key == "from") {
        read_value(part, entry.value, parameter, *range.mutable_from());
      } else if (entry.key == "to") {
        read_value(part, entry.value, parameter, *range.mutable_to());
      } else if (entry.key == "step") {
        read_value(part, entry.value, parameter, *range.mutable_step());
      } else {
        positions_[part] = {entry.line, entry.column};
        const std::vector<std::string_view> known(std::begin(range_fields), std::end(range_fields));
        const std::string nearest = nearest_name(entry.key, known);
        refuse(part, "a range has from, to and step" +
                         (nearest.empty() ? std::string() : "; did you mean '" + nearest + "'?"));
      }
    }
  }

  /// The parameter that an entry names. An unknown name is looked for at the name, everything else at `usual`.
  const Parameter* place_parameter(const std::string& path, const YamlEntry& entry, const YamlNode& usual) {
    const Parameter* parameter = find_parameter(entry.key);
    positions_[path] =
        parameter == nullptr ? SourcePosition{entry.line, entry.column} : SourcePosition{usual.line, usual.column};
    return parameter;
  }

  void read_value(const std::string& path, const YamlNode& node, const Parameter* parameter, idl::Value& value) {
    if (node.kind == Kind::list || node.kind == Kind::mapping) {
      return refuse(path, "takes a single value; this is " + kind_name(node));
    }
    if (node.kind == Kind::null) return;
    const bool number =
        parameter != nullptr && parameter->kind != ParameterKind::choice && !node.quoted && !looks_octal(node.text);
    if (number && parameter->kind == ParameterKind::integer) {
      if (const auto integer = parse_number<std::int64_t>(node.text)) return value.set_integer(*integer);
    } else if (number) {
      if (const auto real = parse_number<double>(node.text)) return value.set_real(*real);
    }
    value.set_text(node.text);
  }

  idl::SweepSpecification& specification_;
  SourceMap& positions_;
  Findings findings_{{}};
};

/// Where the field stands, or the nearest field that holds it.
SourcePosition position_of(const SourceMap& positions, std::string field) {
  while (true) {
    if (const auto found = positions.find(field); found != positions.end()) return found->second;
    if (field.empty()) return {};
    const auto end = field.find_last_of(".[");
    field.resize(end == std::string::npos ? 0 : end);
  }
}

void throw_if_any(std::vector<Problem> problems) {
  if (problems.empty()) return;
  std::ranges::stable_sort(problems, {}, [](const Problem& p) { return std::pair(p.line, p.column); });
  throw InvalidInput(std::move(problems));
}

Problem file_problem(const std::string& path, std::string message) {
  return {.field = "", .message = std::move(message), .file = path};
}

}  // namespace

SweepFile parse_sweep(const std::string& yaml, const std::string& file) {
  std::vector<Problem> problems;
  const YamlNode root = parse_yaml(yaml, file, problems);
  SweepFile result;
  auto found = SpecificationReader(result).read(root);
  if (root.kind == Kind::mapping) found = validate(result.specification, std::move(found));
  for (auto& problem : found) {
    const auto [line, column] = position_of(result.positions, problem.field);
    problem.file = file;
    problem.line = line;
    problem.column = column;
    problems.push_back(std::move(problem));
  }
  throw_if_any(std::move(problems));
  return result;
}

SweepFile read_sweep_file(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw InvalidInput(file_problem(path, "no such file"));
  if (std::filesystem::is_directory(status)) throw InvalidInput(file_problem(path, "is a directory"));
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InvalidInput(file_problem(path, "cannot be opened for reading"));
  // One byte more than allowed tells parse_yaml that the file is too large; pipes have no size to ask for.
  std::string text(maximum_yaml_bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) throw InvalidInput(file_problem(path, "cannot be read"));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return parse_sweep(text, path);
}

}  // namespace lamprey::experiment
