#pragma once

#include "client/command.hpp"

/// Each declares its arguments and options on the app and returns what the command does.
namespace lamprey::client::commands {

Action declare_adjust(CLI::App& app);
Action declare_archive(CLI::App& app);
Action declare_audit(CLI::App& app);
Action declare_bridge(CLI::App& app);
Action declare_backup(CLI::App& app);
Action declare_cancel(CLI::App& app);
Action declare_delete(CLI::App& app);
Action declare_doctor(CLI::App& app);
Action declare_drain(CLI::App& app);
Action declare_evaluate(CLI::App& app);
Action declare_events(CLI::App& app);
Action declare_metrics(CLI::App& app);
Action declare_net(CLI::App& app);
Action declare_parameters(CLI::App& app);
Action declare_pause(CLI::App& app);
Action declare_plan(CLI::App& app);
Action declare_plot(CLI::App& app);
Action declare_rename(CLI::App& app);
Action declare_replay(CLI::App& app);
Action declare_report(CLI::App& app);
Action declare_results(CLI::App& app);
Action declare_resume(CLI::App& app);
Action declare_retry(CLI::App& app);
Action declare_run(CLI::App& app);
Action declare_status(CLI::App& app);
Action declare_submit(CLI::App& app);
Action declare_trace(CLI::App& app);
Action declare_verify(CLI::App& app);
Action declare_watch(CLI::App& app);
Action declare_workers(CLI::App& app);

}  // namespace lamprey::client::commands
