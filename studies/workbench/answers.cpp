#include "studies/workbench/answers.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/base/error.h"
#include "engine/base/polygon.h"
#include "engine/config/table.h"
#include "engine/config/toml_reader.h"
#include "engine/run/run.h"
#include "equipment/catalogue/catalogue.h"
#include "groundmotions/synthetic/kinds.h"
#include "studies/bindings/finished_run.h"
#include "studies/findings/findings.h"
#include "studies/job/job.h"
#include "studies/limit_states/limit_state.h"
#include "studies/playback/page_data.h"
#include "studies/prepare/run_job.h"
#include "studies/render/render.h"
#include "studies/report/run_report.h"
#include "studies/results/results_file.h"
#include "studies/statistics/bands.h"
#include "studies/statistics/fragility.h"
#include "studies/workbench/as_json.h"

namespace gurney::workbench {
namespace {

Json entry(equipment::DataKind kind, const std::string& name) {
  config::Document file(equipment::find_data(kind, name, kJob));
  config::Table root = file.root();
  return {{"name", name}, {"title", root.text("name")}, {"about", root.text("description")}};
}

Json entries(equipment::DataKind kind) {
  Json all = Json::array();
  for (const std::string& name : equipment::catalogue_names(kind)) all.push_back(entry(kind, name));
  return all;
}

Json pair(double x, double y) { return {x, y}; }

/// Corners of a rectangle, anticlockwise.
Json rectangle(const Vector3& center, const Vector3& size) {
  const double x = size.x() / 2, y = size.y() / 2;
  return {pair(center.x() - x, center.y() - y), pair(center.x() + x, center.y() - y),
          pair(center.x() + x, center.y() + y), pair(center.x() - x, center.y() + y)};
}

/// A shape of an item that starts as `of`, seen from above in the axes of one that starts as `from`;
/// anticlockwise.
Json outline_of(const BodyShape& shape, const InitialMotion& of, const InitialMotion& from) {
  const Eigen::Rotation2Dd turn(of.yaw - from.yaw), back(-from.yaw);
  Json corners = Json::array();
  const auto add = [&](const Vector2& corner) {
    const Vector2 at = back * (of.position - from.position).head<2>() + turn * corner;
    corners.push_back(pair(at.x(), at.y()));
  };
  if (shape.is_box()) {
    for (const auto& corner : rectangle(shape.center, shape.size))
      add(Vector2(corner[0], corner[1]));
    return corners;
  }
  std::vector<Vector2> seen;
  for (const Vector3& point : outline_points(shape)) seen.push_back(point.head<2>());
  for (const Vector2& corner : convex_polygon(std::move(seen))) add(corner);
  return corners;
}

Json outline_of(const RoomShape& shape) {
  Json corners = Json::array();
  const auto* const box = std::get_if<RoomBox>(&shape.shape);
  const auto* const column = std::get_if<RoomColumn>(&shape.shape);
  const Vector3 size = box      ? box->size
                       : column ? Vector3(2 * column->radius, 2 * column->radius, column->height)
                                : Vector3(0.1, 0.1, 0.1);
  for (const auto& corner : rectangle(Vector3::Zero(), size)) {
    const Vector3 at = shape.position + shape.rotation * Vector3(corner[0], corner[1], 0);
    corners.push_back(pair(at.x(), at.y()));
  }
  return {{"name", shape.name}, {"corners", corners}, {"round", column != nullptr}};
}

study::Motion scaled_motion(study::RecordRequest request, double factor, std::size_t draw) {
  if (request.scale_to)
    request.scale_to->value *= factor;
  else
    request.scale *= factor;
  if (request.synthetic && request.synthetic->values.contains("seed"))
    request.synthetic->values["seed"] += static_cast<double>(draw);
  return study::motion_of(request);
}

/// Geometric mean of the horizontal peak accelerations [m/s2]; of the one where the other is none.
double horizontal_pga(const Vector3& pga) {
  const double product = pga.x() * pga.y();
  return product > 0 ? std::sqrt(product) : std::max(pga.x(), pga.y());
}

std::optional<study::JobModel>& kept_model() {
  static std::optional<study::JobModel> model;
  return model;
}

}  // namespace

void forget_files() { kept_model().reset(); }

Json catalogue_answer() {
  using equipment::DataKind;
  Json kinds = Json::array();
  for (const auto& kind : groundmotions::synthetic_kinds()) {
    Json parameters = Json::array();
    for (const auto& each : kind.parameters)
      parameters.push_back(
          {{"key", each.key}, {"meaning", each.meaning}, {"value", each.fallback}});
    kinds.push_back({{"name", kind.name}, {"about", kind.description}, {"parameters", parameters}});
  }
  return {{"items", entries(DataKind::kItem)},         {"casters", entries(DataKind::kCaster)},
          {"floors", entries(DataKind::kFloor)},       {"rooms", entries(DataKind::kRoom)},
          {"buildings", entries(DataKind::kBuilding)}, {"synthetic", kinds}};
}

Json plan_answer(const std::string& job) {
  config::Document document(job, kJob);
  const study::Job read = study::read_job(document);
  Json items = Json::array(), room = Json::array(), tethers = Json::array();
  for (std::size_t i = 0; i < read.scene.items.size(); ++i) {
    const PlacedItem& item = read.scene.items[i];
    if (const std::size_t owner = read.owners[i];
        owner != i) {  // a part or a content is drawn with its item
      for (const BodyShape& shape : item.model.shape)
        items[owner]["boxes"].push_back(
            outline_of(shape, item.initial, read.scene.items[owner].initial));
      continue;
    }
    Json boxes = Json::array(), wheels = Json::array();
    for (const BodyShape& shape : item.model.shape)
      boxes.push_back(outline_of(shape, item.initial, item.initial));
    for (const Caster& caster : item.model.casters)
      wheels.push_back({{"at", pair(caster.mount.x(), caster.mount.y())},
                        {"heading", caster.heading},
                        {"braked", caster.brake_torque > 0}});
    items.push_back({{"name", item.name},
                     {"model", item.model.name},
                     {"at", pair(item.initial.position.x(), item.initial.position.y())},
                     {"yaw", item.initial.yaw},
                     {"boxes", boxes},
                     {"wheels", wheels}});
  }
  for (const RoomShape& shape : read.scene.room) room.push_back(outline_of(shape));
  for (const Tether& tether : read.scene.tethers) {
    const Vector3 from = placed_point(read.scene, tether.item, tether.point),
                  to = placed_anchor(read.scene, tether);
    tethers.push_back({{"name", tether.name},
                       {"item", read.scene.items[tether.item].name},
                       {"from", pair(from.x(), from.y())},
                       {"to", pair(to.x(), to.y())}});
  }
  const bool building = read.record && read.record->building;
  return {{"items", items},
          {"room", room},
          {"tethers", tethers},
          {"storeys", building ? read.record->building->building.storeys : 0},
          {"tree", tree_of(config::read_toml(job, kJob))}};
}

/// "Overturned: pole." or "Nothing overturned; ventilator went farthest from its start, 201 mm."
std::string headline_of(const study::RunFacts& facts, const Response& response) {
  if (is_failure(response.outcome)) return response.cause;
  std::string overturned, farthest;
  double distance = -1;
  for (std::size_t i = 0; i < response.items.size(); ++i) {
    const Demands& demands = response.items[i].demands;
    const std::string& name = facts.scene.items[i].name;
    if (demands.time_of_overturning >= 0) overturned += (overturned.empty() ? "" : ", ") + name;
    if (demands.peak_displacement <= distance) continue;
    distance = demands.peak_displacement;
    farthest = name;
  }
  if (!overturned.empty()) return "Overturned: " + overturned + ".";
  return fmt::format("Nothing overturned; {} went farthest from its start, {:.0f} mm.", farthest,
                     1000 * distance);
}

/// A page shows the narrative elsewhere.
findings::Section without(findings::Section all, const findings::Texts& narrative) {
  std::erase_if(all.parts, [&](const findings::Part& part) {
    const auto* const section = std::get_if<findings::Section>(&part);
    return section != nullptr && findings::lines_of(*section) == narrative;
  });
  return all;
}

Json run_answer(const std::string& job) {
  const bindings::FinishedRun run = bindings::run_job({kJob, job, {}, true});
  const findings::Section all = report::run_findings(run.facts, run.response);
  const auto narrative = findings::lines_of(report::narrative(run.facts, run.response));
  Json answer{{"findings", Json::parse(render::json(all))},
              {"shown", shown(without(all, narrative))},
              {"narrative", narrative},
              {"headline", headline_of(run.facts, run.response)},
              {"outcome", name_of(run.response.outcome)},
              {"cause", run.response.cause},
              {"warnings", run.facts.warnings},
              {"limit_states", limit_states_of(run.facts, run.response)},
              {"simulated", run.response.end_time},
              {"recording", nullptr}};
  if (!run.response.items.empty() && run.response.items.front().history.size() > 1) {
    study::results_image(run.facts, run.response);
    answer["recording"] =
        Json::parse(playback::page_data({{"", playback::read_recorded_run(kJob)}}));
  }
  return answer;
}

Json case_answer(const std::string& job, std::size_t index) {
  static std::string text;
  std::optional<study::JobModel>& model = kept_model();
  if (!model || text != job) {
    config::Document document(job, kJob);
    model.emplace(document);
    text = job;
  }
  const std::size_t draw = index / kLevels;
  // From a third to three times the motion of the job, evenly in its logarithm.
  const double factor = std::pow(3, 2.0 * double(index % kLevels) / (kLevels - 1) - 1);
  study::Job drawn = study::sample(*model, Draw(1, draw));
  require(drawn.record.has_value(), "a fragility needs a motion of the floor");
  drawn.settings.history_step = 0;
  const study::RunFacts facts =
      study::prepare_run(drawn, scaled_motion(*drawn.record, factor, draw)).facts;
  const Response response = run(facts.scene, facts.floor, facts.settings);
  return {{"im", horizontal_pga(facts.record->pga)},
          {"draw", draw},
          {"failed", is_failure(response.outcome)},
          {"limit_states", limit_states_of(facts, response)}};
}

Json fragility_answer(const Json& cases) {
  Json curves = Json::array();
  double highest = 0;
  for (const Json& each : cases) highest = std::max(highest, each["im"].get<double>());
  std::vector<double> im;
  for (int i = 1; i <= 60; ++i) im.push_back(highest * i / 60);
  const std::vector<study::LimitState> states = study::default_limit_states();
  for (std::size_t s = 0; s < states.size(); ++s) {
    std::vector<statistics::Observation> runs;
    for (const Json& each : cases)
      if (!each["failed"])
        runs.push_back({each["im"], each["limit_states"][s]["exceeded"], each["draw"]});
    const statistics::StripeTable table(runs);
    const statistics::FragilityFit fit = statistics::fit_fragility(table);
    const statistics::FragilityBand band = statistics::fragility_band(table, im);
    Json one{{"name", states[s].name},
             {"words", states[s].words},
             {"status", statistics::text(fit.status)},
             {"runs", fit.runs},
             {"exceeded", fit.exceeded},
             {"im", im},
             {"curve", nullptr},
             {"low", Json::array()},
             {"high", Json::array()}};
    for (const statistics::Interval& each : band.of_curve) {
      one["low"].push_back(each.low);
      one["high"].push_back(each.high);
    }
    if (fit.curve) {
      one["curve"] = Json::array();
      for (const double at : im) one["curve"].push_back(fit.curve->probability(at));
      one["theta"] = fit.curve->theta;
      one["beta"] = fit.curve->beta;
      one["theta_band"] = {band.theta.low, band.theta.high};
    }
    curves.push_back(std::move(one));
  }
  return {{"curves", curves}};
}

}  // namespace gurney::workbench
