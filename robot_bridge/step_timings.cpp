#include "robot_bridge/step_timings.hpp"

#include <algorithm>
#include <sstream>

namespace lamprey::robot_bridge {

StepTimings::Step& StepTimings::step(std::uint32_t time_step) {
  const std::size_t number = std::min(time_step, most_steps - 1);
  if (number >= steps_.size()) steps_.resize(number + 1);
  return steps_[number];
}

void StepTimings::add(std::uint32_t time_step, std::chrono::nanoseconds command_to_line,
                      std::chrono::nanoseconds line_to_state) {
  Step& known = step(time_step);
  known.command_to_line.add(command_to_line);
  known.line_to_state.add(line_to_state);
}

void StepTimings::add_jitter(std::uint32_t time_step, std::chrono::nanoseconds jitter, bool late) {
  Step& known = step(time_step);
  known.jitter.add(jitter);
  known.late += std::uint64_t{late};
}

std::string to_csv(const StepTimings& timings) {
  std::ostringstream text;
  text << "time_step,part,count,late,median,percentile_99,largest\n";
  for (std::size_t number = 0; number < timings.steps().size(); ++number) {
    const auto& step = timings.steps()[number];
    const auto line = [&](const char* part, const Histogram& histogram, const std::string& late) {
      text << number << ',' << part << ',' << histogram.count() << ',' << late << ',' << histogram.quantile(0.5).count()
           << ',' << histogram.quantile(0.99).count() << ',' << histogram.largest().count() << '\n';
    };
    line("command_to_line", step.command_to_line, "");
    line("line_to_state", step.line_to_state, "");
    line("jitter", step.jitter, std::to_string(step.late));
  }
  return text.str();
}

}  // namespace lamprey::robot_bridge
