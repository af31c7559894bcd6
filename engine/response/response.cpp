#include "engine/response/response.h"

namespace gurney {

const char* name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::kRested:
      return "rested";
    case Outcome::kStillMoving:
      return "still_moving";
    case Outcome::kStopped:
      return "stopped";
    case Outcome::kOverturned:
      return "overturned";
    case Outcome::kDiverged:
      return "diverged";
    case Outcome::kUntrusted:
      return "untrusted";
  }
  return "unknown";
}

bool is_failure(Outcome outcome) {
  return outcome == Outcome::kDiverged || outcome == Outcome::kUntrusted;
}

bool is_failure(std::string_view outcome) {
  return outcome == name_of(Outcome::kDiverged) || outcome == name_of(Outcome::kUntrusted);
}

const char* name_of(WheelMode mode) {
  switch (mode) {
    case WheelMode::kSticks:
      return "sticks";
    case WheelMode::kRolls:
      return "rolls";
    case WheelMode::kSkids:
      return "skids";
    case WheelMode::kBraked:
      return "braked";
    case WheelMode::kLifted:
      return "lifted";
  }
  return "unknown";
}

const char* name_of(Predictability::Verdict verdict) {
  switch (verdict) {
    case Predictability::Verdict::kPredictable:
      return "predictable";
    case Predictability::Verdict::kSensitive:
      return "sensitive";
    case Predictability::Verdict::kChaotic:
      break;
  }
  return "chaotic";
}

}  // namespace gurney
