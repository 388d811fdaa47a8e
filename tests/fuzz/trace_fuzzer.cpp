// Any text in the columns job.trace and job.measures is either refused or read; what was read is written as one text
// only, which reads back to the same.
#include "storage/trace_text.hpp"
#include "tests/fuzz/fuzzing.hpp"

#include <cmath>
#include <string>
#include <string_view>

namespace {

using namespace lamprey;
using fuzzing::require;

bool finite(const experiment::AcceptedChange& change) {
  const auto& [stability, distance, fuel, total] = change.score;
  return std::isfinite(stability) && std::isfinite(distance) && std::isfinite(fuel) && std::isfinite(total);
}

void look_at_trace(std::string_view text) {
  const auto trace = storage::read_trace(text);
  if (!trace) return;
  for (const auto& change : *trace) require(finite(change));
  std::string written;
  storage::write_trace(*trace, written);
  require(storage::read_trace(written) == trace);
  std::string again;
  storage::write_trace(*storage::read_trace(written), again);
  require(again == written);
  if (!fuzzing::reached<1>(trace->size() >= 3 && trace->at(1).cycle > 10)) return;
  if (fuzzing::reached<2>(trace->at(2).score.total < 0)) fuzzing::planted_bug();
}

void look_at_measures(std::string_view text) {
  const auto measures = storage::read_measures(text);
  // Names are checked elsewhere; what may not be written need not be.
  if (!measures || !experiment::measures_fault(*measures).empty()) return;
  std::string written;
  storage::write_measures(*measures, written);
  require(storage::read_measures(written) == measures);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  look_at_trace(text);
  look_at_measures(text);
  return 0;
}
