// Any octets as the coordinator's reply: the client ignores them, or has a reply that is written again as it was read.
#include "client/coordinator_client.hpp"
#include "messaging/in_memory/bus.hpp"
#include "tests/fuzz/fuzzing.hpp"

#include <chrono>

namespace {

using namespace lamprey;
using fuzzing::require;

constexpr std::uint64_t client_id = 5;

/// The parser's own order of fields and the same text again.
void look_at(const idl::Reply& reply) {
  const std::string written = reply.SerializeAsString();
  idl::Reply again;
  require(again.ParseFromString(written) && again.SerializeAsString() == written);
  if (!fuzzing::reached<1>(reply.status().workers_size() > 0)) return;
  const auto& worker = reply.status().workers(0);
  if (fuzzing::reached<2>(worker.threads() > 8)) fuzzing::planted_bug();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  messaging::in_memory::Bus bus;
  const auto coordinator = bus.join("coordinator");
  const auto participant = bus.join("client");
  const auto writer = coordinator->writer<messaging::Reply>(messaging::Partition::of(client_id));
  client::CoordinatorClient client(*participant, std::make_shared<messaging::Signal>(), client_id);
  const client::Clock::time_point now{std::chrono::hours{1}};
  idl::Request request;
  request.mutable_status();
  client.begin(request, now);
  messaging::Reply sample;
  sample.client = client_id;
  sample.correlation = 1;
  sample.payload.assign(data, data + size);
  require(static_cast<bool>(writer->write(sample)));
  if (const auto reply = client.poll(now)) look_at(*reply);
  return 0;
}
