#pragma once

#include <string>
#include <vector>

#include "studies/analysis/study_data.h"

namespace gurney::study {

/// How often items stood in a zone, over the runs of a configuration that did not fail.
struct ZoneOccupancy {
  std::string configuration, zone;
  std::size_t runs = 0, entered = 0, occupied_at_end = 0;
  std::size_t from_start = 0;      ///< runs in which an item stood in it at the start
  double occupied_time = 0;        ///< mean over the runs [s]
  double least_free_width = 0;     ///< median over the runs that know it [m]; NaN: none does
  double smallest_free_width = 0;  ///< of all runs [m]; NaN: none knows it
};

/// In order of the configurations and their zones; none where the file keeps no zones.
std::vector<ZoneOccupancy> zone_occupancy(const StudyData& data);

}  // namespace gurney::study
