#pragma once

#include "idl/client.pb.h"
#include "messaging/samples.hpp"
#include "tests/client/site.hpp"

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace lamprey::tests {

/// Answers the tool's requests on the site's bus as it is told, on a thread of its own: for what a real coordinator
/// rarely has to say.
class ScriptedCoordinator {
 public:
  /// Called on that thread, once for each new request; repeated ones get no answer.
  using Answer = std::function<idl::Reply(const idl::Request&)>;

  ScriptedCoordinator(Site& site, Answer answer);
  ~ScriptedCoordinator();

  static constexpr experiment::Id128 database{1, 2};

  /// Those that have been answered, in order.
  std::vector<idl::Request> requests() const;

  void publish(const messaging::SweepProgress& progress);

 private:
  void serve();

  Site& site_;
  Answer answer_;
  std::unique_ptr<messaging::Participant> participant_;
  std::unique_ptr<messaging::Writer<messaging::SweepProgress>> progress_;
  mutable std::mutex mutex_;
  std::vector<idl::Request> requests_;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

idl::Reply error_reply(const std::string& code, const std::vector<std::string>& messages);

}  // namespace lamprey::tests
