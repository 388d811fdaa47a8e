#include "tests/conformance/world.hpp"

#include <random>

namespace lamprey::messaging::conformance {

std::vector<Pair> network_pairs() {
  return {{"Cyclone", "cyclonedds", "cyclonedds"},
          {"Fast", "fastdds", "fastdds"},
          {"FastToCyclone", "fastdds", "cyclonedds"},
          {"CycloneToFast", "cyclonedds", "fastdds"}};
}

std::vector<Pair> all_pairs() {
  auto pairs = network_pairs();
  pairs.insert(pairs.begin(), {"InMemory", "in_memory", "in_memory"});
  return pairs;
}

std::string pair_name(const ::testing::TestParamInfo<Pair>& parameter) {
  return parameter.param.name;
}

World::World()
    : isolation_("test-" + std::to_string(std::random_device{}()) + std::to_string(std::random_device{}())) {}

JoinOptions World::options(const std::string& vendor, const std::string& isolation) const {
  return {.vendor = vendor, .domain = 99, .isolation = isolation_ + isolation, .peers = {}, .loopback_only = true};
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
