#include "client/commands/commands.hpp"

#include <array>

namespace lamprey::client {

namespace {

const std::vector<std::string_view> table_or_json = {"table", "json"};
const std::vector<std::string_view> text_or_json = {"text", "json"};

constexpr std::string_view alone = "On this machine";
constexpr std::string_view looking = "Look and try out";
constexpr std::string_view findings = "What it shows";
constexpr std::string_view together = "With a coordinator on the network";
constexpr std::string_view steering = "Steer sweeps and workers";
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
      Command{"backup", alone, "Copy a database while a coordinator writes it", table_or_json,
              commands::declare_backup},
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
      Command{"watch", together, "Keep sweeps, workers and events in sight until Ctrl-C", table_or_json,
              commands::declare_watch},
      Command{"workers", together, "Show the workers and what they are computing", table_or_json,
              commands::declare_workers},
      Command{"trace",
              together,
              "Show one job's accepted changes, also while it runs",
              {"table", "json", "csv"},
              commands::declare_trace},
      Command{"events", together, "Show what has happened: losses, divergences, people's wishes", table_or_json,
              commands::declare_events},
      Command{"metrics", together, "Print the coordinator's counters for Prometheus", text_or_json,
              commands::declare_metrics},
      Command{"net", together, "Show who is in the DDS domain, and who fails to meet whom", table_or_json,
              commands::declare_net},
      Command{"doctor", together, "Look for what keeps programs from meeting, and say what to do", text_or_json,
              commands::declare_doctor},
      Command{"pause", steering, "Stop a sweep for a while; its running jobs keep what they have done", table_or_json,
              commands::declare_pause},
      Command{"resume", steering, "Let a paused sweep go on", table_or_json, commands::declare_resume},
      Command{"cancel", steering, "Cancel the jobs of a sweep that have not ended", table_or_json,
              commands::declare_cancel},
      Command{"retry", steering, "Try the failed and quarantined jobs of a sweep again", table_or_json,
              commands::declare_retry},
      Command{"adjust", steering, "Change a sweep's priority, or how many of its jobs run at once", table_or_json,
              commands::declare_adjust},
      Command{"rename", steering, "Give a sweep another name", table_or_json, commands::declare_rename},
      Command{"archive", steering, "Put a sweep that has ended out of sight", table_or_json, commands::declare_archive},
      Command{"delete", steering, "Delete a sweep that has ended, with its results", table_or_json,
              commands::declare_delete},
      Command{"drain", steering, "Send a worker home: it finishes what it holds and leaves", table_or_json,
              commands::declare_drain},
      Command{"bridge", steering, "Look at robots, stop them, turn their servos on and off", table_or_json,
              commands::declare_bridge},
      Command{"replay", checking, "Compute a stored job again and compare the outcome, bit by bit", table_or_json,
              commands::declare_replay},
      Command{"verify", checking, "Check a whole database against itself: digests, identities, counters", table_or_json,
              commands::declare_verify},
      Command{"audit", checking, "Let other workers compute finished jobs again, and compare", table_or_json,
              commands::declare_audit},
  };
  return rows;
}

}  // namespace lamprey::client
