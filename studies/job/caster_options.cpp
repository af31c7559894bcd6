#include "studies/job/caster_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/units.h"

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
  const char* lack;  ///< `has no brake`
};

void check_flags(equipment::Quantities& in, const CasterFlag& flag, const std::vector<bool>& on,
                 const equipment::ItemDescription& item, Remarks& remarks) {
  Table& table = in.table();
  if (!in.is_one_for_all(flag.key)) {
    for (std::size_t i = 0; i < on.size(); ++i)
      if (on[i] && !flag.able[i])
        table.note_element(flag.key, i,
                           fmt::format(": caster '{}' of {} {}: must be false",
                                       item.casters[i].name, item.name, flag.lack));
    return;
  }
  const bool drawn = table.is_table(flag.key) && table.table(flag.key)->has("distribution");
  if (!any(on) && !drawn) return;
  if (!any(flag.able))
    table.note(flag.key,
               fmt::format(": has no effect: every caster of {} {}", item.name, flag.lack));
  else
    for (std::size_t i = 0; i < on.size(); ++i)
      if (flag.meant[i] && !flag.able[i])
        remarks.warnings.push_back(fmt::format("{}: no effect on caster '{}', which {}",
                                               table.name_of(flag.key), item.casters[i].name,
                                               flag.lack));
}

/// Into `target`; false where the caster cannot have it.
void read_flags(equipment::Quantities& in, const CasterFlag& flag,
                std::vector<bool> equipment::ItemOptions::*target,
                equipment::Uncertain<JobItem>& result, Remarks& remarks) {
  const equipment::QuantityList list = in.flags(flag.key, flag.able);
  if (list.quantities.empty()) return;
  std::vector<bool> on;
  for (const equipment::StatedQuantity& each : list.quantities) on.push_back(each.value != 0);
  check_flags(in, flag, on, result.stated().description, remarks);
  result.add([list, target, able = flag.able](JobItem& of_draw, equipment::Sampler& of) {
    const std::vector<double> values = of(list);
    std::vector<bool>& flags = of_draw.options.*target;
    for (std::size_t i = 0; i < values.size(); ++i) flags.push_back(values[i] != 0 && able[i]);
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
             &equipment::ItemOptions::brakes, result, remarks);
  read_flags(in,
             {"swivel_locks", casters_that(item, [](const auto& place) { return place.swivels; }),
              casters_that(item,
                           [](const auto& place) {
                             return place.swivels && place.type.swivel_lock_torque > 0;
                           }),
              "does not swivel, or has no lock (swivel_lock_torque_n_m of its caster)"},
             &equipment::ItemOptions::swivel_locks, result, remarks);
}

}  // namespace gurney::study
