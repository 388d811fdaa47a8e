#pragma once

#include "messaging/discovery/domain_view.hpp"

#include <string>
#include <vector>

namespace lamprey::messaging::discovery {

/// A program of our isolation that is not of our version.
struct VersionSkew {
  Introduction who;
  bool meets = true;  ///< same wire, another build; else it uses other topics, and neither hears of the other
  bool operator==(const VersionSkew&) const = default;
};

/// In the order of `others`, each program once.
std::vector<VersionSkew> version_skew(const std::vector<Participant>& others, const Introduction& own);

/// "worker alpha/4711 (0.2.0) speaks lamprey/5, and this program lamprey/4: they never meet; install the same version
/// everywhere".
std::string to_text(const VersionSkew& skew, const Introduction& own);

}  // namespace lamprey::messaging::discovery
