#pragma once

#include "science/evolution/gene_plan.hpp"
#include "science/evolution/operators/word_sequence.hpp"

#include <cstddef>
#include <span>

namespace lamprey::science::evolution::operators {

/// 3.6: every gene moves by a normal deviate of mean 0 and this standard deviation, times its step unit, and is held
/// within its bounds. Gene g takes deviate g.
void add_normal_steps(const GenePlan& plan, double standard_deviation, WordSequence& words, std::span<double> genes);

/// Self-adaptation of a member's own standard deviation (3.6.1): σ·exp(Z/√n) for n ≥ 1 genes, log-normal with median σ
/// (H.-P. Schwefel, Numerical Optimization of Computer Models, 1981; one step size per member).
double adapted_standard_deviation(double standard_deviation, double normal_deviate, std::size_t genes);

}  // namespace lamprey::science::evolution::operators
