#include "experiment/grid_expansion.hpp"

#include <algorithm>
#include <map>

namespace lamprey::experiment {

namespace {

class Expansion {
 public:
  Expansion(const std::vector<GridPart>& parts, std::size_t maximum_grids, std::uint64_t maximum_values)
      : parts_(parts), grids_left_(maximum_grids), values_left_(maximum_values) {}

  /// Whether the limits were kept.
  bool expand() { return expand_from(0); }

  std::vector<idl::Grid> take() { return std::move(grids_); }

 private:
  /// An axis of the grid that is being made: all values of its part, or those at some positions.
  struct Chosen {
    const ComposedAxis* axis;
    std::optional<std::vector<std::size_t>> positions;
  };

  bool expand_from(std::size_t part) {
    if (part == parts_.size()) return emit();
    const auto& columns = parts_[part].columns;
    if (parts_[part].zipped) return expand_rows(part);
    if (!applies(columns.front())) return expand_from(part + 1);
    const auto groups = groups_told_apart(columns.front());
    if (groups.size() == 1) return with({&columns.front(), std::nullopt}, part);
    return std::ranges::all_of(groups, [&](const auto& group) { return with({&columns.front(), group}, part); });
  }

  bool expand_rows(std::size_t part) {
    const auto& columns = parts_[part].columns;
    for (std::size_t row = 0; row < columns.front().values.size(); ++row) {
      for (const auto& column : columns) chosen_.push_back({&column, std::vector{row}});
      const bool kept = expand_from(part + 1);
      chosen_.resize(chosen_.size() - columns.size());
      if (!kept) return false;
    }
    return true;
  }

  bool with(Chosen chosen, std::size_t part) {
    chosen_.push_back(std::move(chosen));
    const bool kept = expand_from(part + 1);
    chosen_.pop_back();
    return kept;
  }

  /// Whether all that the axis asks for is so. The values of a chosen axis are all in a `where` or all out of it.
  bool applies(const ComposedAxis& axis) const {
    return std::ranges::all_of(axis.where, [&](const ComposedAxis::Where& where) {
      const auto found = std::ranges::find_if(
          chosen_, [&](const Chosen& chosen) { return chosen.axis->axis.parameter() == where.parameter; });
      if (found == chosen_.end()) return false;
      return std::ranges::binary_search(where.values,
                                        found->axis->values[found->positions ? found->positions->front() : 0]);
    });
  }

  /// Positions of the axis's values, grouped by which of the `where` that refer to it they are in.
  std::vector<std::vector<std::size_t>> groups_told_apart(const ComposedAxis& axis) const {
    std::vector<const ComposedAxis::Where*> referring;
    for (const auto& part : parts_) {
      for (const auto& column : part.columns) {
        for (const auto& where : column.where) {
          if (where.parameter == axis.axis.parameter()) referring.push_back(&where);
        }
      }
    }
    if (referring.empty()) return {{}};
    std::map<std::vector<bool>, std::size_t> number;
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < axis.values.size(); ++i) {
      std::vector<bool> in;
      for (const auto* where : referring) in.push_back(std::ranges::binary_search(where->values, axis.values[i]));
      const auto [group, is_new] = number.emplace(std::move(in), groups.size());
      if (is_new) groups.emplace_back();
      groups[group->second].push_back(i);
    }
    return groups;
  }

  bool emit() {
    if (grids_left_ == 0) return false;
    --grids_left_;
    auto& grid = grids_.emplace_back();
    for (const auto& [axis, positions] : chosen_) {
      const std::uint64_t size = positions ? positions->size() : static_cast<std::uint64_t>(axis->axis.values_size());
      if (size > values_left_) return false;
      values_left_ -= size;
      auto& plain = *grid.add_axes();
      if (!positions) {
        plain = axis->axis;
        continue;
      }
      plain.set_parameter(axis->axis.parameter());
      for (const std::size_t i : *positions) *plain.add_values() = axis->axis.values(static_cast<int>(i));
    }
    return true;
  }

  const std::vector<GridPart>& parts_;
  std::size_t grids_left_;
  std::uint64_t values_left_;
  std::vector<Chosen> chosen_;
  std::vector<idl::Grid> grids_;
};

}  // namespace

std::optional<std::vector<idl::Grid>> expanded(const std::vector<GridPart>& parts, std::size_t maximum_grids,
                                               std::uint64_t maximum_values) {
  Expansion expansion(parts, maximum_grids, maximum_values);
  if (!expansion.expand()) return std::nullopt;
  return expansion.take();
}

}  // namespace lamprey::experiment
