#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/config/document.h"
#include "engine/scene/scene.h"
#include "engine/scene/settings.h"
#include "equipment/assumption.h"

namespace gurney {

/// The ground or floor motion a job asks for; the record room reads it.
struct RecordRequest {
  /// Files by the direction they drive, empty where there is none; or one `file` with columns.
  std::string x, y, z, file;
  bool use_x = true, use_y = true, use_z = true;  ///< components that act; the others stay at 0
  double scale = 1;                               ///< on every component, finite
  double angle = 0;   ///< record axes turned about z, anticlockwise from floor axes [rad]
  std::string units;  ///< of plain numbers: g, m/s2, cm/s2 or mm/s2; empty: not said
  std::optional<double> time_step;  ///< of plain numbers without a time column, > 0 [s]
  std::string where;                ///< `file:line:column` in the job, for messages
};

/// One run: what stands where, what acts on it, how it is solved (docs/formats/job_file.md).
struct Job {
  std::string file;
  std::string text;  ///< of the file, to be kept with the results
  std::string title;
  Scene scene;
  Excitation excitation;  ///< without the floor's motion
  SimulationSettings settings;
  std::optional<RecordRequest> record;
  std::vector<Assumption> assumptions;  ///< every unsourced number in use
  std::vector<std::string> warnings;
};

/// @throws Error with every mistake of the job, and of the data files it names.
Job read_job(const std::string& path);

/// The same from an open document, which it finishes.
Job read_job(config::Document& document);

}  // namespace gurney
