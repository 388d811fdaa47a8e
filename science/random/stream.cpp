#include "science/random/stream.hpp"

#include <Random123/philox.h>

namespace lamprey::science::random {

Words Stream::block(std::uint32_t cycle, Purpose purpose, std::uint32_t index, std::uint32_t part) const {
  const r123::Philox4x32::ctr_type counter{{cycle, static_cast<std::uint32_t>(purpose), index, part}};
  const r123::Philox4x32::key_type key{{static_cast<std::uint32_t>(key_), static_cast<std::uint32_t>(key_ >> 32)}};
  const auto words = r123::Philox4x32()(counter, key);
  return {words[0], words[1], words[2], words[3]};
}

}  // namespace lamprey::science::random
