#include "client/failure.hpp"
#include "client/output/formatting.hpp"
#include "client/plot/curves.hpp"
#include "client/plot/figures.hpp"
#include "client/plot/script.hpp"
#include "client/statistics/intervals.hpp"

#include <algorithm>
#include <map>

/// Figures 6.25 to 6.27, 6.30, 6.31: the biped's networks; and totals of any jobs against their cycles.
namespace lamprey::client::plot {

namespace {

/// Names of the networks as the thesis has them.
std::string network_name(const std::string& network) {
  if (network == "recurrent_pair") return "recurrent";
  if (network == "feed_forward_pair") return "feed-forward";
  return network;
}

std::string sweep_of(std::string_view figure) {
  return "figure-" + std::string(figure == "6-26" ? "6-25" : figure == "6-31" ? "6-30" : figure);
}

Reading biped_reading(const Request& request, const Figure& figure) {
  return chosen_reading(request, figure, {{sweep_of(figure.name)}}, {"neuron", "weight_range", "posture"});
}

std::string trainer_name(std::string_view figure) {
  return figure == "6-30" || figure == "6-31" ? "II-RTEA" : "genetic algorithm";
}

/// The courses of each mutation rate; rates in order.
std::map<double, std::vector<Course>> by_rate(std::vector<Course> all) {
  std::map<double, std::vector<Course>> rates;
  for (auto& course : all) rates[std::stod(course.group.at(0))].push_back(std::move(course));
  return rates;
}

struct Axes {
  std::string x;
  std::string y;
  bool against_variation = false;
};

std::string panels(const std::map<double, std::vector<Course>>& rates, const Axes& axes) {
  std::string data;
  std::string plots;
  std::size_t block = 0;
  for (const auto& [rate, courses] : rates) {
    std::vector<std::string> items;
    for (std::size_t i = 0; i < courses.size(); ++i, ++block) {
      const auto& course = courses[i];
      const std::string name = "course" + std::to_string(block);
      std::vector<std::vector<double>> rows;
      for (std::size_t k = 0; k < course.cycles.size(); ++k)
        rows.push_back({axes.against_variation ? course.variation[k] : course.cycles[k], course.total[k]});
      data += data_block(name, rows);
      const std::string title = network_name(course.group.at(1));
      items.push_back("$" + name + " using 1:2 with " +
                      (axes.against_variation ? "linespoints pointtype 7 pointsize 0.3" : "steps") +
                      " linewidth 2 linecolor rgb " + in_quotes(colour_of(i)) + " title " + in_quotes(title));
    }
    plots += labels("mutation rate " + number(rate) + " %, mean of " +
                        output::counted(courses.front().jobs, "trial", "trials"),
                    axes.x, axes.y) +
             plot_command(items);
  }
  return data + "\f" + plots;
}

Picture rate_panels(const Request& request, const Figure& figure, const Axes& axes) {
  const auto reading = biped_reading(request, figure);
  const auto rates = by_rate(courses(*request.evidence, reading, {"mutation_rate", "network"},
                                     "mutation_rate IS NOT NULL", axes.against_variation));
  if (rates.empty()) no_data(figure, {sweep_of(figure.name)});
  const auto script = panels(rates, axes);
  const auto split = script.find('\f');
  const int rows = static_cast<int>((rates.size() + 1) / 2);
  const std::string note = reading.sweeps.front() + (reading.text().empty() ? "" : ": " + reading.text());
  return {.script = common_style() + script.substr(0, split) +
                    multiplot(rows, 2, "Biped, " + trainer_name(figure.name) + ": recurrent and feed-forward networks",
                              note) +
                    "set key inside bottom right vertical samplen 2\n" + script.substr(split + 1),
          .width = 980,
          .height = 100 + 330 * rows};
}

}  // namespace

Picture fitness_by_network(const Request& request, const Figure& figure) {
  return rate_panels(request, figure, {.x = "evaluations", .y = "fitness (eq. 6.4)"});
}

Picture fitness_against_variation(const Request& request, const Figure& figure) {
  return rate_panels(request, figure,
                     {.x = "average variation of the parameters", .y = "fitness (eq. 6.4)", .against_variation = true});
}

Picture fitness_by_mutation_rate(const Request& request, const Figure& figure) {
  const auto reading = biped_reading(request, figure);
  const auto rows = request.evidence->query(
      "SELECT network, mutation_rate, count(*) AS n, avg(final_total) AS final_total,\n"
      "  avg(final_total * final_total) AS squared\nFROM result WHERE " +
      reading.condition() + "\nGROUP BY network, mutation_rate ORDER BY network DESC, mutation_rate");
  if (rows.empty()) no_data(figure, {sweep_of(figure.name)});
  std::map<std::string, std::vector<std::vector<double>>> networks;
  std::uint64_t trials = 0;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    trials = static_cast<std::uint64_t>(rows.number(row, "n").value_or(0));
    const double mean = rows.number(row, "final_total").value_or(0);
    const auto interval = statistics::mean_interval(
        statistics::sample_of_moments(trials, mean, rows.number(row, "squared").value_or(0)), 0.95);
    const double half = interval ? interval->high - interval->estimate : 0;
    networks[network_name(rows.text(row, "network"))].push_back(
        {rows.number(row, "mutation_rate").value_or(0), mean, half});
  }
  std::string data;
  std::vector<std::string> items;
  for (const auto& [name, points] : networks) {
    const std::string block = "network" + std::to_string(items.size());
    data += data_block(block, points);
    items.push_back("$" + block +
                    " using 1:2:3 with yerrorlines pointtype 7 pointsize 0.7 linewidth 1.8 linecolor rgb " +
                    in_quotes(colour_of(items.size())) + " title " + in_quotes(name));
  }
  const std::string note = reading.sweeps.front() + (reading.text().empty() ? "" : ", " + reading.text()) + ", " +
                           output::counted(trials, "trial", "trials") + " each, 95 % intervals";
  return {.script = common_style() + data +
                    labels("Biped, genetic algorithm: mutation rates\n" + note, "mutation rate, % of the genes",
                           "mean final fitness (eq. 6.4)") +
                    "set xtics 12.5\nset key tmargin center horizontal\nset offsets 4, 4, graph 0.05, graph 0.05\n" +
                    plot_command(items),
          .width = 860,
          .height = 540};
}

