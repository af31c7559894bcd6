#include "groundmotions/record/record.h"

#include <algorithm>

namespace gurney::groundmotions {

const char* name_of(Direction direction) {
  switch (direction) {
    case Direction::kH1:
      return "h1";
    case Direction::kH2:
      return "h2";
    case Direction::kVertical:
      return "vertical";
  }
  return "";
}

double Component::duration() const {
  return static_cast<double>(std::max<Eigen::Index>(acceleration.size() - 1, 0)) * time_step;
}

double Record::time_step() const {
  for (const auto& component : components)
    if (component) return component->time_step;
  return 0;
}

Eigen::Index Record::samples() const {
  for (const auto& component : components)
    if (component) return component->acceleration.size();
  return 0;
}

}  // namespace gurney::groundmotions
