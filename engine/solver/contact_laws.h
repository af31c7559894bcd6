#pragma once

#include <vector>

#include "engine/contact/body_contact.h"
#include "engine/contact/impact_law.h"
#include "engine/scene/scene.h"

namespace gurney {

/// The law of every contact a scene may have.
///
/// A chassis meets floor, room and other chassis with the constants of their materials. A wheel
/// meets all but the floor below it with its tread; of two wheels that meet, the earlier item's
/// tread counts.
class ContactLaws {
 public:
  /// @throws Error when named materials have no pair.
  explicit ContactLaws(const Scene& scene);

  const ImpactLaw& of(const BodyContact& contact) const;

 private:
  struct Item {
    std::vector<ImpactLaw> others;   // the chassis with floor and room shapes
    std::vector<ImpactLaw> chassis;  // the chassis with that of every later item
    std::vector<ImpactLaw> wheels;
  };
  std::vector<Item> items_;
};

}  // namespace gurney
