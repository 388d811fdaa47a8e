#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lamprey::messaging::discovery {

/// Who a program is: told to everybody by its participant's user data, so that it can be read by our own `lamprey net`
/// and by any vendor's tools.
struct Introduction {
  std::string role;  ///< "coordinator", "worker", "client", "bridge" …; empty: a program that doesn't introduce itself
  std::string host;
  std::uint32_t process = 0;
  std::string build;       ///< what --version prints
  std::string isolation;   ///< programs of other isolations never meet it
  std::uint32_t wire = 0;  ///< the version in the names of its topics
  bool operator==(const Introduction&) const = default;
};

/// "lamprey;wire=4;role=worker;host=alpha;process=4711;isolation=lamprey;build=0.1.0 (0123456789ab)". What would end a
/// value, or is not printable ASCII, is replaced by '_'; values are cut to 128 characters.
std::string user_data_of(const Introduction& introduction);

/// Nothing where the octets are no program's of ours, whoever sent them.
std::optional<Introduction> introduction_in(std::string_view user_data);

}  // namespace lamprey::messaging::discovery
