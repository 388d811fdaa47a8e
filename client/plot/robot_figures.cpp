#include "client/failure.hpp"
#include "client/parameter_settings.hpp"
#include "client/plot/figures.hpp"
#include "client/plot/script.hpp"
#include "experiment/gait_recording.hpp"

#include <algorithm>
#include <array>
#include <cmath>

/// Figures 7.26 (d) and (e), appendix D: the robot at several times.
namespace lamprey::client::plot {

namespace {

using science::robots::Recording;

/// Measures of the drawn robot, in positions of a leg (units of one step's move). The thesis's own drawings are lost.
constexpr double standing = 10;
constexpr double hip_height = 26;
constexpr double body_length = 44;
constexpr double body_width = 26;
constexpr int frames = 8;

struct Foot {
  std::string leg;
  double hip_x = 0;
  double hip_y = 0;  ///< across; 0 is the side that is nearer
  double x = 0;
  double height = 0;
  bool on_ground = false;
};

struct Frame {
  std::size_t step = 0;
  double distance = 0;
  std::vector<Foot> feet;
};

std::size_t servo_called(const Recording& recording, const std::string& name) {
  const auto found = std::ranges::find(recording.servos, name);
  if (found == recording.servos.end())
    throw Failure(exit_failure, "no_data", "the recording has no servo called '" + name + "'");
  return static_cast<std::size_t>(found - recording.servos.begin());
}

bool is_biped(const Recording& recording) {
  return recording.servos.size() == 2;
}

/// After so many steps; a foot is on the ground as it was during the step before.
Frame frame_after(const Recording& recording, std::size_t step) {
  Frame frame{.step = step, .distance = step > 0 ? recording.distance[step - 1] : 0, .feet = {}};
  const auto& positions = recording.positions[step];
  const auto on_ground = [&](std::size_t leg) {
    return step == 0 || ((recording.feet_on_ground[step - 1] >> leg) & 1U) != 0;
  };
  if (is_biped(recording)) {
    for (std::size_t leg = 0; leg < 2; ++leg)
      frame.feet.push_back({recording.servos[leg], 0, leg == 0 ? 0.0 : 8.0, positions[leg] - 15, 0, on_ground(leg)});
    return frame;
  }
  constexpr std::array names = {"front left", "front right", "back left", "back right"};
  for (std::size_t leg = 0; leg < names.size(); ++leg) {
    const std::string name = names[leg];
    const double hip = leg < 2 ? body_length / 2 : -body_length / 2;
    const double swing = positions[servo_called(recording, name + " horizontal")] - standing;
    const double lift = positions[servo_called(recording, name + " vertical")] - standing;
    frame.feet.push_back(
        {name, hip, leg % 2 == 0 ? 0.0 : body_width, hip + swing, std::max(lift, 0.0), on_ground(leg)});
  }
  return frame;
}

std::vector<Frame> frames_of(const Recording& recording, int count) {
  std::vector<Frame> all;
  const std::size_t steps = recording.positions.size() - 1;
  for (int i = 0; i < count; ++i)
    all.push_back(frame_after(recording, steps * static_cast<std::size_t>(i) / static_cast<std::size_t>(count - 1)));
  return all;
}

struct Subject {
  experiment::Parameters parameters;
  Recording recording;
  std::string title;
};

/// By default one period: of the walk 100 steps, of the other gaits 25, of the biped 20.
Subject subject_of(const Request& request) {
  Subject subject{.parameters = parameters_of_settings(request.settings), .recording = {}, .title = {}};
  const auto& parameters = subject.parameters;
  const bool biped = parameters.choice("robot") == "biped";
  const bool walks = !biped && parameters.choice("gait") == "walk";
  const std::int32_t period = biped ? 20 : walks ? 100 : 25;
  subject.recording = experiment::record_gait(parameters, request.time_steps > 0 ? request.time_steps : period);
  subject.title = biped ? "biped, " + parameters.choice("network") : "quadruped, " + parameters.choice("gait");
  return subject;
}

std::string frame_title(const Frame& frame) {
  return "after step " + std::to_string(frame.step) + ", distance " + number(frame.distance);
}

std::string line_2d(double x1, double y1, double x2, double y2, std::string_view colour, double width) {
  return "set arrow from " + number(x1) + "," + number(y1) + " to " + number(x2) + "," + number(y2) +
         " nohead linewidth " + number(width) + " linecolor rgb " + in_quotes(colour) + "\n";
}

std::string side_panel(const Frame& frame, bool biped) {
  std::string script = "unset arrow\nunset object\n";
  const double at = frame.distance;
  const double half = biped ? 6 : body_length / 2;
  // The far side first, so that the near one is drawn over it.
  for (const bool far : {true, false}) {
    for (const auto& foot : frame.feet) {
      if ((foot.hip_y > 0) != far) continue;
      const auto colour = far ? colour::orange : colour::blue;
      const double aside = far ? 2.5 : 0;  // what is behind shows beside what is in front of it
      script += line_2d(at + foot.hip_x + aside, hip_height, at + foot.x + aside, foot.height, colour, 3);
      script += "set object circle at " + number(at + foot.x + aside) + "," + number(foot.height) +
                " size 1.5 front fillstyle " + (foot.on_ground ? "solid 1" : "empty") + " border linecolor rgb " +
                in_quotes(colour) + " fillcolor rgb " + in_quotes(colour) + " linewidth 1.5\n";
    }
  }
  script += line_2d(at - half, hip_height, at + half + (biped ? 0 : 2.5), hip_height, colour::black, biped ? 6 : 5);
  const double reach = biped ? 24 : 44;
  script += "set title " + in_quotes(frame_title(frame)) + "\nset xrange [" + number(at - reach) + ":" +
            number(at + reach) + "]\n";
  return script + "plot 0 with lines linewidth 1 linecolor rgb " + in_quotes(colour::grey) + " notitle\n";
}

}  // namespace

Picture side_view(const Request& request, const Figure&) {
  const auto subject = subject_of(request);
  const bool biped = is_biped(subject.recording);
  std::string script =
      common_style() +
      multiplot(
          2, frames / 2, "Side view: " + subject.title,
          std::string(biped ? "leg 1 blue, leg 2 orange" : "left legs blue, right legs orange; front is on the right") +
              "; a filled foot is on the ground") +
      "unset key\nset grid noytics\nset size ratio -1\nset yrange [-4:34]\nset ytics 0,10,30\nset xtics 20\n"
      "set xlabel 'along the way, leg positions' font ',10'\nset ylabel 'height' font ',10'\n";
  for (const auto& frame : frames_of(subject.recording, frames)) script += side_panel(frame, biped);
  return {.script = script, .width = 1180, .height = 430};
}

namespace {

std::string line_3d(std::array<double, 3> from, std::array<double, 3> to, std::string_view colour, double width) {
  const auto point = [](const std::array<double, 3>& at) {
    return number(at[0]) + "," + number(at[1]) + "," + number(at[2]);
  };
  return "set arrow from " + point(from) + " to " + point(to) + " nohead front linewidth " + number(width) +
         " linecolor rgb " + in_quotes(colour) + "\n";
}

std::string space_panel(const Frame& frame, bool biped, const std::string& block) {
  const double half = biped ? 2 : body_length / 2;
  const double width = biped ? 8 : body_width;
  const double at = frame.distance;
  std::string script = "unset arrow\n";
  for (const auto& foot : frame.feet) {
    script += line_3d({at + foot.hip_x, foot.hip_y, hip_height}, {at + foot.x, foot.hip_y, foot.height},
                      foot.hip_y > 0 ? colour::orange : colour::blue, 3);
  }
  const std::array<std::array<double, 2>, 5> corners = {
      {{at - half, 0}, {at + half, 0}, {at + half, width}, {at - half, width}, {at - half, 0}}};
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    script += line_3d({corners[i][0], corners[i][1], hip_height}, {corners[i + 1][0], corners[i + 1][1], hip_height},
                      colour::black, 4);
  }
  const double reach = biped ? 24 : 40;
  return script + "set title " + in_quotes(frame_title(frame)) + "\nset xrange [" + number(at - reach) + ":" +
         number(at + reach) + "]\nset yrange [-8:" + number(width + 8) + "]\nsplot $" + block +
         "down using 1:2:3 with points pointtype 7 pointsize 1 linecolor rgb " + in_quotes(colour::black) +
         " notitle, $" + block + "up using 1:2:3 with points pointtype 6 pointsize 1 linecolor rgb " +
         in_quotes(colour::black) + " notitle\n";
}

}  // namespace

