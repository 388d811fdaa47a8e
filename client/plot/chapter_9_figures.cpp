#include "client/output/formatting.hpp"
#include "client/plot/figures.hpp"
#include "client/plot/script.hpp"

#include <algorithm>
#include <map>

/// Figures 9.5 and 9.6: failures before each change of gait.
namespace lamprey::client::plot {

namespace {

constexpr std::size_t changes_shown = 12;

/// Bars of the first changes of one job, labelled "walk to trot".
struct Story {
  std::string tics;
  std::vector<std::vector<double>> bars;
};

Story story_of(const Rows& rows) {
  Story story;
  if (rows.empty()) return story;
  const auto job = rows.text(0, "job");
  std::string gait = rows.text(0, "gait");
  for (std::size_t row = 0; row < rows.size() && row < changes_shown && rows.text(row, "job") == job; ++row) {
    const auto reached = rows.text(row, "gait_reached");
    story.tics += (row > 0 ? ", " : "") + in_quotes(gait + " to " + reached) + " " + std::to_string(row);
    story.bars.push_back({rows.number(row, "failures").value_or(0)});
    gait = reached;
  }
  return story;
}

/// The share of changes that took at most so many failures, in per cent.
std::vector<std::vector<double>> distribution_of(const Rows& rows) {
  std::vector<double> failures;
  for (std::size_t row = 0; row < rows.size(); ++row) failures.push_back(rows.number(row, "failures").value_or(0));
  std::ranges::sort(failures);
  std::vector<std::vector<double>> steps = {{0, 0}};
  for (std::size_t i = 0; i < failures.size(); ++i) {
    if (i + 1 < failures.size() && failures[i + 1] == failures[i]) continue;
    steps.push_back({failures[i], 100 * static_cast<double>(i + 1) / static_cast<double>(failures.size())});
  }
  return steps;
}

}  // namespace

Picture gait_change_failures(const Request& request, const Figure& figure) {
  const std::string mutation = figure.name == "9-5" ? "all" : "one";
  const std::string sweep = "figure-" + std::string(figure.name);
  if (!request.evidence->has_column("gait_change", "failures")) no_data(figure, {sweep});
  const auto reading = chosen_reading(request, figure, {{sweep}}, {"posture", "tonic_genes"});
  const auto rows = request.evidence->query(
      "SELECT g.job, r.gait, g.change, g.gait_reached, g.failures\n"
      "FROM gait_change AS g JOIN (SELECT sweep, job, gait FROM result WHERE " +
      reading.condition() + " AND mutation = '" + mutation +
      "') AS r ON r.sweep = g.sweep AND r.job = g.job\nORDER BY g.sweep, g.job, g.change");
  const auto story = story_of(rows);
  if (story.bars.empty()) no_data(figure, {sweep});
  const auto changes = output::counted(rows.size(), "change", "changes");
  return {.script =
              common_style() + data_block("story", story.bars) + data_block("shares", distribution_of(rows)) +
              multiplot(1, 2, "Changing gaits, mutate " + mutation,
                        reading.sweeps.front() + (reading.text().empty() ? "" : ": " + reading.text())) +
              labels("the first changes of job " + rows.text(0, "job"), "", "failures before the change") +
              "unset key\nset boxwidth 0.6\nset yrange [0:*]\nset offsets 0.6, 0.6, graph 0.1, 0\nset xtics rotate "
              "by 60 right (" +
              story.tics + ") scale 0\n" +
              plot_command({"$story using 0:1 with boxes linecolor rgb " + in_quotes(colour::blue),
                            "$story using 0:1:(sprintf('%g', $1)) with labels offset 0,0.6"}) +
              labels("all " + changes, "failures before a change", "changes with at most so many, %") +
              "set offsets 0, 0, 0, 0\nset xtics norotate auto scale 1\nset xrange [0:*]\nset yrange [0:100]\n" +
              plot_command({"$shares using 1:2 with steps linewidth 2 linecolor rgb " + in_quotes(colour::vermilion)}),
          .width = 1060,
          .height = 500};
}

}  // namespace lamprey::client::plot
