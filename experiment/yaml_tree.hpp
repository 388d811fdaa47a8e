#pragma once

#include "experiment/problem.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lamprey::experiment {

/// What a YAML file may have. Checked while the text is read, before anything of that size is built.
inline constexpr std::size_t maximum_yaml_bytes = 1 << 20;
inline constexpr std::size_t maximum_yaml_depth = 8;  ///< of lists and mappings within each other
inline constexpr std::size_t maximum_yaml_nodes = 100'000;

struct YamlEntry;

/// One node of a YAML document, with the place (1-based) where it begins.
struct YamlNode {
  enum class Kind : unsigned char { null, scalar, list, mapping };

  Kind kind = Kind::null;
  bool quoted = false;             ///< of a scalar: written in quotes, so it is text whatever it looks like
  std::string text;                ///< of a scalar
  std::vector<YamlNode> items;     ///< of a list
  std::vector<YamlEntry> entries;  ///< of a mapping, in the order of the file; no key twice
  int line = 0;
  int column = 0;

  /// The value of a mapping's key, or nullptr.
  const YamlNode* find(std::string_view key) const;
};

struct YamlEntry {
  std::string key;
  int line = 0;  ///< of the key
  int column = 0;
  YamlNode value;
};

/// "nothing", "'walk'", "a list", "a mapping": what stands where something else should.
std::string kind_name(const YamlNode& node);

/// A file's text for parse_yaml, cut off where that would refuse its size. Throws InvalidInput where it can't be read.
std::string read_yaml_text(const std::string& path);

/// Reads one YAML document of the plain kind that our files are: scalars, lists and mappings with unique text keys;
/// no aliases, anchors or tags. `file` is only used in messages.
/// What leaves the rest readable (a duplicate key, an anchor, a tag) is added to `problems`; everything else throws
/// InvalidInput with those found until then. Thread-safe.
YamlNode parse_yaml(const std::string& text, const std::string& file, std::vector<Problem>& problems);

}  // namespace lamprey::experiment
