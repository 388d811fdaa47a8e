#include "experiment/yaml_tree.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>
#include <unordered_set>
#include <utility>
#include <yaml-cpp/anchor.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

namespace lamprey::experiment {

namespace {

/// Builds the tree from the parser's events; a limit that is passed ends the parsing by an exception.
class TreeBuilder final : public YAML::EventHandler {
 public:
  TreeBuilder(std::string file, std::vector<Problem>& problems) : file_(std::move(file)), problems_(problems) {}

  YamlNode take_root() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (std::exchange(has_document_, true)) {
      fail(mark, "a second document begins here, or something that belongs to none; a file holds one document");
    }
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    complete(make_node(YamlNode::Kind::null, mark, plain_tag, anchor));
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t /*anchor*/) override {
    fail(mark, "aliases (*name) are not allowed; write the value out");
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    YamlNode node = make_node(YamlNode::Kind::scalar, mark, tag, anchor);
    node.quoted = tag == quoted_tag;
    node.text = value;
    complete(std::move(node));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value /*style*/) override {
    open(make_node(YamlNode::Kind::list, mark, tag, anchor));
  }
  void OnSequenceEnd() override { close(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value /*style*/) override {
    open(make_node(YamlNode::Kind::mapping, mark, tag, anchor));
  }
  void OnMapEnd() override { close(); }

  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& message) {
    fail(mark.line + 1, mark.column + 1, message);
  }

 private:
  // What yaml-cpp reports as the tag of a node that has none.
  static constexpr const char* plain_tag = "?";
  static constexpr const char* quoted_tag = "!";

  /// A list or mapping that is being read.
  struct Open {
    YamlNode node;
    std::unordered_set<std::string> keys = {};
    bool has_key = false;   ///< of a mapping: the next node is a value
    bool keep_key = false;  ///< whether its key is good, so that the value is kept
  };

  void note(int line, int column, std::string message) {
    problems_.push_back({.field = "", .message = std::move(message), .file = file_, .line = line, .column = column});
    if (problems_.size() >= maximum_problems) throw InvalidInput(problems_);
  }

  [[noreturn]] void fail(int line, int column, std::string message) {
    note(line, column, std::move(message));
    throw InvalidInput(problems_);
  }

  YamlNode make_node(YamlNode::Kind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
    if (++nodes_ > maximum_yaml_nodes) {
      fail(mark, "more than " + std::to_string(maximum_yaml_nodes) + " values in one file; use ranges");
    }
    YamlNode node;
    node.kind = kind;
    node.line = mark.line + 1;
    node.column = mark.column + 1;
    if (anchor != YAML::NullAnchor) {
      note(node.line, node.column, "anchors (&name) are not allowed; remove it");
    }
    if (!tag.empty() && tag != plain_tag && tag != quoted_tag) {
      note(node.line, node.column, "tags (!name) are not allowed; remove '" + printable(tag) + "'");
    }
    return node;
  }

  void open(YamlNode node) {
    if (open_.size() == maximum_yaml_depth) {
      fail(node.line, node.column,
           "lists and mappings are nested more than " + std::to_string(maximum_yaml_depth) + " deep");
    }
    open_.push_back({.node = std::move(node)});
  }

  void close() {
    YamlNode node = std::move(open_.back().node);
    open_.pop_back();
    complete(std::move(node));
  }

  /// Puts a node that has been read to its end where it belongs.
  void complete(YamlNode node) {
    if (open_.empty()) {
      root_ = std::move(node);
      return;
    }
    Open& parent = open_.back();
    if (parent.node.kind == YamlNode::Kind::list) {
      parent.node.items.push_back(std::move(node));
    } else if (parent.has_key) {
      if (parent.keep_key) add_value(parent.node.entries.back(), std::move(node));
      parent.has_key = false;
    } else {
      begin_entry(parent, std::move(node));
    }
  }

