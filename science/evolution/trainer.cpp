#include "science/evolution/trainer.hpp"

#include <stdexcept>

namespace lamprey::science::evolution {

fitness::Fitness Trainer::meet(const Training& /*training*/) {
  throw std::logic_error("an off-line trainer knows one environment only");
}

void Trainer::save(const Training& /*training*/, saving::Writer& /*writer*/) const {
  throw std::logic_error("this trainer cannot be saved");
}

void Trainer::restore(const Training& /*training*/, std::uint32_t /*cycles*/, saving::Reader& /*reader*/) {
  throw std::logic_error("this trainer cannot be saved");
}

}  // namespace lamprey::science::evolution
