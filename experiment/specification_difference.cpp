#include "experiment/specification_difference.hpp"

#include "experiment/problem.hpp"
#include "experiment/sweep_validation.hpp"
#include "experiment/typed_value.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace lamprey::experiment {

namespace {

using Texts = std::vector<std::string>;

/// Longer lists are not written out.
constexpr std::size_t longest_list = 12;

std::string joined(const Texts& texts) {
  std::string all;
  for (const auto& text : texts) all += (all.empty() ? "" : ", ") + text;
  return all;
}

/// In the one form in which values are compared: 1 and 1.0 are the same number of a real parameter.
std::string text_of(const std::string& parameter, const idl::Value& value) {
  if (const auto* row = find_parameter(parameter)) {
    const auto typed = typed_value(*row, value);
    if (const auto* sound = std::get_if<Value>(&typed)) {
      const std::string text = to_text(*sound);
      return text.empty() ? "none" : text;
    }
  }
  return printable(value.ShortDebugString());
}

std::string step_text(const std::string& parameter, const idl::Value& value) {
  if (const auto* row = find_parameter(parameter)) {
    const auto typed = typed_step(*row, value);
    if (const auto* sound = std::get_if<Value>(&typed)) return to_text(*sound);
  }
  return printable(value.ShortDebugString());
}

struct AxisTexts {
  bool is_range = false;
  Texts values;  ///< of a range its one text
};

AxisTexts texts_of(const idl::Axis& axis) {
  const auto& name = axis.parameter();
  if (axis.has_range()) {
    return {true,
            {text_of(name, axis.range().from()) + " to " + text_of(name, axis.range().to()) + " in steps of " +
             step_text(name, axis.range().step())}};
  }
  AxisTexts texts;
  for (const auto& value : axis.values()) texts.values.push_back(text_of(name, value));
  return texts;
}

std::string shown(const Texts& values) {
  if (values.size() <= longest_list) return joined(values);
  const Texts first(values.begin(), values.begin() + longest_list - 2);
  return joined(first) + ", ..., " + values.back() + " (" + std::to_string(values.size()) + " values)";
}

class Differences {
 public:
  void add(const std::string& field, const std::string& stored, const std::string& given) {
    if (stored != given) note(field + ": " + stored + ", now " + given);
  }

  void note(std::string line) {
    if (++count_ <= maximum_differences) lines_.push_back(std::move(line));
  }

  std::vector<std::string> take() {
    if (count_ > maximum_differences) {
      lines_.push_back("and " + std::to_string(count_ - maximum_differences) + " more differences");
    }
    return std::move(lines_);
  }

 private:
  std::vector<std::string> lines_;
  std::size_t count_ = 0;
};

void compare_bases(const idl::SweepSpecification& stored, const idl::SweepSpecification& given,
                   Differences& differences) {
  const auto settings = [](const idl::SweepSpecification& specification) {
    std::map<std::string, std::string> texts;
    for (const auto& setting : specification.base()) {
      texts[setting.parameter()] = text_of(setting.parameter(), setting.value());
    }
    return texts;
  };
  const auto before = settings(stored);
  const auto now = settings(given);
  std::set<std::string> names;
  for (const auto& texts : {before, now}) {
    for (const auto& [name, text] : texts) names.insert(name);
  }
  const auto text = [](const std::map<std::string, std::string>& texts, const std::string& name) {
    const auto found = texts.find(name);
    return found == texts.end() ? "not set" : found->second;
  };
  for (const auto& name : names) differences.add(base_path(name), text(before, name), text(now, name));
}

void compare_axes(const std::string& path, const idl::Axis& stored, const idl::Axis& given, Differences& differences) {
  const auto before = texts_of(stored);
  const auto now = texts_of(given);
  if (before.values == now.values && before.is_range == now.is_range) return;
  const bool long_lists = before.values.size() > longest_list || now.values.size() > longest_list;
  if (long_lists && before.values.size() == now.values.size()) {
    // The values in which they differ may be among those that are not shown.
    for (std::size_t i = 0; i < before.values.size(); ++i) {
      differences.add(value_path(path, i), before.values[i], now.values[i]);
    }
    return;
  }
  const std::string first = shown(before.values);
  const std::string second = shown(now.values);
  differences.note(path + ": " + first + ", now " + second);
}

void compare_grids(const std::string& path, const idl::Grid& stored, const idl::Grid& given, Differences& differences) {
  const auto find = [](const idl::Grid& grid, const std::string& parameter) {
    return std::ranges::find_if(grid.axes(), [&](const auto& axis) { return axis.parameter() == parameter; });
  };
  const auto names = [](const idl::Grid& grid) {
    Texts all;
    for (const auto& axis : grid.axes()) all.push_back(printable(axis.parameter()));
    return all;
  };
  for (const auto& axis : stored.axes()) {
    const std::string at = axis_path(path, axis.parameter());
    if (const auto other = find(given, axis.parameter()); other != given.axes().end()) {
      compare_axes(at, axis, *other, differences);
    } else {
      differences.note(at + ": " + shown(texts_of(axis).values) + ", now no axis");
    }
  }
  for (const auto& axis : given.axes()) {
    if (find(stored, axis.parameter()) != stored.axes().end()) continue;
    differences.note(axis_path(path, axis.parameter()) + ": no axis, now " + shown(texts_of(axis).values));
  }
  auto before = names(stored);
  auto now = names(given);
  const bool permuted = before != now && std::ranges::is_permutation(before, now);
  if (permuted) differences.note(path + ": axes in the order " + joined(before) + ", now " + joined(now));
}

}  // namespace

std::vector<std::string> differences(const idl::SweepSpecification& stored, const idl::SweepSpecification& given) {
  Differences found;
  found.add("name", printable(stored.name()), printable(given.name()));
  found.add("seed", std::to_string(stored.seed()), std::to_string(given.seed()));
  compare_bases(stored, given, found);
  found.add("grids", std::to_string(stored.grids_size()), std::to_string(given.grids_size()));
  for (int i = 0; i < std::min(stored.grids_size(), given.grids_size()); ++i) {
    compare_grids(grid_path(static_cast<std::size_t>(i)), stored.grids(i), given.grids(i), found);
  }
  found.add("replicates", std::to_string(stored.replicates()), std::to_string(given.replicates()));
  return found.take();
}

}  // namespace lamprey::experiment
