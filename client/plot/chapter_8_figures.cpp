#include "client/plot/figures.hpp"
#include "client/plot/script.hpp"

#include <algorithm>
#include <array>
#include <cmath>

/// Figures 8.3 to 8.10: the operators of the RTEA over the published grid.
namespace lamprey::client::plot {

namespace {

const std::vector<std::vector<std::string>> grid_sweeps = {
    {"thesis-chapter-8"},      {"mutate-all", "mutate-one", "mutate-some"},
    {"chapter-8-carry"},       {"chapter-8-total"},
    {"chapter-8-carry-total"}, {"appendix-b"}};
const std::vector<std::string> grid_readings = {"posture", "criterion", "temperature", "cycles"};

std::string with_reading(const std::string& note, const Reading& reading) {
  std::string sweeps;
  for (const auto& sweep : reading.sweeps) sweeps += (sweeps.empty() ? "" : ", ") + sweep;
  return note + " - " + sweeps + ": " + reading.text();
}

/// One panel of bars: which jobs.
struct Panel {
  std::string title;
  std::string condition;
};

std::vector<Panel> panels_of(std::string_view figure) {
  std::vector<Panel> panels;
  const auto add = [&](const std::string& mutation, const std::string& steps, const std::string& title) {
    for (const std::string acceptance : {"simple", "annealing"}) {
      panels.push_back({title + ", " + acceptance, "mutation = '" + mutation + "' AND steps = '" + steps +
                                                       "' AND acceptance = '" + acceptance + "'"});
    }
  };
  if (figure == "8-10") {
    for (const std::string mutation : {"all", "one", "some"}) add(mutation, "one_fifth_rule", "mutate " + mutation);
    return panels;
  }
  const std::string mutation = figure == "8-3" ? "all" : figure == "8-4" ? "one" : "some";
  for (const std::string steps : {"normal", "uniform"}) add(mutation, steps, steps);
  return panels;
}

constexpr std::array scores = {"expected", "evolved", "highest"};

/// Chapter 8 has one network and one trainer; a sweep that the user names may have others. Databases of older versions
/// know the one trainer only.
std::string of_published_system(const Evidence& evidence) {
  return std::string(" AND network = 'four_mother'") +
         (evidence.has_column("result", "trainer") ? " AND trainer = 'rtea'" : "");
}

std::string bars_sql(const Evidence& evidence, const Reading& reading, const Panel& panel) {
  std::string sql = "SELECT count(*) AS jobs, 100 * avg(success_rate) AS success";
  for (const std::string score : scores) {
    for (const std::string part : {"stability", "distance", "fuel"}) {
      sql += ",\n  avg(required_" + part + " / 100.0 * " + score + "_" + part + ") AS " + score + "_" + part;
    }
    sql += ", avg(" + score + "_total) AS " + score + "_total";
  }
  return sql + "\nFROM result WHERE " + reading.condition() + of_published_system(evidence) + " AND " + panel.condition;
}

/// Rows of a histogram: stability, distance, fuel, total; a column per score. Empty without jobs.
std::vector<std::vector<double>> bars_of(const Rows& rows) {
  std::vector<std::vector<double>> bars;
  if (rows.empty() || rows.number(0, "jobs").value_or(0) == 0) return bars;
  for (const std::string part : {"stability", "distance", "fuel", "total"}) {
    auto& bar = bars.emplace_back();
    for (const std::string score : scores) bar.push_back(rows.number(0, score + "_" + part).value_or(std::nan("")));
  }
  return bars;
}

std::string bar_panel(const std::string& name, const std::string& title, bool legend) {
  std::string script = labels(title, "", "mean weighted fitness");
  script += legend ? "set key inside left top vertical reverse Left samplen 1.2\n" : "unset key\n";
  std::vector<std::string> items;
  constexpr std::array fills = {colour::grey, colour::blue, colour::orange};
  for (std::size_t i = 0; i < scores.size(); ++i) {
    const double offset = (static_cast<double>(i) - 1) * 0.27;
    items.push_back("$" + name + " using ($0 + " + number(offset) + "):" + std::to_string(i + 1) +
                    " with boxes linecolor rgb " + in_quotes(fills[i]) + " title " + in_quotes(scores[i]));
    items.push_back("$" + name + " using ($0 + " + number(offset) + "):" + std::to_string(i + 1) +
                    ":(sprintf('%.3g', $" + std::to_string(i + 1) + ")) with labels offset 0,0.5 font ',9' notitle");
  }
  return script + plot_command(items);
}

}  // namespace

Picture operator_bars(const Request& request, const Figure& figure) {
  const auto reading = chosen_reading(request, figure, grid_sweeps, grid_readings);
  const auto panels = panels_of(figure.name);
  std::string data;
  std::string plots;
  bool any = false;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const auto rows = request.evidence->query(bars_sql(*request.evidence, reading, panels[i]));
    const auto bars = bars_of(rows);
    if (bars.empty()) continue;
    const std::string name = "bars" + std::to_string(i);
    data += data_block(name, bars);
    const std::string title = panels[i].title + ": success rate " +
                              number(std::round(rows.number(0, "success").value_or(0) * 100) / 100) + " %";
    plots += bar_panel(name, title, !any);
    any = true;
  }
  if (!any) no_data(figure, {"thesis-chapter-8"});
  const std::string mutation = figure.name == "8-3"   ? "mutate all"
                               : figure.name == "8-4" ? "mutate one"
                                                      : "mutate some";
  const std::string title = figure.name == "8-10" ? "1/5 rule" : mutation + ": normal and uniform steps";
  return {.script = common_style() + data +
                    multiplot(figure.name == "8-10" ? 3 : 2, 2, title, with_reading("means over the grid", reading)) +
                    "set boxwidth 0.25\nset xrange [-0.6:3.6]\nset yrange [0:*]\nset offsets 0, 0, graph 0.25, 0\n"
                    "set xtics ('stability' 0, 'distance' 1, 'fuel' 2, 'total' 3) scale 0\n" +
                    plots,
          .width = 980,
          .height = figure.name == "8-10" ? 1020 : 720};
}

