#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "groundmotions/measures/combination.h"
#include "studies/analysis/stored_histories.h"
#include "studies/analysis/study_data.h"

namespace gurney::study {

/// Response spectra (5 % damping) of the motions that configurations of a study share.
struct SuiteSpectra {
  struct Record {
    std::string name;
    double factor = 1;       ///< on the ground motion
    Eigen::VectorXd ground;  ///< of the record as read and processed [m/s2]
    Eigen::VectorXd floor;   ///< of the building's floor under the record times factor; empty: none
  };
  std::vector<std::string> configurations;
  groundmotions::Combination combination = groundmotions::Combination::kH1;
  std::string level;        ///< "PGA geomean = 0.4 g"
  Eigen::VectorXd periods;  ///< [s]
  std::vector<Record> records;
};

struct SuiteSpectraRequest {
  std::string job;                   ///< path of the job's file, as place_of_job()
  std::optional<std::size_t> level;  ///< index in Levels; none: the highest, of an IDA its first
  std::vector<std::size_t> configurations = {};  ///< whose motions; empty: all
  int periods = 90;
};

/// The records are read again. Components are combined as the study's measure combines them, else
/// by their geometric mean, or the only one is taken.
/// @throws Error where a record cannot be read, or is not the one that the study read
std::vector<SuiteSpectra> suite_spectra(const StudyData& data, const SuiteSpectraRequest& request);

/// Response spectra (5 % damping) of the floor's motion as a run has it.
struct FloorSpectra {
  Eigen::VectorXd periods;                                       ///< [s]
  std::vector<std::pair<std::string, Eigen::VectorXd>> of_axis;  ///< "x", [m/s2]
};

/// From `/histories/floor_acceleration`, for periods of at least 10 of its steps, below which too
/// little of the motion is left. Axes at rest are left out.
/// @return nothing where the file does not have it, or where the floor rests
std::optional<FloorSpectra> floor_spectra(const StoredHistories& histories);

}  // namespace gurney::study
