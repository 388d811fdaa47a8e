#include "experiment/sweep.hpp"
#include "experiment/typed_value.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace lamprey::experiment {

namespace {

NumberRange typed_range(const Parameter& parameter, const idl::Range& range) {
  return {std::get<Value>(typed_value(parameter, range.from())), std::get<Value>(typed_value(parameter, range.to())),
          std::get<Value>(typed_step(parameter, range.step()))};
}

/// The values of an axis of a valid specification.
std::vector<Value> axis_values(const Parameter& parameter, const idl::Axis& axis) {
  if (axis.has_range()) return range_values(typed_range(parameter, axis.range()));
  std::vector<Value> values;
  values.reserve(static_cast<std::size_t>(axis.values_size()));
  for (const auto& value : axis.values()) values.push_back(std::get<Value>(typed_value(parameter, value)));
  return values;
}

void require_valid(const idl::SweepSpecification& specification) {
  auto problems = validate(specification);
  if (!problems.empty()) throw InvalidInput(std::move(problems));
}

/// One line of a grid in the canonical text; the grammar is in docs/formats/sweep_file.md.
std::string canonical_axis(const Parameter& parameter, const idl::Axis& axis) {
  std::string text;
  if (axis.has_range()) {
    const NumberRange range = typed_range(parameter, axis.range());
    text = to_text(range.from) + ".." + to_text(range.to) + "/" + to_text(range.step);
  } else {
    for (const auto& value : axis_values(parameter, axis)) text += (text.empty() ? "" : ",") + to_text(value);
  }
  return std::string(parameter.name) + "=" + text + "\n";
}

}  // namespace

SweepGrid::SweepGrid(const idl::SweepSpecification& specification)
    : seed_(specification.seed()), replicates_(specification.replicates()) {
  require_valid(specification);
  for (const auto& setting : specification.base()) {
    const std::size_t row = parameter_index(setting.parameter());
    base_.set(row, std::get<Value>(typed_value(registry()[row], setting.value())));
  }
  for (const auto& grid : specification.grids()) {
    Grid& expanded = grids_.emplace_back();
    for (const auto& axis : grid.axes()) {
      const std::size_t row = parameter_index(axis.parameter());
      expanded.axes.push_back({row, axis_values(registry()[row], axis)});
      expanded.cells *= expanded.axes.back().values.size();
    }
  }
  // Without grids the base is the only cell.
  if (grids_.empty()) grids_.emplace_back();
  for (const auto& grid : grids_) cells_ += grid.cells;
}

bool SweepGrid::asks_for_robot() const {
  const std::size_t robot = parameter_index("robot");
  const auto is_bridge = [](const Value& value) { return value == Value(std::string("bridge")); };
  const bool on_an_axis = std::ranges::any_of(grids_, [&](const Grid& grid) {
    return std::ranges::any_of(grid.axes, [&](const Axis& axis) {
      return axis.parameter == robot && std::ranges::any_of(axis.values, is_bridge);
    });
  });
  return on_an_axis || is_bridge(base_[robot]);
}

Job SweepGrid::job(std::uint64_t number) const {
  if (number >= jobs()) {
    throw std::out_of_range("job " + std::to_string(number) + " of a sweep of " + std::to_string(jobs()) + " jobs");
  }
  Job job{
      .number = number, .seed = seed_, .replicate = static_cast<std::uint32_t>(number / cells_), .parameters = base_};
  std::uint64_t cell = number % cells_;
  auto grid = grids_.begin();
  for (; cell >= grid->cells; ++grid) cell -= grid->cells;
  for (auto axis = grid->axes.rbegin(); axis != grid->axes.rend(); ++axis) {
    job.parameters.set(axis->parameter, axis->values[cell % axis->values.size()]);
    cell /= axis->values.size();
  }
  // What does not apply is no part of the identity, so it must be no part of the outcome either.
  for (std::size_t row = 0; row < registry().size(); ++row) {
    if (!job.parameters.applies(row)) job.parameters.set(row, registry()[row].default_value);
  }
  return job;
}

Id128 sweep_id(const idl::SweepSpecification& specification) {
  require_valid(specification);
  std::map<std::string, std::string> base;
  for (const auto& setting : specification.base()) {
    const Parameter& parameter = *find_parameter(setting.parameter());
    base.emplace(parameter.name, to_text(std::get<Value>(typed_value(parameter, setting.value()))));
  }
  std::string text = "lamprey-sweep/1\nname=" + specification.name() +
                     "\nseed=" + std::to_string(specification.seed()) +
                     "\nreplicates=" + std::to_string(specification.replicates()) + "\nbase\n";
  for (const auto& [name, value] : base) text += name + "=" + value + "\n";
  for (const auto& grid : specification.grids()) {
    text += "grid\n";
    for (const auto& axis : grid.axes()) text += canonical_axis(*find_parameter(axis.parameter()), axis);
  }
  return leading_128_bits(sha256(text));
}

}  // namespace lamprey::experiment
