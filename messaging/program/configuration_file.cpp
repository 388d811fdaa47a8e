#include "messaging/program/configuration_file.hpp"

#include "experiment/problem.hpp"
#include "experiment/yaml_tree.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

namespace lamprey::messaging::program {
namespace {

using experiment::InvalidInput;
using experiment::Problem;
using experiment::YamlEntry;
using experiment::YamlNode;
using Kind = YamlNode::Kind;

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::string unknown_field(const std::string& name, const std::vector<JoinField>& fields) {
  std::vector<std::string_view> known;
  std::string all;
  for (const auto& field : fields) {
    known.push_back(field.name);
    all += (all.empty() ? "" : ", ") + field.name;
  }
  return "there is no field '" + name + "'" + experiment::nearest_hint(name, known) + " (there are " + all + ")";
}

class Reader {
 public:
  Reader(std::string file, const std::vector<JoinField>& fields) : fields_(fields) { result_.file = std::move(file); }

  Configuration read() {
    const YamlNode root = experiment::parse_yaml(experiment::read_yaml_text(result_.file), result_.file, problems_);
    if (root.kind != Kind::mapping && root.kind != Kind::null) {
      refuse(root, {}, "fields are expected, such as 'domain: 7'; this is " + experiment::kind_name(root));
    }
    for (const auto& entry : root.entries) read_entry(entry);
    if (!problems_.empty()) throw InvalidInput(std::move(problems_));
    return std::move(result_);
  }

 private:
  void refuse(const YamlNode& node, const std::string& field, std::string message) {
    if (problems_.size() == experiment::maximum_problems) return;
    problems_.push_back({field, std::move(message), result_.file, node.line, node.column});
  }

  void read_entry(const YamlEntry& entry) {
    const std::string name = experiment::printable(entry.key);
    const auto field = std::ranges::find(fields_, entry.key, &JoinField::name);
    if (field == fields_.end()) {
      YamlNode key;
      key.line = entry.line;
      key.column = entry.column;
      return refuse(key, {}, unknown_field(name, fields_));
    }
    Configuration::Entry read{name, {}, entry.line};
    const auto& node = entry.value;
    const bool is_list = node.kind == Kind::list && field->kind == JoinField::Kind::list;
    if (!is_list) read_value(node, *field, read);
    for (const auto& item : node.items) {
      if (is_list) read_value(item, *field, read);
    }
    result_.entries.push_back(std::move(read));
  }

  void read_value(const YamlNode& node, const JoinField& field, Configuration::Entry& read) {
    if (node.kind != Kind::scalar) {
      const std::string wanted = field.kind == JoinField::Kind::list ? "texts" : "a single value";
      return refuse(node, field.name, "wants " + wanted + ", not " + experiment::kind_name(node));
    }
    if (auto fault = field.fault(node.text); !fault.empty()) {
      return refuse(node, field.name, std::move(fault));
    }
    read.values.push_back(node.text);
  }

  const std::vector<JoinField>& fields_;
  Configuration result_;
  std::vector<Problem> problems_;
};

}  // namespace

const Configuration::Entry* Configuration::find(std::string_view field) const {
  const auto found = std::ranges::find(entries, field, &Entry::field);
  return found == entries.end() ? nullptr : &*found;
}

std::string usual_configuration_file() {
  const std::filesystem::path name = "lamprey/lamprey.yaml";
  std::vector<std::filesystem::path> places;
  if (const auto folder = variable("XDG_CONFIG_HOME"); !folder.empty()) {
    places.push_back(folder / name);
  } else if (const auto home = variable("HOME"); !home.empty()) {
    places.push_back(std::filesystem::path(home) / ".config" / name);
  }
  places.push_back("/etc" / name);
  // What can't be looked at, such as another user's home, is not there for this one.
  std::error_code error;
  const auto found =
      std::ranges::find_if(places, [&](const auto& place) { return std::filesystem::exists(place, error); });
  return found == places.end() ? std::string() : found->string();
}

Configuration read_configuration(const std::string& file, const std::vector<JoinField>& fields) {
  return Reader(file, fields).read();
}

}  // namespace lamprey::messaging::program
