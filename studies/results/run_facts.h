#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/floor_motion.h"
#include "engine/base/random/draw.h"
#include "engine/run/run.h"
#include "engine/scene/scene.h"

namespace gurney::study {

/// A file a run was made from: its name without folder, and the SHA-256 of its bytes.
struct FileFacts {
  std::string name;
  std::string sha256;
};

/// Facts of a run's floor motion, in floor axes.
struct RecordFacts {
  std::string name;
  std::vector<FileFacts> files;
  std::vector<std::string> components;              ///< "h1: '318' of A318.AT2, azimuth 318 deg"
  std::vector<std::string> processing;              ///< what was done to the samples, step by step
  double duration = 0;                              ///< [s]
  double time_step = 0;                             ///< [s]
  Vector3 pga = Vector3::Zero();                    ///< largest |acceleration| [m/s2]
  Vector3 pgv = Vector3::Zero();                    ///< largest |velocity| [m/s]
  Vector3 pgd = Vector3::Zero();                    ///< largest |displacement| [m]
  Vector3 residual_velocity = Vector3::Zero();      ///< at the end of the record [m/s]
  Vector3 residual_displacement = Vector3::Zero();  ///< at the end of the record [m]
};

/// A number that has no source, and how far it may be off.
struct AssumptionFacts {
  std::string key;    ///< such as "tread.rolling_resistance_m"
  std::string value;  ///< as used, with its unit
  std::string range;  ///< such as "0.0005 to 0.0015"
  std::string reason;
  std::string file;  ///< data file that states it, without folder
};

/// A parameter that was drawn from its distribution.
struct DrawnFacts {
  std::string variable;  ///< its key, with the part before it: "front left/tread.patch_width_mm"
  double value = 0;      ///< in `unit`
  std::string unit;
  std::string distribution;
  std::string file;  ///< data file that states it, without folder
};

/// Everything a results file, a summary or a figure states besides the Response.
struct RunFacts {
  std::string job_name;  ///< of the job file, without folder and extension
  std::string job_text;
  std::string job_sha256;
  std::string title;
  Scene scene;
  RunOptions settings;
  std::optional<RecordFacts> record;  ///< none: the floor is at rest
  FloorMotion floor;
  std::optional<std::uint64_t> seed;  ///< none: nothing in the run is random
  std::optional<Draw> draw;           ///< none: every parameter has its value
  std::vector<DrawnFacts> drawn;
  std::vector<AssumptionFacts> assumptions;
  std::vector<std::string> warnings;
};

}  // namespace gurney::study
