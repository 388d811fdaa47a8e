#pragma once

#include "messaging/cyclonedds/entity.hpp"
#include "messaging/discovery/introduction.hpp"
#include "messaging/port.hpp"

#include <dds/dds.h>
#include <string>

namespace lamprey::messaging::cyclonedds {

/// With the program's introduction, for whoever looks at the domain.
inline Qos make_participant_qos(const JoinOptions& options) {
  Qos qos(dds_create_qos());
  const std::string introduction = user_data_of(options);
  dds_qset_userdata(qos.get(), introduction.data(), introduction.size());
  dds_qset_entity_name(qos.get(), options.introduction.role.c_str());
  return qos;
}

}  // namespace lamprey::messaging::cyclonedds
