#include "studies/plan/assessment_files.h"

#include <fmt/format.h>

#include <filesystem>
#include <limits>

#include "engine/base/error.h"
#include "engine/config/document.h"
#include "engine/config/table.h"
#include "equipment/catalogue/check_file.h"
#include "groundmotions/hazard/hazard_curve_file.h"
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

/// The curve of a file of OpenQuake or of the USGS, which states the unit, but not the component.
SiteHazard read_published(config::Table& root, const std::string& kind) {
  config::Document& document = root.document();
  const bool of_usgs = kind == "usgs";
  for (const char* key : {"unit", "im", "rate_per_year", "k0", "k"})
    if (root.has(key)) root.note(key, ": the file named by " + kind + " states it");
  if (!of_usgs && root.has("measure")) root.note("measure", ": the file of OpenQuake states it");
  const std::filesystem::path folder = std::filesystem::path(document.path()).parent_path();
  const std::string file = (folder / root.text(kind)).lexically_normal().string();
  std::optional<int> site;
  if (!of_usgs && root.has("site")) site = root.integer("site", 1, std::numeric_limits<int>::max());
  std::string wanted;
  if (of_usgs && root.has("measure")) wanted = name_of(read_measure(root));
  groundmotions::PublishedHazard found;
  try {
    found = of_usgs ? groundmotions::read_usgs_hazard(file, wanted)
                    : groundmotions::read_openquake_hazard(file, site);
  } catch (const Error& error) {
    document.note(error);
  }
  const groundmotions::Measure measure =
      groundmotions::parse_measure(found.measure.empty() ? "PGA" : found.measure);
  const groundmotions::Combination component = read_combination(root, measure);
  document.finish();
  return {statistics::HazardCurve::table(found.im, found.rate),
          name_of(measure) + " " + name_of(component), root.where(kind)};
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
  const auto name_it = [&](const std::string& kind) {
    throw Error(
        fmt::format("{}: does not state the component of its measure; name it in a file of "
                    "its own: schema = \"gurney-hazard/1\", {} = \"{}\", component = "
                    "\"RotD50\"",
                    path, kind, std::filesystem::path(path).filename().string()));
  };
  if (path.ends_with(".csv")) name_it("openquake");
  config::Document document(path);
  if (path.ends_with(".json") && document.tree().find("response")) name_it("usgs");
  return read_site_hazard(document);
}

SiteHazard read_site_hazard(config::Document& document) {
  config::Table root = root_of(document, "gurney-hazard/1");
  for (const char* kind : {"openquake", "usgs"})
    if (root.has(kind)) return read_published(root, kind);
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
