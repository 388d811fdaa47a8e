#include "tests/fuzz/sweep_checks.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

// Any bytes are either refused, with problems that can be shown, or a valid sweep.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lamprey::experiment;
  try {
    const auto file = parse_sweep(std::string(reinterpret_cast<const char*>(data), size), "fuzz.yaml");
    check_valid_sweep(file.specification);
  } catch (const InvalidInput& error) {
    if (error.problems().empty() || error.problems().size() > maximum_problems) std::abort();
    for (const auto& problem : error.problems()) {
      if (problem.message.empty() || first_unreadable(problem.text()) != std::string::npos) std::abort();
    }
  }
  return 0;
}