namespace {

struct Surface {
  std::string mutation;
  std::vector<std::vector<double>> evolved;  ///< disturbance, mutation size, evolved, highest; lines of a grid
  double expected = 0;
};

std::string surface_sql(const Evidence& evidence, const Reading& reading, std::string_view figure) {
  const bool normal = figure == "8-6" || figure == "8-7";
  const bool annealing = figure == "8-7" || figure == "8-9";
  return "SELECT mutation, equilibrium_disturbance AS disturbance, mutation_size AS size, avg(expected_total) AS "
         "expected,\n"
         "  avg(evolved_total) AS evolved, avg(highest_total) AS highest\nFROM result WHERE " +
         reading.condition() + of_published_system(evidence) + " AND steps = '" + (normal ? "normal" : "uniform") +
         "' AND acceptance = '" + (annealing ? "annealing" : "simple") +
         "'\nGROUP BY mutation, disturbance, size ORDER BY mutation, disturbance, size";
}

std::vector<Surface> surfaces_of(const Rows& rows) {
  std::vector<Surface> surfaces;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const auto mutation = rows.text(row, "mutation");
    if (surfaces.empty() || surfaces.back().mutation != mutation)
      surfaces.push_back({.mutation = mutation, .evolved = {}});
    auto& surface = surfaces.back();
    surface.expected = rows.number(row, "expected").value_or(0);
    surface.evolved.push_back({rows.number(row, "disturbance").value_or(0), rows.number(row, "size").value_or(0),
                               rows.number(row, "evolved").value_or(std::nan("")),
                               rows.number(row, "highest").value_or(std::nan(""))});
  }
  return surfaces;
}

/// A block of data whose scan lines, one per disturbance, are parted by an empty line, as `splot` wants them.
std::string grid_block(const std::string& name, const Surface& surface) {
  std::string text = "$" + name + " << EOD\n";
  for (std::size_t i = 0; i < surface.evolved.size(); ++i) {
    const auto& row = surface.evolved[i];
    if (i > 0 && row[0] != surface.evolved[i - 1][0]) text += '\n';
    for (const double value : row) text += number(value) + " ";
    text += '\n';
  }
  return text + "EOD\n";
}

