#include "client/commands/commands.hpp"
#include "client/failure.hpp"
#include "client/follow.hpp"
#include "client/json.hpp"
#include "client/option_checks.hpp"
#include "client/output/formatting.hpp"
#include "client/output/progress.hpp"
#include "client/output/table.hpp"

#include <limits>
#include <memory>
#include <string>

namespace lamprey::client::commands {

namespace {

struct Options {
  std::string sweep;
  std::string share = "5%";
  std::uint64_t seed = 1;
  bool no_wait = false;
  bool quiet = false;
  ConnectionOptions connection;
};

idl::Request audit_request(const Options& options) {
  idl::Request request;
  auto& audit = *request.mutable_audit();
  audit.set_sweep(options.sweep);
  audit.set_share(share_of(options.share));
  audit.set_seed(options.seed);
  return request;
}

bool has_ended(const idl::AuditStatus& audit) {
  return audit.state() == "finished";
}

std::string waiting_text(const idl::AuditStatus& audit) {
  const auto jobs = audit.waiting_for_another_worker();
  return output::counted(jobs, "job waits", "jobs wait") + " for a worker other than the one that computed " +
         (jobs == 1 ? "it" : "them") + " before: start another lamprey-worker";
}

std::string progress_text(const idl::AuditStatus& audit) {
  std::string text = "audit of " + audit.sweep() + "  " + output::with_thousands(audit.agreed() + audit.diverged()) +
                     " / " + output::with_thousands(audit.jobs()) + "  agreed " +
                     output::with_thousands(audit.agreed()) + "  diverged " + output::with_thousands(audit.diverged());
  if (audit.waiting_for_another_worker() > 0) text += "  " + waiting_text(audit);
  return text;
}

/// Shows how the audit goes on; its last word.
idl::AuditStatus wait_for_end(CoordinatorConnection& connection, idl::AuditStatus audit, const Options& options,
                              const output::Console& console) {
  constexpr std::chrono::milliseconds pause{500};
  if (has_ended(audit)) return audit;
  output::ProgressDisplay display(console, options.quiet);
  display.show(progress_text(audit), Clock::now());
  const auto ask = [&] {
    idl::Request request;
    request.mutable_audit_status()->set_audit(audit.audit());
    return request;
  };
  const auto take = [&](const idl::Reply& reply) -> std::optional<Clock::duration> {
    const bool was_waiting = audit.waiting_for_another_worker() > 0;
    audit = reply.audit();
    const bool waits = audit.waiting_for_another_worker() > 0;
    display.show(progress_text(audit), Clock::now(), waits != was_waiting || has_ended(audit));
    if (has_ended(audit)) return std::nullopt;
    return pause;
  };
  try {
    follow(connection, {.ask = ask, .take = take});
  } catch (const Failure& failure) {
    if (failure.exit_code() != exit_interrupted) throw;
    throw interrupted_failure("no longer waiting; the audit goes on. The same command shows it again");
  }
  return audit;
}

void print_text(const output::Console& console, const idl::AuditStatus& audit) {
  output::print_pairs(console,
                      {{"sweep", console.bold(audit.sweep())},
                       {"audit", audit.audit()},
                       {"state", audit.state()},
                       {"jobs", output::with_thousands(audit.jobs())},
                       {"agreed", output::with_thousands(audit.agreed())},
                       {"diverged", audit.diverged() == 0 ? "0"
                                                          : console.alert(output::with_thousands(audit.diverged())) +
                                                                " (see the table divergence)"}});
  if (!has_ended(audit) && audit.waiting_for_another_worker() > 0) {
    console.out << '\n';
    for (const auto& line : output::wrap(waiting_text(audit) + ".", console.columns)) console.out << line << '\n';
  }
}

ExitCode audit(const Options& options, const Context& context) {
  CoordinatorConnection connection(context.environment, options.connection);
  auto audit = connection.ask_for_success(audit_request(options)).audit();
  if (!options.no_wait) audit = wait_for_end(connection, std::move(audit), options, context.console);
  if (context.format == Format::json) {
    Json json = document("audit");
    json["sweep"] = audit.sweep();
    json["audit"] = audit.audit();
    json["share"] = share_of(options.share);
    json["seed"] = options.seed;
    json["state"] = audit.state();
    json["jobs"] = audit.jobs();
    json["agreed"] = audit.agreed();
    json["diverged"] = audit.diverged();
    json["waiting_for_another_worker"] = audit.waiting_for_another_worker();
    print(context.console, json);
  } else {
    print_text(context.console, audit);
  }
  return audit.diverged() > 0 ? exit_mismatch : exit_ok;
}

}  // namespace

Action declare_audit(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Lets other workers compute a share of a sweep's finished jobs again, and compares the outcomes bit by bit. Ends "
      "with 5 if one differs. The same share and seed are the same audit: asking again shows how far it is.");
  app.add_option("SWEEP", options->sweep, "Name or id")->required();
  app.add_option("--share", options->share, "Of its finished jobs: 5% or 0.05")
      ->type_name("SHARE")
      ->check(share())
      ->capture_default_str();
  app.add_option("--seed", options->seed, "Which of them; another number, other jobs")
      ->type_name("N")
      ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  app.add_flag("--no-wait", options->no_wait, "Only start it, or show how far it is");
  app.add_flag("-q,--quiet", options->quiet, "No progress");
  add_connection_options(app, options->connection);
  app.footer("Example\n  lamprey audit quickstart --share 10%");
  return [options](const Context& context) { return audit(*options, context); };
}

}  // namespace lamprey::client::commands
