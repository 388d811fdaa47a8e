#include "client/json.hpp"

namespace lamprey::client {

Json document(std::string_view command, int version) {
  return {{"schema", "lamprey/" + std::string(command) + "/" + std::to_string(version)}};
}

void print(const output::Console& console, const Json& document) {
  // Text from outside may hold bytes that are no UTF-8: they must not cost the document.
  console.out << document.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

void print_line(const output::Console& console, const Json& document) {
  console.out << document.dump(-1, ' ', false, Json::error_handler_t::replace) << std::endl;
}

Json as_json(const experiment::Value& value) {
  return std::visit([](const auto& held) { return Json(held); }, value);
}

Json as_json(const experiment::Score& score) {
  return {{"stability", score.stability}, {"distance", score.distance}, {"fuel", score.fuel}, {"total", score.total}};
}

Json as_json(const experiment::Parameters& parameters) {
  Json json = Json::object();
  const auto registry = experiment::registry();
  for (std::size_t row = 0; row < registry.size(); ++row) {
    if (parameters.applies(row)) json[std::string(registry[row].name)] = as_json(parameters[row]);
  }
  return json;
}

}  // namespace lamprey::client
