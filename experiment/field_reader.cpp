#include "experiment/field_reader.hpp"

#include "experiment/typed_value.hpp"

namespace lamprey::experiment {

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

std::string nearest_hint(std::string_view name, const std::vector<std::string_view>& known) {
  const std::string nearest = nearest_name(name, known);
  return nearest.empty() ? std::string() : "; did you mean '" + nearest + "'?";
}

void FieldReader::read_value(const std::string& path, const YamlNode& node, const Parameter* parameter,
                             idl::Value& value) {
  if (node.kind == YamlNode::Kind::list || node.kind == YamlNode::Kind::mapping) {
    return refuse(path, "takes a single value; this is " + kind_name(node));
  }
  if (node.kind == YamlNode::Kind::null) return;
  if (parameter == nullptr || node.quoted) {
    value.set_text(node.text);
  } else {
    value = value_of_text(parameter->kind, node.text);
  }
}

}  // namespace lamprey::experiment
