#pragma once

#include "client/failure.hpp"
#include "experiment/sweep.hpp"
#include "idl/client.pb.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lamprey::client {

/// A sweep file that has been read and found valid.
struct SweepInput {
  std::string path;
  std::string source;  ///< its text
  experiment::SweepFile file;
  experiment::Id128 id;
  bool fresh = false;  ///< compute every job, also those whose outcome the database has

  const std::string& name() const { return file.specification.name(); }
};

/// What a command line can say in the place of the file, or in addition to it.
struct SweepOverrides {
  std::string name;
  std::optional<std::int32_t> priority;
  bool fail_fast = false;
  bool fresh = false;
  std::vector<std::string> tags;
};

/// Declares --name, --priority, --fail-fast, --fresh and --tag.
void add_sweep_overrides(CLI::App& app, SweepOverrides& overrides);

/// Throws experiment::InvalidInput.
SweepInput read_sweep(const std::string& path, const SweepOverrides& overrides = {});

/// What asks a coordinator to run it.
idl::Request submit_request(const SweepInput& sweep);

/// What asks how that sweep stands.
idl::Request status_request(const SweepInput& sweep);

/// "360 outcomes that the database had already (--fresh computes them again)".
std::string reused_text(std::uint64_t outcomes);

/// The database has another sweep of that name; `differences` as experiment::differences gives them.
Failure sweep_changed(const std::string& name, std::vector<std::string> differences);

/// Throws what the coordinator answered to that request instead of accepting it; where it names fields, with their
/// places in the file.
void require_accepted(const idl::Reply& reply, const SweepInput& sweep);

}  // namespace lamprey::client
