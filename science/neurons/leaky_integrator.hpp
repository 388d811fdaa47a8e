#pragma once

#include "science/saving/archive.hpp"

namespace lamprey::science::neurons {

/// McMinn's leaky integrator (2.6.1, fig. 2.6), which turns an output that is on or off in time into a continuous one:
/// y += (u − y)/τ each time step.
struct LeakyIntegrator {
  double time_constant = 2;  ///< τ in time steps, at least 1; 1 passes the input through

  bool operator==(const LeakyIntegrator&) const = default;
};

struct LeakyIntegratorState {
  double output = 0;  ///< y

  bool operator==(const LeakyIntegratorState&) const = default;
};

void fields(auto& archive, saving::Of<LeakyIntegratorState> auto& state) {
  archive.real("output", state.output);
}

/// One time step with input u = `net`; y after it. Pure but for `state`.
inline double step(const LeakyIntegrator& integrator, double net, LeakyIntegratorState& state) {
  state.output += (net - state.output) / integrator.time_constant;
  return state.output;
}

}  // namespace lamprey::science::neurons
