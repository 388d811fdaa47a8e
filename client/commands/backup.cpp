#include "storage/backup.hpp"

#include "client/commands/commands.hpp"
#include "client/json.hpp"
#include "client/output/formatting.hpp"
#include "client/output/progress.hpp"

#include <chrono>
#include <memory>
#include <string>

namespace lamprey::client::commands {

namespace {

struct Options {
  std::string database;
  std::string target;
  bool replace = false;
  bool quiet = false;
};

/// "12.3 MB", "4.1 kB" of a small file.
std::string size_text(std::uint64_t bytes) {
  constexpr std::uint64_t kilobyte = 1'000;
  constexpr std::uint64_t megabyte = 1'000'000;
  const bool small = bytes < megabyte;
  const auto tenths = bytes / ((small ? kilobyte : megabyte) / 10);
  return output::with_thousands(tenths / 10) + "." + std::to_string(tenths % 10) + (small ? " kB" : " MB");
}

ExitCode backup(const Options& options, const Context& context) {
  output::ProgressDisplay display(context.console, options.quiet);
  const auto copied = storage::back_up(
      options.database, options.target, {.replace = options.replace}, [&](std::uint64_t done, std::uint64_t all) {
        const auto percent = all == 0 ? 100 : 100 * done / all;
        display.show("copying  " + std::to_string(percent) + " %", std::chrono::steady_clock::now());
      });
  display.clear();
  if (context.format == Format::json) {
    Json json = document("backup");
    json["database"] = options.database;
    json["target"] = options.target;
    json["sweeps"] = copied.sweeps;
    json["jobs"] = copied.jobs;
    json["bytes"] = copied.bytes;
    json["schema_version"] = copied.schema_version;
    print(context.console, json);
  } else {
    context.console.out << options.target << ": " << output::counted(copied.sweeps, "sweep", "sweeps") << " with "
                        << output::counted(copied.jobs, "ended job", "ended jobs") << ", " << size_text(copied.bytes)
                        << ", schema version " << copied.schema_version << '\n';
  }
  return exit_ok;
}

}  // namespace

Action declare_backup(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Copies a results database as it is at one moment, also while a coordinator writes it: what was committed before "
      "is in the copy. The copy is checked, and only when it is complete and on the disk does it get its name. Nothing "
      "that exists is replaced unless you say so, and then only a Lamprey database that nobody uses.");
  app.add_option("DATABASE", options->database, "Results database")->required();
  app.add_option("TARGET", options->target, "File that the copy becomes")->required();
  app.add_flag("--replace", options->replace, "Replace the database at TARGET");
  app.add_flag("-q,--quiet", options->quiet, "No progress");
  return [options](const Context& context) { return backup(*options, context); };
}

}  // namespace lamprey::client::commands
