#include "client/commands/commands.hpp"

#include <array>

namespace lamprey::client {

namespace {

const std::vector<std::string_view> table_or_json = {"table", "json"};

constexpr std::string_view alone = "On this machine";
constexpr std::string_view looking = "Look and try out";
constexpr std::string_view findings = "What it shows";
constexpr std::string_view together = "With a coordinator on the network";
constexpr std::string_view checking = "Check";

}  // namespace

std::span<const Command> command_table() {
  static const std::array rows = {
      Command{"plan", alone, "Show which jobs a sweep file stands for; runs and changes nothing", table_or_json,
              commands::declare_plan},
      Command{"run", alone, "Run a whole sweep on this machine into one database; goes on where it ended",
              table_or_json, commands::declare_run},
      Command{"results",
              alone,
              "Show a sweep's outcomes, from a database or a coordinator",
              {"table", "json", "csv"},
              commands::declare_results},
      Command{"parameters", looking, "List all parameters of experiments: meanings, ranges, defaults, sources",
              table_or_json, commands::declare_parameters},
      Command{"evaluate", looking, "Evaluate the undisturbed gait once and show its fitness", table_or_json,
              commands::declare_evaluate},
      Command{"report",
              findings,
              "Hold the thesis's claims against a database: measured, interval, holds or not",
              {"text", "json", "html"},
              commands::declare_report},
      Command{"plot", findings, "Draw a figure of the thesis from a database, or the robot with its gait",
              table_or_json, commands::declare_plot},
      Command{"submit", together, "Give a sweep to the coordinator; its workers run it", table_or_json,
              commands::declare_submit},
      Command{"status", together, "Show the coordinator's sweeps and workers", table_or_json, commands::declare_status},
      Command{"cancel", together, "Cancel the jobs of a sweep that have not ended", table_or_json,
              commands::declare_cancel},
      Command{"replay", checking, "Compute a stored job again and compare the outcome, bit by bit", table_or_json,
              commands::declare_replay},
      Command{"verify", checking, "Check a whole database against itself: digests, identities, counters", table_or_json,
              commands::declare_verify},
  };
  return rows;
}

}  // namespace lamprey::client
