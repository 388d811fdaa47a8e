#include "messaging/fastdds/discovery_server.hpp"
#include "messaging/fastdds/discovery_watch.hpp"
#include "messaging/fastdds/participant.hpp"
#include "messaging/fastdds/ros2_node.hpp"
#include "messaging/vendor_library.hpp"

lamprey::messaging::Participant* lamprey_messaging_join(const lamprey::messaging::JoinOptions& options,
                                                        std::string& error) noexcept {
  return lamprey::messaging::made(error, [&] { return lamprey::messaging::fastdds::make_participant(options); });
}

lamprey::messaging::ros2::Node* lamprey_messaging_join_ros2(const lamprey::messaging::JoinOptions& options,
                                                            std::string& error) noexcept {
  return lamprey::messaging::made(error, [&] { return lamprey::messaging::fastdds::make_ros2_node(options); });
}

lamprey::messaging::discovery::Watch* lamprey_messaging_watch(const lamprey::messaging::JoinOptions& options,
                                                              std::string& error) noexcept {
  return lamprey::messaging::made(error, [&] { return lamprey::messaging::fastdds::make_discovery_watch(options); });
}

lamprey::messaging::discovery::Server* lamprey_messaging_serve_discovery(const lamprey::messaging::JoinOptions& options,
                                                                         std::uint16_t port,
                                                                         std::string& error) noexcept {
  return lamprey::messaging::made(error,
                                  [&] { return lamprey::messaging::fastdds::make_discovery_server(options, port); });
}
