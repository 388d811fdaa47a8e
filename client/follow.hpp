#pragma once

#include "client/coordinator_connection.hpp"

#include <chrono>
#include <functional>
#include <optional>

namespace lamprey::client {

/// How to follow something by asking again and again.
struct Following {
  /// The next question.
  std::function<idl::Request()> ask;
  /// What to do with its answer, which is no error: after how long to ask again, or nothing at the end.
  std::function<std::optional<Clock::duration>(const idl::Reply&)> take;
  /// Called many times a second; says how long there has been no answer to a question. May be empty.
  std::function<void(Clock::time_point now, Clock::duration silence)> meanwhile = {};
};

/// Follows until `take` ends it. The first answer must come within the connection's timeout (Failure: unreachable);
/// after it a coordinator that is gone for a while is waited for, and another database's is not listened to. Throws the
/// Failure that an error reply stands for, and interrupted_failure().
void follow(CoordinatorConnection& connection, const Following& following);

}  // namespace lamprey::client
