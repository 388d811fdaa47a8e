#include "messaging/fastdds/discovery_server.hpp"
#include "messaging/fastdds/discovery_watch.hpp"
#include "messaging/fastdds/participant.hpp"
#include "messaging/fastdds/ros2_node.hpp"
#include "messaging/vendor_library.hpp"

#include <exception>

lamprey::messaging::Participant* lamprey_messaging_join(const lamprey::messaging::JoinOptions& options,
                                                        std::string& error) noexcept {
  try {
    return lamprey::messaging::fastdds::make_participant(options).release();
  } catch (const std::exception& exception) {
    error = exception.what();
    return nullptr;
  }
}

lamprey::messaging::ros2::Node* lamprey_messaging_join_ros2(const lamprey::messaging::JoinOptions& options,
                                                            std::string& error) noexcept {
  try {
    return lamprey::messaging::fastdds::make_ros2_node(options).release();
  } catch (const std::exception& exception) {
    error = exception.what();
    return nullptr;
  }
}

lamprey::messaging::discovery::Watch* lamprey_messaging_watch(const lamprey::messaging::JoinOptions& options,
                                                              std::string& error) noexcept {
  try {
    return lamprey::messaging::fastdds::make_discovery_watch(options).release();
  } catch (const std::exception& exception) {
    error = exception.what();
    return nullptr;
  }
}

lamprey::messaging::discovery::Server* lamprey_messaging_serve_discovery(const lamprey::messaging::JoinOptions& options,
                                                                         std::uint16_t port,
                                                                         std::string& error) noexcept {
  try {
    return lamprey::messaging::fastdds::make_discovery_server(options, port).release();
  } catch (const std::exception& exception) {
    error = exception.what();
    return nullptr;
  }
}
