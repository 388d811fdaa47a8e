#include "client/parameter_settings.hpp"
#include "client/plot/figures.hpp"
#include "client/plot/script.hpp"
#include "experiment/gait_recording.hpp"
#include "science/problems/output_agreement.hpp"

#include <algorithm>
#include <cmath>

/// Figures 7.17, 7.22, 7.26 (b) and (c), appendix D: what a network puts out, and where the legs are.
namespace lamprey::client::plot {

namespace {

using science::robots::Recording;

experiment::Parameters parameters_of(const Request& request, std::vector<std::pair<std::string, std::string>> first) {
  for (const auto& setting : request.settings) first.push_back(setting);
  return parameters_of_settings(first);
}

/// What the recording is of, for a title: "quadruped, four_mother, walk".
std::string subject(const experiment::Parameters& parameters) {
  std::string text;
  for (const std::string name : {"robot", "network", "neuron", "gait"}) {
    const auto row = experiment::parameter_index(name);
    if (parameters.applies(row)) text += (text.empty() ? "" : ", ") + experiment::to_text(parameters[row]);
  }
  return text;
}

std::vector<double> column(const std::vector<std::vector<double>>& rows, std::size_t position) {
  std::vector<double> values;
  for (const auto& row : rows) values.push_back(row[position]);
  return values;
}

/// Rows (step, offset + value) of a line that keeps each value for its whole step, from step `first` on.
std::vector<std::vector<double>> staircase(const std::vector<double>& values, double offset) {
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i < values.size(); ++i) {
    rows.push_back({static_cast<double>(i), offset + values[i]});
    rows.push_back({static_cast<double>(i + 1), offset + values[i]});
  }
  return rows;
}

struct Lane {
  std::string name;
  std::vector<double> output;
  std::vector<double> wanted;  ///< empty where nothing is
};

/// Lanes below each other, each with its levels -1, 0 and +1.
Picture lanes_picture(const std::string& title, const std::vector<Lane>& lanes) {
  constexpr double apart = 3;
  std::string data;
  std::string tics;
  std::vector<std::string> items;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const double offset = -apart * static_cast<double>(i);
    const std::string block = "lane" + std::to_string(i);
    tics += (i > 0 ? ", " : "") + in_quotes(lanes[i].name) + " " + number(offset);
    items.push_back(number(offset) + " with lines linewidth 0.6 linecolor rgb '#D5DBE2' notitle");
    if (!lanes[i].wanted.empty()) {
      data += data_block(block + "wanted", staircase(lanes[i].wanted, offset));
      items.push_back("$" + block + "wanted using 1:2 with lines linewidth 4 linecolor rgb " +
                      in_quotes(colour::orange) + (i == 0 ? " title 'wanted (fig. 7.13)'" : " notitle"));
    }
    data += data_block(block, staircase(lanes[i].output, offset));
    items.push_back("$" + block + " using 1:2 with lines linewidth 1.6 linecolor rgb " + in_quotes(colour::blue) +
                    (i == 0 ? " title 'output'" : " notitle"));
  }
  const double lowest = -apart * static_cast<double>(lanes.size() - 1) - 1.6;
  return {.script = common_style() + data + labels(title, "time step (each lane: +1 up, 0 on its line, -1 down)", "") +
                    "set grid noytics xtics\n" +
                    (lanes.front().wanted.empty() ? "unset key" : "set key tmargin center horizontal") +
                    "\nset yrange [" + number(lowest) + ":1.6]\nset ytics (" + tics + ") scale 0\n" +
                    plot_command(items),
          .width = 980,
          .height = 150 + 62 * static_cast<int>(lanes.size())};
}

std::vector<Lane> lanes_of(const Recording& recording) {
  std::vector<Lane> lanes;
  for (std::size_t i = 0; i < recording.servos.size(); ++i)
    lanes.push_back({.name = recording.servos[i], .output = column(recording.outputs, i), .wanted = {}});
  return lanes;
}

}  // namespace

