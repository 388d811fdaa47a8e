#pragma once

// What the readers of a sweep file's parts share.

#include "experiment/parameters.hpp"
#include "experiment/problem.hpp"
#include "experiment/sweep.hpp"
#include "experiment/yaml_tree.hpp"
#include "idl/sweep.pb.h"

#include <string>
#include <vector>

namespace lamprey::experiment {

/// Reads values, remembers where each field stands, and notes what has the wrong shape. Refers to the positions.
class FieldReader {
 public:
  explicit FieldReader(SourceMap& positions) : positions_(positions) {}

  void place(const std::string& path, const YamlNode& node) { positions_[path] = {node.line, node.column}; }
  void place_key(const std::string& path, const YamlEntry& entry) { positions_[path] = {entry.line, entry.column}; }

  void refuse(const std::string& path, std::string message) { findings_.add(path, std::move(message)); }
  bool any_refused_within(std::string_view path) const { return findings_.any_within(path); }
  bool full() const { return findings_.full(); }

  /// A single value. One that is no number where it should be travels as text, for the validator to say what is
  /// allowed; `parameter` may be nullptr.
  void read_value(const std::string& path, const YamlNode& node, const Parameter* parameter, idl::Value& value);

  std::vector<Problem> take() { return findings_.take(); }

 private:
  SourceMap& positions_;
  Findings findings_{{}};
};

}  // namespace lamprey::experiment
