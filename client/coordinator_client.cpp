#include "client/coordinator_client.hpp"

#include "experiment/identifiers.hpp"

#include <limits>
#include <utility>

namespace lamprey::client {

namespace {

/// How often a waiting program looks whether it is to stop.
constexpr std::chrono::milliseconds look_interval{50};

}  // namespace

CoordinatorClient::CoordinatorClient(messaging::Participant& participant, std::shared_ptr<messaging::Signal> signal,
                                     std::uint64_t client)
    : signal_(std::move(signal)),
      client_(client),
      replies_(participant.reader<messaging::Reply>(signal_, messaging::Partition::of(client))),
      requests_(participant.writer<messaging::Request>()) {}

void CoordinatorClient::begin(const idl::Request& request, Clock::time_point now) {
  messaging::Request sample;
  sample.origin.science_version = experiment::science_version;
  sample.client = client_;
  sample.correlation = ++correlation_;
  const std::string bytes = request.SerializeAsString();
  sample.payload.assign(bytes.begin(), bytes.end());
  pending_ = Pending{std::move(sample), now};
  send(now);
}

void CoordinatorClient::send(Clock::time_point now) {
  pending_->due = now + resend_interval;
  const auto result = requests_->write(pending_->sample);
  write_error_ = result ? std::string() : result.error;
}

std::optional<idl::Reply> CoordinatorClient::poll(Clock::time_point now) {
  for (const auto& sample : replies_->take()) {
    if (!pending_ || sample.client != client_ || sample.correlation != pending_->sample.correlation) continue;
    idl::Reply reply;
    if (sample.payload.size() > std::size_t{std::numeric_limits<int>::max()} ||
        !reply.ParseFromArray(sample.payload.data(), static_cast<int>(sample.payload.size()))) {
      continue;  // nothing that a coordinator writes; the right reply may still come
    }
    answered_by_ = sample.origin;
    pending_.reset();
    return reply;
  }
  if (pending_ && now >= pending_->due) send(now);
  return std::nullopt;
}

std::optional<idl::Reply> CoordinatorClient::ask(const idl::Request& request, Clock::duration timeout,
                                                 const std::function<bool()>& stop) {
  const auto until = Clock::now() + timeout;
  begin(request, Clock::now());
  while (true) {
    const auto now = Clock::now();
    if (auto reply = poll(now)) return reply;
    if (now >= until || stop()) break;
    signal_->wait_for(std::min(look_interval, std::chrono::ceil<std::chrono::milliseconds>(until - now)));
  }
  pending_.reset();
  return std::nullopt;
}

}  // namespace lamprey::client
