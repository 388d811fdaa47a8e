#pragma once

#include "messaging/discovery/domain_view.hpp"
#include "messaging/port.hpp"

#include <memory>

namespace lamprey::messaging::discovery {

/// Looks at a domain without taking part in it: a participant without writers and readers of topics.
class Watch {
 public:
  virtual ~Watch() = default;
  /// All that is known by now, without this participant itself. One thread.
  virtual DomainView look() = 0;
};

/// Joins with options.vendor; of `options` the isolation is of no meaning here. Throws JoinError as messaging::join
/// does.
std::unique_ptr<Watch> watch(const JoinOptions& options);

}  // namespace lamprey::messaging::discovery
