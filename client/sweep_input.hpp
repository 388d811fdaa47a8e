#pragma once

#include "experiment/sweep.hpp"
#include "idl/client.pb.h"

#include <string>

namespace lamprey::client {

/// A sweep file that has been read and found valid.
struct SweepInput {
  std::string path;
  std::string source;  ///< its text
  experiment::SweepFile file;
  experiment::Id128 id;

  const std::string& name() const { return file.specification.name(); }
};

/// Throws experiment::InvalidInput.
SweepInput read_sweep(const std::string& path);

/// What asks a coordinator to run it.
idl::Request submit_request(const SweepInput& sweep);

/// Throws what the coordinator answered to that request instead of accepting it; where it names fields, with their
/// places in the file.
void require_accepted(const idl::Reply& reply, const SweepInput& sweep);

}  // namespace lamprey::client
