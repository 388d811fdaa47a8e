#pragma once

#include "messaging/port.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace lamprey::messaging::program {

/// Something that decides how a program joins, as it is said on the command line, in the environment or in a file.
struct JoinField {
  enum class Kind : unsigned char { single, list, flag };

  std::string name = {};      ///< in a configuration file: "peers"
  std::string option = {};    ///< "--peer"
  std::string variable = {};  ///< of the environment: "LAMPREY_PEERS"; empty: none
  std::string value = {};     ///< what a value is called in help: "HOST"; empty for a flag
  std::string meaning = {};   ///< for help
  Kind kind = Kind::single;
  /// Why a text can't be a value (of a flag: true or false), or nothing. Only what the text itself shows.
  std::string (*fault)(const std::string& value) = nullptr;
  /// The values, as texts; one of them, unless it is a list.
  std::vector<std::string> (*get)(const JoinOptions& options) = nullptr;
  /// `values`: without fault.
  void (*set)(JoinOptions& options, const std::vector<std::string>& values) = nullptr;
};

/// All of them. The variable of the domain is ROS_DOMAIN_ID where LAMPREY_DOMAIN isn't set.
std::vector<JoinField> join_fields();

}  // namespace lamprey::messaging::program
