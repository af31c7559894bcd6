#include "studies/verification/cases/rocking_body.h"

#include <cmath>

#include "engine/base/units.h"
#include "studies/verification/scenes/blocks.h"

namespace gurney::verification {

double RockingBody::width() const { return 2 * radius * std::sin(alpha); }
double RockingBody::height() const { return 2 * radius * std::cos(alpha); }

RockingBlock RockingBody::block() const {
  return {alpha, std::sqrt(kStandardGravity / (inertia * radius)),
          1 - 2 * std::pow(std::sin(alpha), 2) / inertia};
}

Scene RockingBody::scene() const {
  // An impulse at the edge leans by up to (4/3 tan + 1/3 cot) alpha: friction 5 holds it.
  Scene scene = blocks::block(kMass, {width(), 1, height()},
                              {.stiffness = kStiffness, .restitution = kRebound, .friction = 5});
  scene.items[0].model.chassis_inertia =
      (inertia - 1) * kMass * radius * radius * Matrix3::Identity();
  return scene;
}

double RockingBody::loading_time() const {
  return 0.5 * std::numbers::pi * std::sqrt(kMass / kStiffness);
}

}  // namespace gurney::verification
