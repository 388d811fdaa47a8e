#pragma once

#include <cstdint>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace lamprey::messaging {

/// Counts the samples that a participant's readers have dropped because no program of ours writes such: lengths that
/// cannot be, unknown enumerators, more than limits.hpp allows. The first of each topic and source is logged; after
/// `most_sources` of them no further source is. Any thread.
class MalformedSamples {
 public:
  static constexpr std::size_t most_sources = 256;

  void note(std::string_view topic, const std::string& source, const std::string& reason);
  std::uint64_t count() const;

 private:
  mutable std::mutex mutex_;
  std::uint64_t count_ = 0;
  std::set<std::pair<std::string, std::string>> reported_;  ///< topic and source
};

}  // namespace lamprey::messaging
