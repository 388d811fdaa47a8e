#include "messaging/cyclonedds/discovery_watch.hpp"
#include "messaging/cyclonedds/participant.hpp"
#include "messaging/cyclonedds/ros2_node.hpp"
#include "messaging/vendor_library.hpp"

lamprey::messaging::Participant* lamprey_messaging_join(const lamprey::messaging::JoinOptions& options,
                                                        std::string& error) noexcept {
  return lamprey::messaging::made(error, [&] { return lamprey::messaging::cyclonedds::make_participant(options); });
}

lamprey::messaging::ros2::Node* lamprey_messaging_join_ros2(const lamprey::messaging::JoinOptions& options,
                                                            std::string& error) noexcept {
  return lamprey::messaging::made(error, [&] { return lamprey::messaging::cyclonedds::make_ros2_node(options); });
}

lamprey::messaging::discovery::Watch* lamprey_messaging_watch(const lamprey::messaging::JoinOptions& options,
                                                              std::string& error) noexcept {
  return lamprey::messaging::made(error, [&] { return lamprey::messaging::cyclonedds::make_discovery_watch(options); });
}

lamprey::messaging::discovery::Server* lamprey_messaging_serve_discovery(const lamprey::messaging::JoinOptions&,
                                                                         std::uint16_t, std::string& error) noexcept {
  error = "Cyclone DDS has no discovery server";
  return nullptr;
}
