#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lamprey::robot_bridge::emulators {

/// A foot's contact: closed while a servo is at or beyond a threshold.
struct FootSwitch {
  unsigned input;    ///< an input's or bit's number
  unsigned servo;    ///< the leg's vertical one: its channel or id
  bool below;        ///< closed at or below the threshold, else at or above it
  double threshold;  ///< in the controller's unit
  bool closed_at(double position) const { return below ? position <= threshold : position >= threshold; }
};

/// What a foot switch may be.
struct FootSwitchForm {
  bool letters;     ///< inputs are A, B, C … instead of 0, 1, 2 …
  unsigned inputs;  ///< how many there are
  unsigned lowest_servo;
  unsigned highest_servo;
  int lowest;  ///< thresholds
  int highest;
};

/// "A=0<=1000": input, servo, side, threshold. Throws std::invalid_argument with what is wrong, and what would be
/// right.
FootSwitch parse_foot_switch(std::string_view text, const FootSwitchForm& form);

/// A whole number without sign or spaces around it; nothing if it is none, or has more than nine digits.
std::optional<int> parse_number(std::string_view digits);

}  // namespace lamprey::robot_bridge::emulators
