#include "experiment/job.hpp"

#include <string>
#include <string_view>

namespace lamprey::experiment {

namespace {

/// The lines that both hashes share; canonical_text ends each of its own.
std::string seeded_text(const Job& job) {
  return "seed=" + std::to_string(job.seed) + "\nreplicate=" + std::to_string(job.replicate) + "\n" +
         canonical_text(job.parameters);
}

}  // namespace

Digest identity(const Job& job) {
  return sha256(
      std::string_view("lamprey-job/1\nscience=" + std::to_string(science_version) + "\n" + seeded_text(job)));
}

std::uint64_t stream_key(const Job& given) {
  // A robot is asked for what its simulation is asked for.
  Job job = given;
  if (job.parameters.choice("robot") == "bridge") job.parameters.set("robot", std::string("quadruped"));
  return leading_128_bits(sha256(std::string_view("lamprey-stream/1\n" + seeded_text(job)))).high;
}

}  // namespace lamprey::experiment