Picture view_in_space(const Request& request, const Figure&) {
  const auto subject = subject_of(request);
  const bool biped = is_biped(subject.recording);
  const auto shown = frames_of(subject.recording, 6);
  std::string data;
  std::string panels;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const std::string block = "feet" + std::to_string(i);
    for (const bool down : {true, false}) {
      std::vector<std::vector<double>> points;
      for (const auto& foot : shown[i].feet) {
        if (foot.on_ground == down) points.push_back({shown[i].distance + foot.x, foot.hip_y, foot.height});
      }
      if (points.empty()) points.push_back({std::nan(""), std::nan(""), std::nan("")});
      data += data_block(block + (down ? "down" : "up"), points);
    }
    panels += space_panel(shown[i], biped, block);
  }
  return {
      .script = common_style() + data +
                multiplot(2, 3, "3D view: " + subject.title,
                          std::string(biped ? "leg 1 blue, leg 2 orange" : "left legs blue, right legs orange") +
                              "; a filled foot is on the ground; axes along the way, across and up, in leg positions") +
                "unset key\nset view 66,335,1.55\nset view equal xyz\nset xyplane at 0\nset zrange [0:30]\nset ztics "
                "10\nset ytics 20\n"
                "set xtics 20\nset grid x y linetype 1 linecolor rgb '#E3E8EE'\nset border 1+2+4+8+16\n"
                "set xlabel 'along the way' font ',10' offset 0,-1\n" +
                panels,
      .width = 1180,
      .height = 680};
}

}  // namespace lamprey::client::plot