Picture outputs_against_wanted(const Request& request, const Figure& figure) {
  const bool recurrent = figure.name == "7-17";
  std::vector<std::pair<std::string, std::string>> first = {{"network", recurrent ? "recurrent_eight" : "one_mother"},
                                                            {"gait", "walk_frames"}};
  const auto parameters = parameters_of(request, first);
  const auto steps = request.time_steps > 0 ? request.time_steps : 18;
  const auto recording = experiment::record_gait(parameters, steps);
  const auto wanted = science::problems::figure_7_13_outputs();
  auto lanes = lanes_of(recording);
  int agreeing = 0;
  for (std::size_t i = 0; i < lanes.size() && i < wanted.front().size(); ++i) {
    for (std::size_t t = 0; t < lanes[i].output.size(); ++t) {
      lanes[i].wanted.push_back(wanted[t % wanted.size()][i]);
      agreeing += lanes[i].output[t] == lanes[i].wanted.back() ? 1 : 0;
    }
  }
  const double share = std::round(1000.0 * agreeing / (static_cast<double>(lanes.size()) * steps)) / 10;
  return lanes_picture(
      "Outputs against those wanted of the walk: " + subject(parameters) + ", " + number(share) + " % agree", lanes);
}

Picture network_output(const Request& request, const Figure&) {
  const auto parameters = parameters_of(request, {});
  const auto recording = experiment::record_gait(parameters, request.time_steps > 0 ? request.time_steps : 100);
  return lanes_picture("Network output: " + subject(parameters), lanes_of(recording));
}

Picture leg_positions(const Request& request, const Figure&) {
  const auto parameters = parameters_of(request, {});
  const auto recording = experiment::record_gait(parameters, request.time_steps > 0 ? request.time_steps : 100);
  // A panel per leg: servos whose names differ in their last word only, or a servo alone.
  std::vector<std::pair<std::string, std::vector<std::size_t>>> legs;
  for (std::size_t i = 0; i < recording.servos.size(); ++i) {
    std::string leg = recording.servos[i];
    for (const std::string servo : {" vertical", " horizontal"}) {
      if (leg.ends_with(servo)) leg.resize(leg.size() - servo.size());
    }
    const auto found = std::ranges::find(legs, leg, &std::pair<std::string, std::vector<std::size_t>>::first);
    (found == legs.end() ? legs.emplace_back(leg, std::vector<std::size_t>{}) : *found).second.push_back(i);
  }
  std::string data;
  std::string plots;
  for (const auto& [leg, servos] : legs) {
    std::vector<std::string> items;
    for (const std::size_t servo : servos) {
      std::vector<std::vector<double>> rows;
      const auto positions = column(recording.positions, servo);
      for (std::size_t t = 0; t < positions.size(); ++t) rows.push_back({static_cast<double>(t), positions[t]});
      const std::string block = "servo" + std::to_string(servo);
      data += data_block(block, rows);
      const bool vertical = recording.servos[servo].ends_with("vertical");
      items.push_back(
          "$" + block + " using 1:2 with lines linewidth 2 linecolor rgb " +
          in_quotes(vertical ? colour::vermilion : colour::blue) + " title " +
          in_quotes(recording.servos[servo].substr(std::min(leg.size() + 1, recording.servos[servo].size()))));
    }
    plots += labels(leg, "time step", "position (0 to 30)") +
             (servos.size() > 1 ? "set key top right horizontal\n" : "unset key\n") + plot_command(items);
  }
  const int rows = static_cast<int>((legs.size() + 1) / 2);
  return {.script = common_style() + data + multiplot(rows, 2, "Positions of the legs: " + subject(parameters), "") +
                    "set yrange [0:30]\nset ytics 5\n" + plots,
          .width = 980,
          .height = 80 + 300 * rows};
}

}  // namespace lamprey::client::plot
