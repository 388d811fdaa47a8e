#pragma once

#include "messaging/cyclonedds/entity.hpp"
#include "messaging/discovery/domain_view.hpp"

#include <array>
#include <cstddef>
#include <dds/dds.h>
#include <map>
#include <vector>

/// What Cyclone tells of a domain's participants, writers and readers.
namespace lamprey::messaging::cyclonedds {

discovery::Guid guid_of(const dds_guid_t& guid);
discovery::Participant converted(const dds_builtintopic_participant_t& from);
discovery::Endpoint converted(const dds_builtintopic_endpoint_t& from, bool writes);

/// Throws std::runtime_error with Cyclone's reason.
discovery::Guid guid_of(dds_entity_t participant);

/// Takes what has come to a reader of a builtin topic; `appear` and `vanish` get samples of its type.
template <class Sample, class Appear, class Vanish>
void take_all(dds_entity_t reader, Appear appear, Vanish vanish) {
  constexpr std::size_t most = 64;
  while (true) {
    std::array<void*, most> loans{};
    std::array<dds_sample_info_t, most> infos{};
    const dds_return_t count = dds_take(reader, loans.data(), infos.data(), most, most);
    if (count <= 0) return;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      const auto& sample = *static_cast<const Sample*>(loans[i]);
      const bool there = infos[i].valid_data && infos[i].instance_state == DDS_IST_ALIVE;
      there ? appear(sample) : vanish(sample);
    }
    dds_return_loan(reader, loans.data(), count);
  }
}

/// The domain's participants, without the one that looks. One thread.
class Census {
 public:
  explicit Census(dds_entity_t participant);
  std::vector<discovery::Participant> participants();

 private:
  discovery::Guid own_;
  Entity reader_;
  std::map<discovery::Guid, discovery::Participant> known_;
};

}  // namespace lamprey::messaging::cyclonedds
