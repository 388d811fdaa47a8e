#pragma once

#include "client/evidence.hpp"
#include "client/plot/gnuplot.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The thesis's figures, drawn from results or from recordings of a gait.
namespace lamprey::client::plot {

/// What the user asks for.
struct Request {
  const Evidence* evidence = nullptr;  ///< set for figures that need a database
  /// Parameters of a recording; of results, which values the jobs must have.
  std::vector<std::pair<std::string, std::string>> settings;
  std::optional<std::string> sweep;       ///< instead of the figure's own
  std::vector<std::uint64_t> jobs;        ///< figure `fitness`; empty: all
  std::optional<std::string> average_by;  ///< figure `fitness`: one curve per value of this column
  std::int32_t time_steps = 0;            ///< of a recording; 0: what suits the figure
};

enum class Source : unsigned char { results, recording };

/// One row per figure: `lamprey plot list` and the command's help derive from it.
struct Figure {
  std::string_view name;
  std::string_view summary;
  Source source = Source::results;
  /// Throws Failure (no_data) if the database has nothing to draw, naming the sweep to run; Failure (invalid_input) for
  /// bad parameters of a recording.
  Picture (*make)(const Request& request, const Figure& figure) = nullptr;
};

std::span<const Figure> figure_table();

/// Nothing if there is no such figure.
const Figure* find_figure(std::string_view name);

/// The first of the readings that the request allows, in one of the sweeps (or the request's own): what to draw from.
/// `columns` tell readings apart. Throws Failure (no_data, unknown_sweep).
Reading chosen_reading(const Request& request, const Figure& figure,
                       const std::vector<std::vector<std::string>>& sweeps, const std::vector<std::string>& columns);

/// Throws Failure (no_data) that says what to run.
[[noreturn]] void no_data(const Figure& figure, const std::vector<std::string>& sweeps);

}  // namespace lamprey::client::plot
