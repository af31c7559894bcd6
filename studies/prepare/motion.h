#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/floor_motion.h"
#include "groundmotions/record/record.h"
#include "studies/job/job.h"
#include "studies/results/run_facts.h"

namespace gurney::study {

/// The motion of the floor, and what is to be reported of it.
struct Motion {
  FloorMotion floor;
  RecordFacts facts;
  std::vector<std::string> warnings;
  std::optional<std::uint64_t> seed;  ///< of a synthetic motion that is random
};

/// Reads the record a job asks for, processes and scales it, lets it pass through the building, and
/// turns it into floor axes.
/// @throws Error for a record that cannot be read or processed, lacks a component that the job does
///         not leave out, or looks implausible where the job refuses that.
Motion motion_of(const RecordRequest& request);

/// The same of a record that is there already, read or made and processed.
Motion motion_of(const groundmotions::Record& raw, const RecordRequest& request);

/// The parts of motion_of(), for studies, which scale and turn one record many times: read or made
/// and processed; taken through the building; turned, with the components that act.
groundmotions::Record ground_record(const RecordRequest& request);
groundmotions::Record floor_record_of(const groundmotions::Record& ground,
                                      const RecordRequest& request);
FloorMotion in_floor_axes(const groundmotions::Record& floor, const RecordRequest& request,
                          double angle);

/// The same as in_floor_axes(), with what is to be reported of it.
Motion as_motion(const groundmotions::Record& floor, const RecordRequest& request, double angle);

}  // namespace gurney::study
