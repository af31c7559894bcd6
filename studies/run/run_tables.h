#pragma once

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "studies/results/growing_table.h"
#include "studies/run/run_task.h"

namespace gurney::study {

/// The names that the runs of one configuration have in common.
struct ConfigurationNames {
  std::vector<std::string> items, zones, tethers, shapes;
  std::vector<std::vector<std::string>> wheels, points;  ///< of each item
  std::vector<std::string> variables;                    ///< that are drawn
};

std::vector<ConfigurationNames> names_of(const Batch& batch);

/// The tables of a study's file that have rows for each run.
class RunTables {
 public:
  RunTables(Hdf5Writer& file, const Batch& batch);

  void add(const TaskResult& result);
  void finish();

 private:
  void add_run(const TaskResult& result, const Task& task, const StudyRun& run);
  void add_items(const StudyRun& run, const ConfigurationNames& names);
  void add_points(const std::string& to, std::size_t item, const Demands& demands,
                  const ConfigurationNames& names);
  void add_events(const StudyRun& run, const ConfigurationNames& names);
  void add_histories(const StudyRun& run, const ConfigurationNames& names);
  std::int64_t motion_of(const Task& task, double scale);
  GrowingTable& table(const std::string& name) { return *tables_.at(name); }
  GrowingTable& make(const std::string& name);

  Hdf5Writer& file_;
  const Batch& batch_;
  std::vector<ConfigurationNames> names_;
  std::map<std::string, std::unique_ptr<GrowingTable>> tables_;
  std::map<std::tuple<std::size_t, std::size_t, double>, std::int64_t> motions_;
  std::int64_t runs_ = 0;
};

}  // namespace gurney::study
