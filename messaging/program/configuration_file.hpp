#pragma once

#include "messaging/program/join_fields.hpp"

#include <string>
#include <string_view>
#include <vector>

/// How programs of a site join, in a file: docs/formats/configuration.md.
namespace lamprey::messaging::program {

struct Configuration {
  struct Entry {
    std::string field;
    std::vector<std::string> values;  ///< without fault; one, unless the field is a list
    int line = 0;                     ///< of the field
  };
  std::string file;  ///< empty: there is none
  std::vector<Entry> entries;

  /// nullptr where the file doesn't say.
  const Entry* find(std::string_view field) const;
};

/// The first that is there of $XDG_CONFIG_HOME/lamprey/lamprey.yaml (by default ~/.config/lamprey/lamprey.yaml) and
/// /etc/lamprey/lamprey.yaml, or nothing.
std::string usual_configuration_file();

/// Throws experiment::InvalidInput with all that is wrong: file, line, field, value, and what would be right.
Configuration read_configuration(const std::string& file, const std::vector<JoinField>& fields);

}  // namespace lamprey::messaging::program
