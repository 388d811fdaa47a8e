#pragma once

#include "idl/client.pb.h"
#include "messaging/port.hpp"
#include "messaging/process_identity.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace lamprey::client {

using Clock = std::chrono::steady_clock;

using messaging::random_id;

/// Asks the coordinator: one request at a time, sent again under the same correlation until its reply has come, so that
/// a lost request, a lost reply and a coordinator that starts later cost time only. The coordinator may thus get a
/// request twice; all of them are idempotent. Replies to other correlations are dropped. One thread.
class CoordinatorClient {
 public:
  static constexpr std::chrono::seconds resend_interval{1};

  /// `client` names the partition of the replies. `signal` is notified when replies come.
  CoordinatorClient(messaging::Participant& participant, std::shared_ptr<messaging::Signal> signal,
                    std::uint64_t client = random_id());

  /// Sends the request; one that was waiting is forgotten.
  void begin(const idl::Request& request, Clock::time_point now);
  bool waiting() const { return pending_.has_value(); }

  /// The reply, if it has come; sends the request again when that is due. Not for longer than a write may block.
  std::optional<idl::Reply> poll(Clock::time_point now);

  /// begin() and poll() until there is a reply, `timeout` has passed or `stop` is true; no reply then.
  std::optional<idl::Reply> ask(const idl::Request& request, Clock::duration timeout,
                                const std::function<bool()>& stop);

  /// Who sent the last reply.
  const messaging::Origin& answered_by() const { return answered_by_; }

  /// Why the last write failed; empty if it did not.
  const std::string& write_error() const { return write_error_; }

 private:
  void send(Clock::time_point now);

  struct Pending {
    messaging::Request sample;
    Clock::time_point due;
  };
  std::shared_ptr<messaging::Signal> signal_;
  std::uint64_t client_;
  // The reader is made before the writer, so that no reply can come before there is somebody to get it.
  std::unique_ptr<messaging::Reader<messaging::Reply>> replies_;
  std::unique_ptr<messaging::Writer<messaging::Request>> requests_;
  std::uint64_t correlation_ = 0;
  std::optional<Pending> pending_;
  messaging::Origin answered_by_;
  std::string write_error_;
};

}  // namespace lamprey::client
