#include "studies/job/caster_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/units.h"
#include "engine/config/table.h"

namespace gurney::study {
namespace {

using config::Range;
using config::Table;

constexpr double kSameHeading = 1e-9;  // [rad] rounding of degrees, twice

template <typename Able>
std::vector<bool> casters_that(const equipment::ItemDescription& item, Able able) {
  std::vector<bool> result;
  for (const equipment::CasterPlace& place : item.casters) result.push_back(able(place));
  return result;
}

bool any(const std::vector<bool>& flags) {
  return std::find(flags.begin(), flags.end(), true) != flags.end();
}

bool same_heading(double a, double b) {
  return std::abs(std::remainder(a - b, 2 * std::numbers::pi)) <= kSameHeading;
}

void read_headings(equipment::Quantities& in, equipment::Uncertain<JobItem>& result,
                   Remarks& remarks) {
  constexpr const char* kKey = "headings_deg";
  const equipment::ItemDescription& item = result.stated().description;
  const std::vector<bool> swivels =
      casters_that(item, [](const equipment::CasterPlace& place) { return place.swivels; });
  const equipment::QuantityList headings = in.numbers(kKey, Range::any(), swivels);
  if (headings.quantities.empty()) return;
  const bool one_for_all = in.is_one_for_all(kKey);
  for (std::size_t i = 0; i < swivels.size() && !one_for_all; ++i) {
    const equipment::CasterPlace& place = item.casters[i];
    if (swivels[i] ||
        same_heading(headings.quantities[i].value * kRadiansPerDegree, place.stated_heading))
      continue;
    in.table().note_element(
        kKey, i,
        fmt::format(": caster '{}' of {} does not swivel: must be its heading there, {:g}",
                    place.name, item.name, place.stated_heading / kRadiansPerDegree));
  }
  if (one_for_all && !any(swivels))
    remarks.without_effect.push_back(fmt::format("{}: {}: has no effect: no caster of {} swivels",
                                                 in.table().where(kKey), in.table().name_of(kKey),
                                                 item.name));
  result.add([headings, swivels](JobItem& of_draw, equipment::Sampler& of) {
    of_draw.options.headings = of(headings);
    for (std::size_t i = 0; i < swivels.size(); ++i) {
      double& heading = of_draw.options.headings[i];
      heading = swivels[i] ? heading * kRadiansPerDegree : of_draw.description.casters[i].heading;
    }
  });
}

/// A flag of a caster, and what a caster needs to have it.
struct CasterFlag {
  const char* key;
  std::vector<bool> meant;  ///< by one flag for all
  std::vector<bool> able;
  const char* missing;  ///< `has no brake`
};

void check_flags(equipment::Quantities& in, const CasterFlag& flag, const std::vector<bool>& on,
                 const equipment::ItemDescription& item, Remarks& remarks) {
  Table& table = in.table();
  if (!in.is_one_for_all(flag.key)) {
    for (std::size_t i = 0; i < on.size(); ++i)
      if (on[i] && !flag.able[i])
        table.note_element(flag.key, i,
                           fmt::format(": caster '{}' of {} {}: must be false",
                                       item.casters[i].name, item.name, flag.missing));
    return;
  }
  const bool drawn = table.is_table(flag.key) && table.table(flag.key)->has("distribution");
  if (!any(on) && !drawn) return;
  if (!any(flag.able))
    table.note(flag.key,
               fmt::format(": has no effect: every caster of {} {}", item.name, flag.missing));
  else
    for (std::size_t i = 0; i < on.size(); ++i)
      if (flag.meant[i] && !flag.able[i])
        remarks.warnings.push_back(fmt::format("{}: no effect on caster '{}', which {}",
                                               table.name_of(flag.key), item.casters[i].name,
                                               flag.missing));
}

/// Into `target`, false where the caster cannot have it, and into `drawn` whether draws decide.
void read_flags(equipment::Quantities& in, const CasterFlag& flag,
                std::vector<bool> equipment::ItemOptions::*target,
                std::vector<bool> equipment::ItemOptions::*drawn,
                equipment::Uncertain<JobItem>& result, Remarks& remarks) {
  const equipment::QuantityList list = in.flags(flag.key, flag.able);
  if (list.quantities.empty()) return;
  std::vector<bool> on;
  for (const equipment::StatedQuantity& each : list.quantities) on.push_back(each.value != 0);
  check_flags(in, flag, on, result.stated().description, remarks);
  result.add([list, target, drawn, able = flag.able](JobItem& of_draw, equipment::Sampler& of) {
    const std::vector<double> values = of(list);
    for (std::size_t i = 0; i < values.size(); ++i) {
      (of_draw.options.*target).push_back(values[i] != 0 && able[i]);
      (of_draw.options.*drawn).push_back(list.quantities[i].uncertainty && able[i]);
    }
  });
}

/// Shares of the holding torque with which brakes that are on are set.
void read_brake_shares(equipment::Quantities& in, equipment::Uncertain<JobItem>& result,
                       Remarks& remarks) {
  constexpr const char* kKey = "brake_share";
  const std::vector<bool> able = casters_that(
      result.stated().description, [](const auto& place) { return place.type.brake_torque > 0; });
  const equipment::QuantityList list = in.numbers(kKey, Range::within(0, 1), able);
  if (list.quantities.empty()) return;
  const equipment::ItemOptions& options = result.stated().options;
  bool used = false;
  for (std::size_t i = 0; i < able.size(); ++i) {
    const equipment::CasterPlace& place = result.stated().description.casters[i];
    const bool on = options.brakes.empty() ? place.brake_on || place.brake_drawn
                                           : options.brakes[i] || options.brakes_drawn[i];
    used = used || (able[i] && on);
  }
  if (!used)
    remarks.without_effect.push_back(fmt::format("{}: {}: has no effect: no brake of {} is on",
                                                 in.table().where(kKey), in.table().name_of(kKey),
                                                 result.stated().description.name));
  result.add([list](JobItem& of_draw, equipment::Sampler& of) {
    of_draw.options.brake_shares = of(list);
  });
}

}  // namespace

void read_caster_options(equipment::Quantities& in, equipment::Uncertain<JobItem>& result,
                         Remarks& remarks) {
  const equipment::ItemDescription& item = result.stated().description;
  const std::vector<bool> all(item.casters.size(), true);
  read_headings(in, result, remarks);
  read_flags(in,
             {"brakes", all,
              casters_that(item, [](const auto& place) { return place.type.brake_torque > 0; }),
              "has no brake (brake_torque_n_m of its caster)"},
             &equipment::ItemOptions::brakes, &equipment::ItemOptions::brakes_drawn, result,
             remarks);
  read_brake_shares(in, result, remarks);
  read_flags(
      in,
      {"swivel_locks", casters_that(item, [](const auto& place) { return place.swivels; }),
       casters_that(
           item,
           [](const auto& place) { return place.swivels && place.type.swivel_lock_torque > 0; }),
       "does not swivel, or has no lock (swivel_lock_torque_n_m of its caster)"},
      &equipment::ItemOptions::swivel_locks, &equipment::ItemOptions::locks_drawn, result, remarks);
}

}  // namespace gurney::study
