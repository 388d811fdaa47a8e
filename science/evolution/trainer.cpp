#include "science/evolution/trainer.hpp"

#include <stdexcept>

namespace lamprey::science::evolution {

fitness::Fitness Trainer::meet(const Training& /*training*/) {
  throw std::logic_error("an off-line trainer knows one environment only");
}

}  // namespace lamprey::science::evolution
