#include "experiment/field_reader.hpp"

#include "experiment/typed_value.hpp"

namespace lamprey::experiment {

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
