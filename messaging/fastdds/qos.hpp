#pragma once

#include "messaging/ros2/topics.hpp"
#include "messaging/tuning.hpp"

#include <chrono>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <string>

/// Our profiles in Fast DDS's terms. What is set for a participant as a whole is in configuration.cpp.
namespace lamprey::messaging::fastdds {

namespace dds = eprosima::fastdds::dds;

inline eprosima::fastrtps::Duration_t duration(std::chrono::milliseconds value) {
  return {static_cast<std::int32_t>(value.count() / 1000),
          static_cast<std::uint32_t>(value.count() % 1000) * 1'000'000u};
}

/// `partition`: empty for the default one, which is ROS 2's.
inline dds::PublisherQos publisher_qos(const dds::DomainParticipant& participant, const std::string& partition) {
  dds::PublisherQos qos = participant.get_default_publisher_qos();
  qos.partition().clear();
  if (!partition.empty()) qos.partition().push_back(partition.c_str());
  return qos;
}

inline dds::SubscriberQos subscriber_qos(const dds::DomainParticipant& participant, const std::string& partition) {
  dds::SubscriberQos qos = participant.get_default_subscriber_qos();
  qos.partition().clear();
  if (!partition.empty()) qos.partition().push_back(partition.c_str());
  return qos;
}

/// What a writer and a reader of the topic have in common.
template <class Sample, class Qos>
void set_common(Qos& qos) {
  constexpr QosProfile profile = Topic<Sample>::profile;
  const std::string announced = user_data<Sample>();
  qos.user_data().data_vec({announced.begin(), announced.end()});
  qos.reliability().kind = profile.reliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
  qos.reliability().max_blocking_time = duration(longest_blocking<Sample>());
  qos.durability().kind = profile.transient_local ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
  if (profile.liveliness.count() > 0) {
    qos.liveliness().kind = dds::AUTOMATIC_LIVELINESS_QOS;
    qos.liveliness().lease_duration = duration(profile.liveliness);
    qos.liveliness().announcement_period = duration(profile.liveliness * 2 / 5);
  }
  // The types are unbounded, so that buffers of the largest size cannot be set aside.
  qos.endpoint().history_memory_policy = eprosima::fastrtps::rtps::DYNAMIC_RESERVE_MEMORY_MODE;
  // It needs types of bounded size.
  qos.data_sharing().off();
}

template <class Qos>
void set_keep_last(std::int32_t depth, std::int32_t keys, Qos& qos) {
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = depth;
  qos.resource_limits().max_samples = depth * keys;
  qos.resource_limits().max_instances = keys;
  qos.resource_limits().max_samples_per_instance = depth;
  qos.resource_limits().allocated_samples = depth;
}

template <class Qos>
void set_keep_all(std::int32_t samples, Qos& qos) {
  qos.history().kind = dds::KEEP_ALL_HISTORY_QOS;
  qos.resource_limits().max_samples = samples;
  qos.resource_limits().max_instances = 1;
  qos.resource_limits().max_samples_per_instance = samples;
  qos.resource_limits().allocated_samples = 1;
}

template <class Sample>
dds::DataWriterQos writer_qos(const dds::Publisher& publisher) {
  constexpr QosProfile profile = Topic<Sample>::profile;
  constexpr auto depth = static_cast<std::int32_t>(profile.depth);
  dds::DataWriterQos qos = publisher.get_default_datawriter_qos();
  set_common<Sample>(qos);
  // Also where the profile is volatile, which late readers then ask for and get: nothing old. A volatile writer of Fast
  // DDS 2.9 forgets a sample when all readers have it, also when that is because one has left; if the sample is to be
  // sent again just then, the thread that forgets it and the one that sends wait for each other for ever.
  if (profile.reliable) qos.durability().kind = dds::TRANSIENT_LOCAL_DURABILITY_QOS;
  if (profile.keep_all) {
    set_keep_all(depth, qos);
  } else {
    set_keep_last(depth, Keyed<Sample> ? maximum_keys : 1, qos);
  }
  qos.representation().m_value = {dds::DataRepresentationId_t::XCDR_DATA_REPRESENTATION};
  // The writing thread sends by itself; asynchronously a fifth as many samples got through.
  qos.publish_mode().kind = dds::SYNCHRONOUS_PUBLISH_MODE;
  // What has ended is said by samples; vendors differ in what they make of a disposal.
  qos.writer_data_lifecycle().autodispose_unregistered_instances = false;
  // With the defaults (heartbeat each 3 s) a writer whose history is full stands still until the next heartbeat.
  auto& times = qos.reliable_writer_qos().times;
  times.initialHeartbeatDelay = duration(std::chrono::milliseconds(0));
  times.heartbeatPeriod = duration(std::chrono::milliseconds(5));
  times.nackResponseDelay = duration(std::chrono::milliseconds(0));
  times.nackSupressionDuration = duration(std::chrono::milliseconds(0));
  return qos;
}

template <class Sample>
dds::DataReaderQos reader_qos(const dds::Subscriber& subscriber) {
  constexpr QosProfile profile = Topic<Sample>::profile;
  dds::DataReaderQos qos = subscriber.get_default_datareader_qos();
  set_common<Sample>(qos);
  // Keep-last throughout, also where the profile says keep-all: see the comment on readers in docs/decisions.
  if constexpr (Keyed<Sample>) {
    set_keep_last(static_cast<std::int32_t>(profile.depth), maximum_keys, qos);
  } else {
    set_keep_last(static_cast<std::int32_t>(profile.untaken), 1, qos);
    qos.resource_limits().allocated_samples = 1;
  }
  qos.type_consistency().representation.m_value = {dds::DataRepresentationId_t::XCDR_DATA_REPRESENTATION};
  // A reader that answers at once keeps writers of either vendor from waiting for it.
  qos.reliable_reader_qos().times.heartbeatResponseDelay = duration(std::chrono::milliseconds(0));
  return qos;
}

}  // namespace lamprey::messaging::fastdds
