#pragma once

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <memory>
#include <stdexcept>
#include <string>

/// Owners of Fast DDS's entities: each is deleted through its parent, which must outlive it.
namespace lamprey::messaging::fastdds {

namespace dds = eprosima::fastdds::dds;

struct Delete {
  void operator()(dds::DomainParticipant* participant) const {
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant);
  }
  void operator()(dds::Topic* topic) const { topic->get_participant()->delete_topic(topic); }
  void operator()(dds::Publisher* publisher) const {
    const_cast<dds::DomainParticipant*>(publisher->get_participant())->delete_publisher(publisher);
  }
  void operator()(dds::Subscriber* subscriber) const {
    const_cast<dds::DomainParticipant*>(subscriber->get_participant())->delete_subscriber(subscriber);
  }
  void operator()(dds::DataWriter* writer) const {
    const_cast<dds::Publisher*>(writer->get_publisher())->delete_datawriter(writer);
  }
  void operator()(dds::DataReader* reader) const {
    const_cast<dds::Subscriber*>(reader->get_subscriber())->delete_datareader(reader);
  }
};

template <class Type>
using Owned = std::unique_ptr<Type, Delete>;

/// Takes what create_… returned; throws std::runtime_error if that is nothing. Fast DDS logs the reason.
template <class Type>
Owned<Type> own(Type* entity, const std::string& what) {
  if (entity == nullptr) throw std::runtime_error("Fast DDS cannot create " + what);
  return Owned<Type>(entity);
}

}  // namespace lamprey::messaging::fastdds
