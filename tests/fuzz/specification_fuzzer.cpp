#include "tests/fuzz/sweep_checks.hpp"

#include <cstddef>
#include <cstdint>

// Any message from the network is either found wrong, with problems that can be shown, or a valid sweep.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lamprey::experiment;
  lamprey::idl::SweepSpecification specification;
  if (!specification.ParseFromArray(data, static_cast<int>(size))) return 0;
  const auto problems = validate(specification);
  if (problems.empty()) check_valid_sweep(specification);
  if (problems.size() > maximum_problems) std::abort();
  for (const auto& problem : problems) {
    if (problem.message.empty() || first_unreadable(problem.text()) != std::string::npos) std::abort();
  }
  return 0;
}