  static void add_value(YamlEntry& entry, YamlNode value) {
    entry.value = std::move(value);
    if (entry.value.kind != YamlNode::Kind::null) return;
    // A value that isn't there stands, to the parser, where the next thing begins.
    entry.value.line = entry.line;
    entry.value.column = entry.column;
  }

  void begin_entry(Open& mapping, YamlNode key) {
    mapping.has_key = true;
    mapping.keep_key = false;
    if (key.kind != YamlNode::Kind::scalar) {
      note(key.line, key.column, "a key must be a name");
    } else if (!mapping.keys.insert(key.text).second) {
      note(key.line, key.column, first_use(mapping.node, key.text));
    } else {
      mapping.node.entries.push_back({.key = std::move(key.text), .line = key.line, .column = key.column, .value = {}});
      mapping.keep_key = true;
    }
  }

  static std::string first_use(const YamlNode& mapping, const std::string& key) {
    const auto first = std::ranges::find(mapping.entries, key, &YamlEntry::key);
    return "duplicate key '" + printable(key) + "', first used in line " + std::to_string(first->line);
  }

  std::string file_;
  std::vector<Problem>& problems_;
  std::vector<Open> open_;
  YamlNode root_;
  std::size_t nodes_ = 0;
  bool has_document_ = false;
};

/// Line and column (1-based, in bytes, as the YAML parser counts) of a byte of the text.
std::pair<int, int> position_of(std::string_view text, std::size_t byte) {
  const auto before = text.substr(0, byte);
  const auto line = std::ranges::count(before, '\n');
  const auto line_start = before.rfind('\n');
  const auto column = line_start == std::string_view::npos ? byte : byte - line_start - 1;
  return {static_cast<int>(line) + 1, static_cast<int>(column) + 1};
}

void check_text(const std::string& text, const std::string& file) {
  if (text.size() > maximum_yaml_bytes) {
    throw InvalidInput(Problem{.field = "",
                               .message = "the file is larger than " + std::to_string(maximum_yaml_bytes) + " bytes",
                               .file = file});
  }
  if (const auto unreadable = first_unreadable(text); unreadable != std::string::npos) {
    const auto [line, column] = position_of(text, unreadable);
    throw InvalidInput(Problem{
        .field = "",
        .message = "'" + printable(text.substr(unreadable, 1)) + "' is not text in UTF-8, or is a control character",
        .file = file,
        .line = line,
        .column = column});
  }
}

}  // namespace

const YamlNode* YamlNode::find(std::string_view key) const {
  const auto found = std::ranges::find(entries, key, &YamlEntry::key);
  return found == entries.end() ? nullptr : &found->value;
}

std::string kind_name(const YamlNode& node) {
  switch (node.kind) {
    case YamlNode::Kind::null:
      return "nothing";
    case YamlNode::Kind::scalar:
      return "'" + printable(node.text) + "'";
    case YamlNode::Kind::list:
      return "a list";
    case YamlNode::Kind::mapping:
      return "a mapping";
  }
  return {};
}

std::string read_yaml_text(const std::string& path) {
  const auto fail = [&](std::string message) {
    throw InvalidInput(Problem{.field = {}, .message = std::move(message), .file = path});
  };
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) fail("no such file");
  if (std::filesystem::is_directory(status)) fail("is a directory");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail("cannot be opened for reading");
  // One byte more than allowed tells parse_yaml that the file is too large; pipes have no size to ask for.
  std::string text(maximum_yaml_bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) fail("cannot be read");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

YamlNode parse_yaml(const std::string& text, const std::string& file, std::vector<Problem>& problems) {
  check_text(text, file);
  TreeBuilder builder(file, problems);
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    // The second call meets the end; the builder refuses anything else.
    if (parser.HandleNextDocument(builder)) parser.HandleNextDocument(builder);
  } catch (const YAML::Exception& error) {
    builder.fail(error.mark, "not valid YAML: " + printable(error.msg));
  }
  return builder.take_root();
}

}  // namespace lamprey::experiment
