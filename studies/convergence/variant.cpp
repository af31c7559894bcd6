#include "studies/convergence/variant.h"

#include <cmath>

namespace gurney::study {
namespace {

constexpr double kLongestStep = 0.02, kLoosestTolerance = 1e-3;

void scale_treads(Scene& scene, double factor) {
  for (PlacedItem& item : scene.items)
    for (Caster& caster : item.model.casters) {
      caster.tread.normal_stiffness *= factor;
      caster.tread.tangential_stiffness *= factor;
      caster.tread.normal_damping *= std::sqrt(factor);
      caster.tread.tangential_damping *= std::sqrt(factor);
    }
}

}  // namespace

std::vector<Variant> variants_for(const SimulationSettings& settings) {
  std::vector<Variant> variants{{Varied::kTimeStep, 1}};
  for (const double factor : {2.0, 0.5, 0.25, 0.125})
    if (factor * settings.time_step <= kLongestStep)
      variants.push_back({Varied::kTimeStep, factor});
  for (const double factor : {1e3, 1e-2})
    if (factor * settings.residual <= kLoosestTolerance)
      variants.push_back({Varied::kSolverTolerance, factor});
  for (const double factor : {0.25, 0.5, 2.0, 4.0})
    variants.push_back({Varied::kTreadStiffness, factor});
  return variants;
}

RunCase varied(RunCase run, const Variant& variant) {
  switch (variant.varied) {
    case Varied::kTimeStep:
      lengthen_steps(variant.factor, run.settings);
      break;
    case Varied::kSolverTolerance:
      run.settings.residual *= variant.factor;
      break;
    case Varied::kTreadStiffness:
      scale_treads(run.scene, variant.factor);
      break;
  }
  return run;
}

}  // namespace gurney::study
