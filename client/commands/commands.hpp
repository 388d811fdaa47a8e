#pragma once

#include "client/command.hpp"

/// Each declares its arguments and options on the app and returns what the command does.
namespace lamprey::client::commands {

Action declare_cancel(CLI::App& app);
Action declare_evaluate(CLI::App& app);
Action declare_parameters(CLI::App& app);
Action declare_plan(CLI::App& app);
Action declare_plot(CLI::App& app);
Action declare_replay(CLI::App& app);
Action declare_report(CLI::App& app);
Action declare_results(CLI::App& app);
Action declare_run(CLI::App& app);
Action declare_status(CLI::App& app);
Action declare_submit(CLI::App& app);
Action declare_verify(CLI::App& app);

}  // namespace lamprey::client::commands
