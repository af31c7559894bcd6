#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/random/draw.h"
#include "engine/config/document.h"
#include "engine/run/run.h"
#include "engine/scene/scene.h"
#include "equipment/catalogue/assumption.h"
#include "groundmotions/assembly/read_record.h"
#include "groundmotions/buildings/building.h"
#include "groundmotions/measures/combination.h"
#include "groundmotions/processing/step.h"
#include "groundmotions/scaling/scale.h"
#include "groundmotions/synthetic/kinds.h"

namespace gurney::equipment {
template <class T>
class Uncertain;
}  // namespace gurney::equipment

namespace gurney::study {

/// An intensity that a record is scaled to.
struct ScaleTo {
  groundmotions::Measure measure;
  groundmotions::Combination combination = groundmotions::Combination::kGeometricMean;
  double value = 0;  ///< > 0, in the measure's SI unit
  groundmotions::VerticalScaling vertical;
};

struct BuildingRequest {
  groundmotions::Building building;
  int floor = 0;
  Vector2 place = Vector2::Zero();  ///< of the item on a floor that twists [m]
  std::string file;                 ///< that describes it; empty: the job itself
};

/// The ground or floor motion a job asks for; motion.h makes it.
struct RecordRequest {
  std::vector<groundmotions::RecordFile> files;  ///< or `synthetic`, or, in a study, `suite`
  /// Folders, lists, files: each record in turn. By level: one path for each level of the study.
  std::vector<std::filesystem::path> suite;
  bool suite_by_level = false;
  groundmotions::ReadOptions options;
  std::optional<groundmotions::SyntheticRequest> synthetic;
  bool use_x = true, use_y = true, use_z = true;  ///< components that act; the others stay at 0
  bool use_stated = false;                        ///< only then may a file lack a component
  std::vector<groundmotions::ProcessingStep> processing;
  double scale = 1;                         ///< on every component, > 0
  std::optional<ScaleTo> scale_to;          ///< instead of `scale`
  std::optional<BuildingRequest> building;  ///< between the record and the floor
  double angle = 0;  ///< record axes turned about z, anticlockwise from floor axes [rad]
  bool refuse_implausible = false;  ///< what would be a warning ends the job
  std::string where;                ///< `file:line:column` in the job, for messages
};

/// One run: what stands where, what acts on it, how it is solved (docs/formats/job_file.md).
struct Job {
  std::string file;
  std::string text;  ///< of the file, to be kept with the results
  std::string title;
  Scene scene;  ///< the items of the job, then their parts and contents
  std::vector<std::size_t>
      owners;  ///< of each item of the scene: the item of the job it belongs to
  RunOptions settings;
  std::optional<RecordRequest> record;
  double rotation_factor = 1;  ///< on the rotation of the floor that the building gives
  std::optional<Draw> draw;    ///< of every uncertain number; none: as their values
  std::vector<equipment::Assumption> assumptions;  ///< every unsourced or drawn number in use
  std::vector<std::string> warnings;
  std::vector<std::string> without_effect;  ///< inputs: see Remarks
};

/// @throws Error with every error of the job, and of the data files it names.
Job read_job(const std::string& path);

/// Reads the job from an open document, which it finishes.
Job read_job(config::Document& document);

struct JobParts;

/// A job as it is read, once, with every number that may be drawn.
class JobModel {
 public:
  /// @throws Error as read_job, but inputs without effect are none: Job::without_effect has them.
  explicit JobModel(config::Document& document);

  const Job& stated() const;  ///< every number at its value

 private:
  friend Job sample(const JobModel& model, const std::optional<Draw>& draw, std::size_t replica);
  std::shared_ptr<const equipment::Uncertain<JobParts>> reading_;
};

/// The job in a draw; without one, every number at its value.
/// @param replica  number of replica_of(), for its scene
/// @throws Error where this draw makes a bad job, such as items that overlap
Job sample(const JobModel& model, const std::optional<Draw>& draw, std::size_t replica = 0);

/// Whether a number of a job that was read with a draw has a distribution.
bool draws_anything(const Job& job);

}  // namespace gurney::study
