// Publishes angles to a robot as a node of ROS 2 would, 20 times a second, until it is stopped:
//   lamprey_ros2_commander --dds VENDOR --domain NUMBER --loopback-only ANGLE…
#include "messaging/program/exit_codes.hpp"
#include "messaging/program/join_options.hpp"
#include "messaging/program/stop.hpp"
#include "messaging/ros2/node.hpp"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>
#include <vector>

int main(int count, char** arguments) {
  using namespace lamprey;
  namespace program = messaging::program;
  CLI::App app("Publishes angles to a robot as a node of ROS 2 would.");
  messaging::JoinOptions options;
  std::vector<double> angles;
  program::add_join_options(app, options);
  app.add_option("angles", angles, "rad")->required();
  CLI11_PARSE(app, count, arguments);
  try {
    const auto signal = std::make_shared<messaging::Signal>();
    const program::StopOnSignal stop(signal);
    const auto node = messaging::ros2::join(options);
    const auto writer = node->writer<messaging::ros2::JointCommand>();
    while (!stop.requested()) {
      if (const auto written = writer->write({.positions = angles}); !written) {
        std::fprintf(stderr, "%s\n", written.error.c_str());
      }
      signal->wait_for(std::chrono::milliseconds(50));
    }
    return program::exit_ok;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return program::exit_failure;
  }
}
