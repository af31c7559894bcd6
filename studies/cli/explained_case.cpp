#include "studies/cli/explained_case.h"

#include "engine/base/error.h"
#include "engine/base/parallel.h"
#include "engine/run/run.h"
#include "studies/explanation/explain.h"
#include "studies/report/run_report.h"

namespace gurney::cli {

Explained explained(const CaseAgain& again, const study::UnitSystem& units) {
  const study::RunFacts& facts = again.run.facts;
  const auto settings =
      explanation::finely_stored(facts.settings, facts.floor, facts.scene.items.size());
  const Response response =
      run_judged(facts.scene, facts.floor, settings, threads_or_all()).response;
  const std::string differs = again.difference(response);
  require(differs.empty(), differs);
  explanation::Explanation found = explanation::explain(facts, response);
  found.units = units;
  return {std::move(found), report::narrative(facts, response, units)};
}

}  // namespace gurney::cli