std::string surface_panel(const std::string& name, const Surface& surface) {
  return "set title " + in_quotes("mutate " + surface.mutation + ": evolved total") +
         "\nset xlabel 'disturbance, %' offset 1,-0.7 font ',11'\nset ylabel 'mutation size, %' offset -1,-0.7 font "
         "',11'\nset zlabel ''\n"
         "set xrange [25:100]\nset yrange [25:100]\nset xtics 25,25,100 offset 1.2,-0.3\nset ytics 25,25,100 offset "
         "-1.2,-0.3\n"
         "unset key\nset hidden3d front\nset view 62,322\nset border 127+256+512\nset xyplane 0\n"
         "splot $" +
         name + " using 1:2:3 with lines linecolor rgb " + in_quotes(colour::blue) + " linewidth 1.6\n";
}

std::string points_panel(const std::string& name, const Surface& surface) {
  std::string tics;
  for (std::size_t i = 0; i < surface.evolved.size(); ++i) {
    const auto& row = surface.evolved[i];
    tics += (i > 0 ? ", " : "") + in_quotes("E" + number(row[0]) + " x R" + number(row[1])) + " " + std::to_string(i);
  }
  return "set title " + in_quotes("mutate " + surface.mutation) +
         "\nset xlabel ''\nset ylabel 'mean total' offset 0,0 font ',13'\nset border 3\nset key top left reverse Left "
         "samplen 1.5\n"
         "set xrange [-0.5:" +
         std::to_string(surface.evolved.size()) + "]\nset xtics rotate by 90 right (" + tics +
         ") offset 0,0 font ',9'\nset ytics auto offset 0,0 font ',11'\n" +
         plot_command({number(surface.expected) + " with lines linecolor rgb " + in_quotes(colour::black) +
                           " dashtype 2 linewidth 1.4 title " + in_quotes("expected " + number(surface.expected)),
                       "$" + name + "list using 0:3 with linespoints linecolor rgb " + in_quotes(colour::blue) +
                           " pointtype 7 pointsize 0.7 linewidth 1.6 title 'evolved'",
                       "$" + name + "list using 0:4 with linespoints linecolor rgb " + in_quotes(colour::orange) +
                           " pointtype 5 pointsize 0.6 linewidth 1.6 title 'highest'"});
}

}  // namespace

Picture disturbance_surfaces(const Request& request, const Figure& figure) {
  const auto reading = chosen_reading(request, figure, grid_sweeps, grid_readings);
  const auto surfaces = surfaces_of(request.evidence->query(surface_sql(*request.evidence, reading, figure.name)));
  if (surfaces.empty()) no_data(figure, {"thesis-chapter-8"});
  double low = surfaces.front().expected;
  double high = low;
  std::string data;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const std::string name = "cells" + std::to_string(i);
    data += grid_block(name, surfaces[i]) + data_block(name + "list", surfaces[i].evolved);
    for (const auto& row : surfaces[i].evolved) {
      low = std::min(low, row[2]);
      high = std::max({high, row[2], row[3]});
    }
  }
  low = std::floor(low / 10) * 10 - 10;
  const double top = std::ceil(high / 10) * 10;
  const bool normal = figure.name == "8-6" || figure.name == "8-7";
  const bool annealing = figure.name == "8-7" || figure.name == "8-9";
  const std::string title = std::string(normal ? "Normal" : "Uniform") + " steps, " +
                            (annealing ? "annealing" : "simple acceptance") + ": disturbance against mutation size";
  std::string script = common_style() + data +
                       multiplot(2, static_cast<int>(surfaces.size()), title,
                                 with_reading("each point a mean of the grid's cells", reading));
  script += "set zrange [" + number(low) + ":" + number(top) + "]\nset ztics font ',9'\n";
  for (std::size_t i = 0; i < surfaces.size(); ++i) script += surface_panel("cells" + std::to_string(i), surfaces[i]);
  script += "set yrange [" + number(low) + ":" + number(top + (top - low) * 0.6) + "]\n";
  for (std::size_t i = 0; i < surfaces.size(); ++i) script += points_panel("cells" + std::to_string(i), surfaces[i]);
  return {.script = script, .width = 420 * static_cast<int>(surfaces.size()), .height = 820};
}

}  // namespace lamprey::client::plot
