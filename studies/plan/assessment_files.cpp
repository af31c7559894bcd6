#include "studies/plan/assessment_files.h"

#include "engine/config/document.h"
#include "engine/config/table.h"
#include "equipment/catalogue/check_file.h"
#include "studies/job/scale_reader.h"
#include "studies/limit_states/limit_state_reader.h"
#include "studies/plan/study.h"

namespace gurney::study {
namespace {

config::Table root_of(config::Document& document, const std::string& schema) {
  equipment::refuse_other_kind(document, schema);
  config::Table root = document.root();
  root.choice("schema", {schema});
  root.text("title", "");
  return root;
}

}  // namespace

LimitStatesFile read_limit_states_file(const std::string& path,
                                       const std::vector<LimitState>& of_job) {
  config::Document document(path);
  config::Table root = root_of(document, "gurney-limit-states/1");
  LimitStatesFile file{of_job, {}, {}};
  if (root.has("limit_state")) {
    file.states = read_limit_states(root);
    for (const config::Node& each : document.tree().find("limit_state")->elements)
      file.where.push_back(document.where(each.place));
  } else if (!root.has("performance")) {
    root.note("limit_state", ": must be given, tables [[limit_state]], or performance, or both");
  }
  file.performance = read_performance(root, file.states);
  document.finish();
  return file;
}

SiteHazard read_hazard_file(const std::string& path) {
  config::Document document(path);
  config::Table root = root_of(document, "gurney-hazard/1");
  const ScalingTarget target = read_scaling_target(root);
  IntensityPlan intensity;
  intensity.kind = IntensityPlan::Kind::kStripes;
  intensity.unit_in_si = target.unit_in_si;
  const std::optional<statistics::HazardCurve> curve = read_hazard(root, intensity);
  document.finish();
  return {*curve, name_of(target.measure) + " " + name_of(target.combination),
          root.where("measure")};
}

}  // namespace gurney::study
