#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/floor_motion.h"
#include "engine/scene/scene.h"
#include "equipment/catalogue/assumption.h"
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

/// Motion of a record that is there already, read or generated and processed.
Motion motion_of(const groundmotions::Record& raw, const RecordRequest& request);

/// Motion of the record of a job; none where the floor rests.
std::optional<Motion> motion_of(const Job& job);

/// The parts of motion_of(), for studies, which scale and turn one record many times: read or made
/// and processed; taken through the building; turned, with the components that act.
groundmotions::Record ground_record(const RecordRequest& request);
groundmotions::Record floor_record_of(const groundmotions::Record& ground,
                                      const RecordRequest& request);
FloorMotion in_floor_axes(const groundmotions::Record& floor, const RecordRequest& request,
                          double angle);

/// Does as in_floor_axes(), with the facts that are reported of it.
Motion as_motion(const groundmotions::Record& floor, const RecordRequest& request, double angle);

/// An assumption as results and summaries state it.
AssumptionFacts facts_of(const equipment::Assumption& assumption);

/// A job with its record read: run(facts.scene, facts.floor, facts.settings) runs it.
struct PreparedRun {
  RunFacts facts;
};

/// @param motion  of the floor; none: it rests
PreparedRun prepare_run(const Job& job, std::optional<Motion> motion);

/// Reads a job file and the record it asks for.
/// @throws Error with every error found in the job, its data files and its record.
PreparedRun prepare_run(const std::string& job_path);

}  // namespace gurney::study
