#include "studies/cli/explained_case.h"

#include "engine/base/error.h"
#include "engine/run/run.h"
#include "studies/explanation/explain.h"
#include "studies/report/run_report.h"

namespace gurney::cli {

Explained explained(const CaseAgain& again, const study::UnitSystem& units) {
  const study::RunFacts& facts = again.run.facts;
  const auto settings =
      explanation::finely_stored(facts.settings, facts.floor, facts.scene.items.size());
  Response response = gurney::run(facts.scene, facts.floor, settings);
  const std::string differs = again.difference(response);
  require(differs.empty(), differs);
  add_predictability(facts.scene, facts.floor, settings, response);
  explanation::Explanation found = explanation::explain(facts, response);
  found.units = units;
  return {std::move(found), report::narrative(facts, response, units)};
}

}  // namespace gurney::cli
