#pragma once

#include <string>
#include <vector>

#include "studies/analysis/study_data.h"

namespace gurney::study {

/// One configuration of a study file.
struct ConfigurationView {
  const StudyData* data = nullptr;
  std::size_t configuration = 0;

  const std::vector<std::size_t>& runs() const { return data->runs_of(configuration); }
  const std::string& configuration_name() const { return data->configurations()[configuration]; }
};

/// The configurations that a text names: one, or several apart by commas. Names may hold commas
/// themselves (the levels of several factors). Empty: none.
/// @throws Error with the nearest name
std::vector<std::size_t> named_configurations(const StudyData& data, const std::string& text);

/// Configurations that several texts name; all of the file where there are none.
std::vector<std::size_t> wanted_configurations(const StudyData& data,
                                               const std::vector<std::string>& texts);

/// The intensity measures that some run of the file has; a record of one component has no geometric
/// mean, for example.
std::vector<RunMeasure> known_measures(const StudyData& data);

/// The levels of a study that occur in its file, increasing: values of its measure [SI], or factors
/// on the records where it has none.
class Levels {
 public:
  explicit Levels(const StudyData& data);

  const std::vector<double>& values() const { return values_; }
  std::size_t of_run(std::size_t run) const { return of_run_[run]; }
  std::string name_of(std::size_t level) const;  ///< "PGA geomean = 0.4 g", "scale = 1"

 private:
  std::string measure_;
  ReportUnit unit_;
  std::vector<double> values_;
  std::vector<std::size_t> of_run_;
};

/// Rows of /records that a configuration's runs have, by the index of the record; none without
/// runs.
std::vector<std::size_t> record_rows(const ConfigurationView& side);

/// The records of a configuration by names that distinguish them: the second "b" is "b (2)".
std::vector<std::string> record_names(const ConfigurationView& side);

}  // namespace gurney::study
