#include "tests/conformance/world.hpp"

#include <random>

namespace lamprey::messaging::conformance {

std::vector<Pair> network_pairs() {
  return {{.name = "Cyclone", .writer = "cyclonedds", .reader = "cyclonedds"},
          {.name = "Fast", .writer = "fastdds", .reader = "fastdds"},
          {.name = "FastToCyclone", .writer = "fastdds", .reader = "cyclonedds"},
          {.name = "CycloneToFast", .writer = "cyclonedds", .reader = "fastdds"}};
}

std::vector<Pair> all_pairs() {
  auto pairs = network_pairs();
  pairs.insert(pairs.begin(), {.name = "InMemory", .writer = "in_memory", .reader = "in_memory"});
  return pairs;
}

std::vector<Pair> pairs_with_network_settings() {
  auto pairs = network_pairs();
  for (auto& pair : pairs) pair.network_settings = true;
  return pairs;
}

std::string pair_name(const ::testing::TestParamInfo<Pair>& parameter) {
  return parameter.param.name;
}

World::World()
    : isolation_("test-" + std::to_string(std::random_device{}()) + std::to_string(std::random_device{}())) {}

JoinOptions World::options(const std::string& vendor, const std::string& isolation) const {
  JoinOptions options;
  options.vendor = vendor;
  options.domain = 99;
  options.isolation = isolation_ + isolation;
  options.loopback_only = !GetParam().network_settings;
  if (GetParam().network_settings) options.peers = {"127.0.0.1"};
  return options;
}

std::unique_ptr<Participant> World::make(const std::string& vendor, const std::string& isolation) {
  if (vendor == "in_memory") return buses_[isolation].join();
  return join(options(vendor, isolation));
}

std::unique_ptr<Participant> World::join_writer(const std::string& isolation) {
  return make(GetParam().writer, isolation);
}
std::unique_ptr<Participant> World::join_reader(const std::string& isolation) {
  return make(GetParam().reader, isolation);
}

}  // namespace lamprey::messaging::conformance
