#include "engine/response/response.h"

#include <array>

namespace gurney {

const char* name_of(Outcome outcome) {
  constexpr std::array kNames{"rested",     "still_moving", "stopped",
                              "overturned", "diverged",     "untrusted"};
  return kNames.at(static_cast<std::size_t>(outcome));
}

bool is_failure(Outcome outcome) {
  return outcome == Outcome::kDiverged || outcome == Outcome::kUntrusted;
}

bool is_failure(std::string_view outcome) {
  return outcome == name_of(Outcome::kDiverged) || outcome == name_of(Outcome::kUntrusted);
}

const char* name_of(WheelMode mode) {
  constexpr std::array kNames{"sticks", "rolls", "skids", "braked", "lifted"};
  return kNames.at(static_cast<std::size_t>(mode));
}

const char* name_of(Predictability::Verdict verdict) {
  constexpr std::array kNames{"predictable", "sensitive", "chaotic"};
  return kNames.at(static_cast<std::size_t>(verdict));
}

}  // namespace gurney
