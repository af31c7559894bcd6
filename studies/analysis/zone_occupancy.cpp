#include "studies/analysis/zone_occupancy.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "studies/statistics/quantiles.h"

namespace gurney::study {
namespace {

/// The columns of /zones.
struct ZoneTable {
  explicit ZoneTable(const StudyReader& file)
      : zone(file.strings("zones/zone")),
        entry(file.numbers("zones/time_of_entry")),
        time(file.numbers("zones/occupied_time")),
        at_end(file.numbers("zones/occupied_at_end")),
        width(file.numbers("zones/least_free_width")),
        rows(file.rows_of_runs("zones")) {}

  std::vector<std::string> zone;
  std::vector<double> entry, time, at_end, width;
  std::vector<std::pair<std::size_t, std::size_t>> rows;
};

}  // namespace

std::vector<ZoneOccupancy> zone_occupancy(const StudyData& data) {
  std::vector<ZoneOccupancy> all;
  if (!data.file().has("zones")) return all;
  const ZoneTable table(data.file());
  for (std::size_t i = 0; i < data.configurations().size(); ++i) {
    const std::size_t first = all.size();
    std::map<std::string, std::size_t> place;
    std::vector<std::vector<double>> widths;
    for (const std::size_t run : data.runs_of(i))
      for (std::size_t row = table.rows[run].first; row < table.rows[run].second; ++row) {
        const auto [at, is_new] = place.emplace(table.zone[row], place.size());
        if (is_new) {
          all.push_back({data.configurations()[i], table.zone[row]});
          widths.emplace_back();
        }
        ZoneOccupancy& of = all[first + at->second];
        ++of.runs;
        of.entered += table.entry[row] >= 0;
        of.from_start += table.entry[row] == 0;
        of.occupied_at_end += table.at_end[row] != 0;
        of.occupied_time += table.time[row];
        if (!std::isnan(table.width[row])) widths[at->second].push_back(table.width[row]);
      }
    for (std::size_t k = 0; k < widths.size(); ++k) {
      ZoneOccupancy& of = all[first + k];
      of.occupied_time /= static_cast<double>(of.runs);
      const bool none = widths[k].empty();
      of.least_free_width = none ? std::nan("") : statistics::quantile_of(widths[k], 0.5);
      of.smallest_free_width = none ? std::nan("") : *std::ranges::min_element(widths[k]);
    }
  }
  return all;
}

}  // namespace gurney::study
