#pragma once

#include <string>
#include <string_view>

namespace lamprey::messaging::program {

/// Of the project: "0.1.0".
std::string_view version();

/// The commit that was configured, shortened to 12 hex digits; empty if it was not known then.
std::string_view commit();

/// The compiler, the kind of build and its flags: "GNU 12.2.0 RelWithDebInfo -O2 -g1 -DNDEBUG".
std::string_view flags();

/// "0.1.0 (0123456789ab)", or "0.1.0" where the commit is not known. What --version prints and workers report.
std::string build();

}  // namespace lamprey::messaging::program
