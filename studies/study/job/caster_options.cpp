#include "studies/study/job/caster_options.h"

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

void read_headings(equipment::Quantities& in, const equipment::ItemDescription& item,
                   equipment::ItemOptions& options, Remarks& remarks) {
  constexpr const char* kKey = "headings_deg";
  const std::vector<bool> swivels =
      casters_that(item, [](const equipment::CasterPlace& place) { return place.swivels; });
  options.headings = in.numbers(kKey, Range::any(), swivels);
  if (options.headings.size() != swivels.size()) return;
  const bool one_for_all = in.is_one_for_all(kKey);
  for (std::size_t i = 0; i < swivels.size(); ++i) {
    const equipment::CasterPlace& place = item.casters[i];
    double& heading = options.headings[i];
    heading *= kRadiansPerDegree;
    if (swivels[i]) continue;
    if (!one_for_all && !same_heading(heading, place.stated_heading))
      in.table().note_element(
          kKey, i,
          fmt::format(": caster '{}' of {} does not swivel: must be its heading there, {:g}",
                      place.name, item.name, place.stated_heading / kRadiansPerDegree));
    heading = place.heading;
  }
  if (one_for_all && !any(swivels))
    remarks.without_effect.push_back(fmt::format("{}: {}: has no effect: no caster of {} swivels",
                                                 in.table().where(kKey), in.table().name_of(kKey),
                                                 item.name));
}

/// A flag of a caster, and what a caster needs to have it.
struct CasterFlag {
  const char* key;
  std::vector<bool> meant;  ///< by one flag for all
  std::vector<bool> able;
  const char* lack;  ///< `has no brake`
};

std::vector<bool> read_flags(equipment::Quantities& in, const CasterFlag& flag,
                             const equipment::ItemDescription& item, Remarks& remarks) {
  Table& table = in.table();
  std::vector<bool> on = in.flags(flag.key, flag.able);
  if (on.size() != flag.able.size()) return on;
  const bool drawn = table.is_table(flag.key) && table.table(flag.key)->has("distribution");
  if (!in.is_one_for_all(flag.key)) {
    for (std::size_t i = 0; i < on.size(); ++i)
      if (on[i] && !flag.able[i])
        table.note_element(flag.key, i,
                           fmt::format(": caster '{}' of {} {}: must be false",
                                       item.casters[i].name, item.name, flag.lack));
    return on;
  }
  if (!any(on) && !drawn) return on;
  if (!any(flag.able))
    table.note(flag.key,
               fmt::format(": has no effect: every caster of {} {}", item.name, flag.lack));
  else
    for (std::size_t i = 0; i < on.size(); ++i)
      if (flag.meant[i] && !flag.able[i])
        remarks.warnings.push_back(fmt::format("{}: no effect on caster '{}', which {}",
                                               table.name_of(flag.key), item.casters[i].name,
                                               flag.lack));
  for (std::size_t i = 0; i < on.size(); ++i) on[i] = on[i] && flag.able[i];
  return on;
}

}  // namespace

void read_caster_options(equipment::Quantities& in, const equipment::ItemDescription& item,
                         equipment::ItemOptions& options, Remarks& remarks) {
  const auto type = [&](const equipment::CasterPlace& place) -> const equipment::CasterType& {
    return options.caster ? *options.caster : place.type;
  };
  const std::vector<bool> all(item.casters.size(), true);
  read_headings(in, item, options, remarks);
  options.brakes = read_flags(
      in,
      {"brakes", all,
       casters_that(item, [&](const auto& place) { return type(place).brake_torque > 0; }),
       "has no brake (brake_torque_n_m of its caster)"},
      item, remarks);
  options.swivel_locks = read_flags(
      in,
      {"swivel_locks", casters_that(item, [](const auto& place) { return place.swivels; }),
       casters_that(
           item,
           [&](const auto& place) { return place.swivels && type(place).swivel_lock_torque > 0; }),
       "does not swivel, or has no lock (swivel_lock_torque_n_m of its caster)"},
      item, remarks);
}

}  // namespace gurney::study