namespace {

std::string jobs_condition(const std::vector<std::uint64_t>& jobs) {
  if (jobs.empty()) return "";
  std::string list;
  for (const auto job : jobs) list += (list.empty() ? "" : ", ") + std::to_string(job);
  return "job IN (" + list + ")";
}

constexpr std::size_t most_curves = 12;

}  // namespace

Picture fitness_of_jobs(const Request& request, const Figure& figure) {
  std::vector<std::vector<std::string>> sweeps;
  for (const auto& sweep : request.evidence->sweeps()) sweeps.push_back({sweep.what.name});
  // Jobs of different readings, or of different lengths, have no course in common.
  std::vector<std::string> readings = {"posture", "criterion", "temperature", "cycles"};
  if (request.average_by) std::erase(readings, *request.average_by);
  const auto reading = chosen_reading(request, figure, sweeps, readings);
  if (request.average_by && !request.evidence->has_column("result", *request.average_by))
    throw Failure(exit_usage, "unknown_column", "the view 'result' has no column '" + *request.average_by + "'");
  std::vector<std::string> group_by;
  if (request.average_by) {
    group_by = {*request.average_by};
  } else if (!request.jobs.empty()) {
    group_by = {"job"};
  }
  const auto all = courses(*request.evidence, reading, group_by, jobs_condition(request.jobs), false);
  if (all.empty()) no_data(figure, {});
  if (all.size() > most_curves) {
    throw Failure(exit_usage, "too_many_curves",
                  std::to_string(all.size()) + " curves are more than the " + std::to_string(most_curves) +
                      " that can be told apart; average them with --average-by");
  }
  std::string data;
  std::vector<std::string> items;
  double expected = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& course = all[i];
    expected = course.expected;
    std::vector<std::vector<double>> rows;
    for (std::size_t k = 0; k < course.cycles.size(); ++k) rows.push_back({course.cycles[k], course.total[k]});
    data += data_block("course" + std::to_string(i), rows);
    std::string title = group_by.empty() ? "mean" : group_by.front() + " " + course.group.front();
    if (course.jobs > 1) title += " (mean of " + output::counted(course.jobs, "job", "jobs") + ")";
    items.push_back("$course" + std::to_string(i) + " using 1:2 with steps linewidth 1.8 dashtype " +
                    std::to_string(1 + i / 7) + " linecolor rgb " + in_quotes(colour_of(i)) + " title " +
                    in_quotes(title));
  }
  const bool same_expected =
      std::ranges::all_of(all, [&](const auto& course) { return course.expected == expected && expected != 0; });
  if (same_expected) {
    items.push_back(number(expected) + " with lines linecolor rgb " + in_quotes(colour::black) +
                    " dashtype 2 linewidth 1.2 title " + in_quotes("expected " + number(expected)));
  }
  std::string note = reading.text();
  return {.script = common_style() + data +
                    labels("Total fitness: " + reading.sweeps.front() + (note.empty() ? "" : "\n" + note),
                           "cycles (evaluations)", "total fitness (eqs 6.4, 7.4)") +
                    "set key tmargin center horizontal maxrows 4\n" + plot_command(items),
          .width = 900,
          .height = 560};
}

}  // namespace lamprey::client::plot
