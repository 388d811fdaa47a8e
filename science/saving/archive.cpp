#include "science/saving/archive.hpp"

#include <sstream>
#include <string>

namespace lamprey::science::saving {

void Reader::end() const {
  if (!octets_.empty()) throw Invalid(std::to_string(octets_.size()) + " octets too many");
}

void Reader::too_short(std::string_view name) {
  throw Invalid("it ends before " + std::string(name));
}

void Reader::not_finite(std::string_view name) {
  throw Invalid(std::string(name) + " is not a finite number");
}

void Reader::out_of_range(std::string_view name, std::int64_t value, std::int64_t minimum, std::int64_t maximum) {
  throw Invalid(std::string(name) + " is " + std::to_string(value) + ", but must be " + std::to_string(minimum) + ".." +
                std::to_string(maximum));
}

void real_within(Writer& archive, std::string_view name, double value, double /*minimum*/, double /*maximum*/) {
  archive.real(name, value);
}

void real_within(Reader& archive, std::string_view name, double& value, double minimum, double maximum) {
  archive.real(name, value);
  if (value >= minimum && value <= maximum) return;
  std::ostringstream message;
  message << name << " is " << value << ", but must be " << minimum << ".." << maximum;
  throw Invalid(message.str());
}

}  // namespace lamprey::science::saving
