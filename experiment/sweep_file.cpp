#include "experiment/environment_reader.hpp"
#include "experiment/execution_reader.hpp"
#include "experiment/field_reader.hpp"
#include "experiment/grid_reader.hpp"
#include "experiment/sweep.hpp"
#include "experiment/sweep_validation.hpp"
#include "experiment/yaml_tree.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

namespace lamprey::experiment {

namespace {

using Kind = YamlNode::Kind;

constexpr std::string_view known_fields[] = {"name",        "description", "seed",      "base",
                                             "environment", "grids",       "replicates"};

template <typename Count>
std::optional<Count> parse_count(const YamlNode& node) {
  const auto& text = node.text;
  const bool leading_zero = text.size() > 1 && text[0] == '0';
  if (node.kind != Kind::scalar || node.quoted || leading_zero) return std::nullopt;
  Count count{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return count;
}

/// Makes a specification of a YAML tree, and remembers where each field stands. What has the wrong shape is noted
/// here; values that are no numbers where they should be travel as text, for validate() to say what is allowed.
class SpecificationReader {
 public:
  explicit SpecificationReader(SweepFile& file)
      : specification_(file.specification), positions_(file.positions), fields_(file.positions) {}

  ReadBefore read(const YamlNode& root) {
    fields_.place("", root);
    specification_.set_seed(1);
    specification_.set_replicates(1);
    if (root.kind == Kind::mapping) {
      // Samples of axes depend on the seed, wherever it stands.
      for (const auto& entry : root.entries) {
        if (entry.key == "seed") read_field(entry);
      }
      for (const auto& entry : root.entries) {
        if (entry.key != "seed") read_field(entry);
      }
      add_environment();
    } else {
      fields_.refuse("", "a sweep file is a mapping of name, base, grids and so on; this is " + kind_name(root));
    }
    return {.problems = fields_.take(), .grid_paths = std::move(grid_paths_)};
  }

 private:
  void read_field(const YamlEntry& entry) {
    fields_.place(entry.key, entry.value);
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
    } else if (entry.key == "environment") {
      environment_ = read_environment(entry.value, fields_);
    } else if (entry.key == "grids") {
      read_grids(entry.value, fields_, specification_, grid_paths_);
    } else if (std::ranges::find(execution_fields(), entry.key) != execution_fields().end()) {
      read_execution_field(entry, fields_, *specification_.mutable_execution());
    } else {
      refuse_unknown(entry);
    }
  }

  void refuse_unknown(const YamlEntry& entry) {
    const std::string path = printable(entry.key);
    fields_.place_key(path, entry);
    if (find_parameter(entry.key) != nullptr) {
      return fields_.refuse(path, "is a parameter; it belongs under base, or as an axis under grids");
    }
    std::vector<std::string_view> names(std::begin(known_fields), std::end(known_fields));
    names.insert(names.end(), execution_fields().begin(), execution_fields().end());
    const std::string hint = nearest_hint(entry.key, names);
    std::string known = "; known are";
    for (const auto field : names) known.append(field == names.front() ? " " : ", ").append(field);
    fields_.refuse(path, "unknown field '" + path + "'" + (hint.empty() ? known : hint));
  }

  const std::string* read_text(const YamlEntry& entry) {
    if (entry.value.kind == Kind::scalar) return &entry.value.text;
    fields_.refuse(entry.key, "takes text; this is " + kind_name(entry.value));
    return nullptr;
  }

  template <typename Count, typename Use>
  void read_count(const YamlEntry& entry, Count minimum, Count maximum, const Use& use) {
    const auto count = parse_count<Count>(entry.value);
    if (count && *count >= minimum && *count <= maximum) return use(*count);
    fields_.refuse(entry.key, kind_name(entry.value) + " is not allowed: " + entry.key + " takes a whole number from " +
                                  std::to_string(minimum) + " to " + std::to_string(maximum));
  }

  void read_base(const YamlNode& node) {
    if (node.kind != Kind::mapping) {
      return fields_.refuse("base", "takes a mapping of parameters to values; this is " + kind_name(node));
    }
    for (const auto& entry : node.entries) {
      const std::string path = base_path(entry.key);
      const Parameter* parameter = find_parameter(entry.key);
      // An unknown name is looked for at the name, everything else at the value.
      if (parameter == nullptr) {
        fields_.place_key(path, entry);
      } else {
        fields_.place(path, entry.value);
      }
      auto& setting = *specification_.add_base();
      setting.set_parameter(entry.key);
      fields_.read_value(path, entry.value, parameter, *setting.mutable_value());
    }
  }

  /// The changes of the environment are a setting of the base.
  void add_environment() {
    if (!environment_) return;
    const std::string path = base_path("environment");
    if (positions_.contains(path)) return fields_.refuse("environment", "is set in base too; keep one of them");
    positions_[path] = positions_["environment"];
    auto& setting = *specification_.add_base();
    setting.set_parameter("environment");
    setting.mutable_value()->set_text(*environment_);
  }

  idl::SweepSpecification& specification_;
  SourceMap& positions_;
  FieldReader fields_;
  std::optional<std::string> environment_;
  std::vector<std::string> grid_paths_;
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
  if (problems.size() > maximum_problems) problems.resize(maximum_problems);
  throw InvalidInput(std::move(problems));
}

}  // namespace

SweepFile parse_sweep(const std::string& yaml, const std::string& file) {
  std::vector<Problem> problems;
  const YamlNode root = parse_yaml(yaml, file, problems);
  SweepFile result;
  auto read = SpecificationReader(result).read(root);
  auto found = root.kind == Kind::mapping ? validate(result.specification, std::move(read)) : std::move(read.problems);
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
  return parse_sweep(read_yaml_text(path), path);
}

}  // namespace lamprey::experiment
