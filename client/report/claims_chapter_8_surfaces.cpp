#include "client/report/chapter_8_queries.hpp"
#include "client/report/claims.hpp"
#include "client/report/judgement.hpp"

#include <algorithm>

/// Claims 6 and 7: equilibrium disturbance against mutation size (8.3.2, figs 8.6 to 8.9).
namespace lamprey::client::report {

namespace {

constexpr std::size_t cells_of_a_trend = 9;  ///< three levels on both axes
constexpr double level = 25;                 ///< per cent between neighbours on both axes (fig. 8.1)

const std::string slope_rule =
    "Trends: the 95 % t interval of the least-squares slope over the cells (equilibrium disturbance x mutation size; "
    "the "
    "plane a + b x + c y through their means, or through all jobs where there are fewer than nine cells), per 25 %, ";

/// One surface: the means of the cells of one mutation technique and one kind of steps.
struct Surface {
  std::vector<statistics::Cell> cells;
  MaybeInterval highest_cell;  ///< of the cell with the highest mean, less the expected total, 95 %
};

Surface surface_of(const Rows& rows, const std::string& mutation, const std::string& steps, const std::string& column) {
  Surface surface;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (rows.text(row, "mutation") != mutation || rows.text(row, "steps") != steps) continue;
    const auto disturbance = rows.number(row, "equilibrium_disturbance");
    const auto size = rows.number(row, "mutation_size");
    const auto totals = sample_in(rows, row, column);
    if (!disturbance || !size || totals.size == 0) continue;
    surface.cells.push_back({*disturbance / level, *size / level, totals});
    const auto below_expected = statistics::mean_interval(sample_in(rows, row, column + "_reached"), confidence);
    if (below_expected && (!surface.highest_cell || below_expected->estimate > surface.highest_cell->estimate))
      surface.highest_cell = below_expected;
  }
  return surface;
}

struct Slopes {
  MaybeInterval disturbance;
  MaybeInterval size;
};

Slopes slopes_of(const Surface& surface) {
  auto cells = surface.cells;
  if (cells.size() >= cells_of_a_trend) {
    for (auto& cell : cells) cell.values = {.size = 1, .mean = cell.values.mean, .variance = 0};
  }
  const auto slopes = statistics::plane_slopes(cells, confidence);
  if (!slopes) return {};
  return {slopes->x, slopes->y};
}

std::string surfaces_sql(const Reading& reading, const std::string& acceptance) {
  return averages_sql(reading, {"mutation", "steps", "equilibrium_disturbance", "mutation_size"},
                      "acceptance = '" + acceptance + "' AND steps IN ('normal', 'uniform')");
}

}  // namespace

std::vector<Part> assess_simple_surfaces(const Evidence& evidence, const Reading& reading) {
  const auto sql = surfaces_sql(reading, "simple");
  const auto rows = evidence.query(sql);
  std::vector<Part> parts;
  for (const std::string mutation : {"all", "one", "some"}) {
    for (const std::string steps : {"normal", "uniform"}) {
      const std::string of = mutation + ", " + steps + ": ";
      const std::string rule = slope_rule + "lies below 0 for the disturbance and above 0 for the mutation size.";
      Part falls = part_of(of + "slope, disturbance", "below 0", rule, sql);
      Part rises = part_of(of + "slope, mutation size", "above 0", rule, sql);
      Part stays =
          part_of(of + "best cell - expected", "below 0",
                  "Stays below 139.375: in the cell with the highest mean, the 95 % t interval of the total less "
                  "the expected one (139.375 on average in each cell) lies below 0.",
                  sql);
      for (const auto& column : fitness_columns) {
        const auto surface = surface_of(rows, mutation, steps, column);
        const auto slopes = slopes_of(surface);
        falls.measured.push_back(below(column, slopes.disturbance, 0));
        rises.measured.push_back(above(column, slopes.size, 0));
        stays.measured.push_back(below(column, surface.highest_cell, 0));
      }
      for (auto& part : {falls, rises, stays}) parts.push_back(part);
    }
  }
  return parts;
}

std::vector<Part> assess_annealing_surfaces(const Evidence& evidence, const Reading& reading) {
  const auto sql = surfaces_sql(reading, "annealing");
  const auto rows = evidence.query(sql);
  std::vector<Part> parts;
  for (const std::string steps : {"normal", "uniform"}) {
    Part disturbance = part_of("all, " + steps + ": slope, disturbance", "above 0",
                               slope_rule + "lies above 0 for both, with mutate-all.", sql);
    Part size = disturbance;
    size.name = "all, " + steps + ": slope, mutation size";
    for (const auto& column : fitness_columns) {
      const auto slopes = slopes_of(surface_of(rows, "all", steps, column));
      disturbance.measured.push_back(above(column, slopes.disturbance, 0));
      size.measured.push_back(above(column, slopes.size, 0));
    }
    parts.push_back(std::move(disturbance));
    parts.push_back(std::move(size));
  }
  for (const std::string mutation : {"one", "some"}) {
    for (const std::string steps : {"normal", "uniform"}) {
      Part part =
          part_of(mutation + ", " + steps + ": lesser slope of the two", "not above 0",
                  "No such pattern with mutate-one and mutate-some: of the two slopes at least one is not above 0 "
                  "(its 95 % interval reaches down to 0 or below); the one shown is that with the lower limit.",
                  sql);
      for (const auto& column : fitness_columns) {
        const auto slopes = slopes_of(surface_of(rows, mutation, steps, column));
        auto lesser = slopes.disturbance;
        if (slopes.size && (!lesser || slopes.size->low < lesser->low)) lesser = slopes.size;
        part.measured.push_back(judged(column, lesser, lesser && lesser->low <= 0));
      }
      parts.push_back(std::move(part));
    }
  }
  return parts;
}

}  // namespace lamprey::client::report
