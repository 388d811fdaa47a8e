#include "client/commands/commands.hpp"
#include "client/json.hpp"
#include "client/network/look.hpp"
#include "client/network/programs.hpp"
#include "client/option_checks.hpp"
#include "client/output/formatting.hpp"
#include "client/output/table.hpp"
#include "messaging/discovery/mismatches.hpp"
#include "messaging/program/join_options.hpp"
#include "messaging/qos.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lamprey::client::commands {

namespace {

namespace discovery = messaging::discovery;
using network::Program;
using output::without_controls;

struct Options {
  messaging::JoinOptions join;
  double seconds = 3;
  bool topics = false;
};

/// What a user wants to know of it, worked out.
struct Findings {
  discovery::DomainView view;
  std::vector<Program> programs;
  std::vector<discovery::Mismatch> mismatches;
  std::vector<std::string> foreign_topics;

  bool clean() const { return mismatches.empty() && foreign_topics.empty(); }
};

Findings findings_of(network::Sight sight) {
  Findings findings;
  auto& view = sight.view;
  findings.programs = network::programs_of(view, sight.first);
  findings.mismatches = discovery::mismatches(view);
  findings.foreign_topics = discovery::topics_of_other_wire_versions(view, messaging::wire_version);
  findings.view = std::move(view);
  return findings;
}

Json json_of(const std::optional<network::ProgramTraffic>& traffic) {
  if (!traffic) return nullptr;
  const auto rate = [&](double value) { return traffic->has_rates ? Json(value) : Json(nullptr); };
  return {{"written", traffic->written},
          {"refused", traffic->refused},
          {"read", traffic->read},
          {"malformed", traffic->malformed},
          {"written_per_second", rate(traffic->written_per_second)},
          {"read_per_second", rate(traffic->read_per_second)}};
}

Json json_of(const Program& program) {
  const auto& who = program.introduction;
  Json guids = Json::array();
  for (const auto& guid : program.participants) guids.push_back(discovery::to_text(guid));
  Json json = {{"role", program.ours() ? Json(who.role) : Json(nullptr)}};
  if (program.ours()) {
    json["host"] = who.host;
    json["process"] = who.process;
    json["isolation"] = who.isolation;
    json["build"] = who.build;
    json["wire"] = who.wire;
  }
  json["name"] = program.name;
  json["vendors"] = program.vendors;
  json["participants"] = std::move(guids);
  json["writers"] = program.writers;
  json["readers"] = program.readers;
  json["samples"] = json_of(program.traffic);
  return json;
}

Json json_of(const discovery::Endpoint& endpoint, const std::vector<Program>& programs) {
  return {{"program", network::owner_of(endpoint, programs)},
          {"kind", endpoint.writes ? "writer" : "reader"},
          {"topic", endpoint.topic},
          {"type", endpoint.type},
          {"partitions", endpoint.qos.partitions},
          {"reliable", endpoint.qos.reliable},
          {"durability", discovery::to_text(endpoint.qos.durability)}};
}

void print_json(const Options& options, const Findings& findings, const Context& context) {
  Json json = document("net");
  json["domain"] = options.join.domain;
  json["programs"] = Json::array();
  for (const auto& program : findings.programs) json["programs"].push_back(json_of(program));
  json["mismatches"] = Json::array();
  for (const auto& mismatch : findings.mismatches) {
    json["mismatches"].push_back({{"topic", mismatch.writer.topic},
                                  {"writer", network::owner_of(mismatch.writer, findings.programs)},
                                  {"reader", network::owner_of(mismatch.reader, findings.programs)},
                                  {"reason", mismatch.reason}});
  }
  json["topics_of_other_versions"] = findings.foreign_topics;
  if (options.topics) {
    json["endpoints"] = Json::array();
    for (const auto& endpoint : findings.view.endpoints) {
      json["endpoints"].push_back(json_of(endpoint, findings.programs));
    }
  }
  print(context.console, json);
}

std::string rate(const Program& program, double network::ProgramTraffic::*per_second) {
  if (!program.traffic || !program.traffic->has_rates) return "-";
  return output::shortest(std::round((*program.traffic).*per_second));
}

void print_programs(const Findings& findings, const Context& context) {
  output::Table table({{"role"},
                       {"host/process"},
                       {"isolation"},
                       {"DDS"},
                       {"version"},
                       {"writers", output::Align::right},
                       {"readers", output::Align::right},
                       {"out/s", output::Align::right},
                       {"in/s", output::Align::right}});
  for (const auto& program : findings.programs) {
    const auto& who = program.introduction;
    const bool ours = program.ours();
    table.add({ours ? without_controls(who.role) : std::string("not ours"),
               ours ? without_controls(who.host) + "/" + std::to_string(who.process)
                    : without_controls(program.name.empty() ? network::to_text(program) : program.name),
               without_controls(who.isolation), output::joined(program.vendors, ", "), without_controls(who.build),
               std::to_string(program.writers), std::to_string(program.readers),
               rate(program, &network::ProgramTraffic::written_per_second),
               rate(program, &network::ProgramTraffic::read_per_second)});
  }
  table.print(context.console);
}

void print_topics(const Findings& findings, const Context& context) {
  output::Table table({{"topic"}, {"partition"}, {""}, {"program"}, {"reliability"}, {"durability"}});
  auto endpoints = findings.view.endpoints;
  std::ranges::stable_sort(endpoints, {},
                           [](const auto& endpoint) { return std::pair(endpoint.topic, !endpoint.writes); });
  for (const auto& endpoint : endpoints) {
    table.add(
        {without_controls(endpoint.topic), without_controls(output::joined(endpoint.qos.partitions, ", ")),
         endpoint.writes ? "written by" : "read by", without_controls(network::owner_of(endpoint, findings.programs)),
         endpoint.qos.reliable ? "reliable" : "best effort", std::string(discovery::to_text(endpoint.qos.durability))});
  }
  context.console.out << '\n';
  table.print(context.console);
}

void print_trouble(const Findings& findings, const Context& context) {
  const auto& console = context.console;
  for (const auto& mismatch : findings.mismatches) {
    console.out << '\n'
                << console.alert("Never meet on " + without_controls(mismatch.writer.topic)) << ": "
                << without_controls(network::owner_of(mismatch.writer, findings.programs) + " writes, " +
                                    network::owner_of(mismatch.reader, findings.programs) + " reads, but " +
                                    mismatch.reason)
                << ".\n";
  }
  if (!findings.foreign_topics.empty()) {
    console.out << '\n'
                << console.alert("Programs of another version")
                << " are here, which this one never meets (it uses lamprey/" << messaging::wire_version << "/...):\n";
    for (const auto& topic : findings.foreign_topics) console.out << "  " << without_controls(topic) << '\n';
    console.out << "Install the same version of Lamprey everywhere.\n";
  }
}

void print_text(const Options& options, const Findings& findings, const Context& context) {
  if (findings.programs.empty()) {
    context.console.out << "Nobody else is in domain " << options.join.domain << ", as far as " << options.join.vendor
                        << " has found out in " << output::duration(options.seconds)
                        << ". lamprey doctor looks for the reason.\n";
    return;
  }
  print_programs(findings, context);
  if (options.topics) print_topics(findings, context);
  print_trouble(findings, context);
}

ExitCode net(const Options& options, const Context& context) {
  const auto findings = findings_of(network::look(options.join, options.seconds, context.environment));
  if (context.format == Format::json) {
    print_json(options, findings, context);
  } else {
    print_text(options, findings, context);
  }
  return findings.clean() ? exit_ok : exit_mismatch;
}

}  // namespace

Action declare_net(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Shows who takes part in the DDS domain, of any isolation and any vendor, and who fails to meet whom: writers "
      "and "
      "readers whose quality of service or type doesn't fit, programs of another version. Exit code 5 if there are "
      "such.");
  app.add_option("--seconds", options->seconds, "Look so long")
      ->check(number(0.1, 600))
      ->type_name("S")
      ->capture_default_str();
  app.add_flag("--topics", options->topics, "Show each writer and reader, too");
  messaging::program::add_join_options(app, options->join);
  app.footer("Example\n  lamprey net\n  lamprey net --topics --peer coordinator.lab");
  return [options](const Context& context) { return net(*options, context); };
}

}  // namespace lamprey::client::commands
