#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "studies/analysis/assessment.h"
#include "studies/limit_states/limit_state.h"
#include "studies/plan/study.h"
#include "studies/results/study_reader.h"
#include "studies/statistics/cloud.h"
#include "studies/statistics/fragility.h"
#include "studies/units/unit_system.h"

namespace gurney::study {

/// The table of a study file that holds what a quantity is of: "items".
std::string table_of(Quantity::Of of);

/// The values of the runs of a study file; columns are read when they are first asked for.
class FileValues {
 public:
  explicit FileValues(const StudyReader& file) : file_(file) {}

  /// Values of one run, as values_of() has them when the run is made.
  /// @throws Error where the file does not keep the table or the column
  std::vector<double> operator()(std::size_t run, const Quantity& quantity);

  Values of_run(std::size_t run) {
    return [this, run](const Quantity& quantity) { return (*this)(run, quantity); };
  }

 private:
  using Rows = std::vector<std::pair<std::size_t, std::size_t>>;
  const Rows& rows(const std::string& table);
  const std::vector<double>& numbers(const std::string& column);
  const std::vector<std::string>& strings(const std::string& column);

  const StudyReader& file_;
  std::map<std::string, Rows> rows_;
  std::map<std::string, std::vector<double>> numbers_;
  std::map<std::string, std::vector<std::string>> strings_;
};

/// An intensity measure as a study file has it for each run.
struct RunMeasure {
  std::string name;   ///< "PGA geomean", "pfv"
  std::string units;  ///< SI
  std::vector<double> values;
};

/// A study file with what its job states of it, for statistics. Failed runs are never counted.
class StudyData {
 public:
  /// @param records  names of those whose runs count; empty: all
  /// @throws Error unless it is the results file of a study that can be assessed so
  explicit StudyData(const std::string& path, const AssessmentRequest& request = {},
                     const std::vector<std::string>& records = {}, const UnitSystem& units = {});

  const StudyReader& file() const { return *file_; }
  const Study& study() const { return study_; }
  const UnitSystem& units() const { return units_; }  ///< to print and draw in

  const std::vector<LimitState>& limit_states() const { return assessment_.limit_states; }
  const std::vector<std::size_t>& performance() const { return assessment_.performance; }

  /// Whether the study is an IDA: it chose the intensities of a record by its response.
  bool is_ida() const { return study_.intensity.kind == IntensityPlan::Kind::kIda; }

  /// Whether the study is an IDA that gives capacities in the measure: in every analysis case of the
  /// configuration it grows with the study's own, as all do that are scaled with the record. A
  /// duration is not.
  bool traces(std::size_t configuration, const RunMeasure& measure) const;

  /// Analysis cases of an IDA that exceed the limit state that ends it, so that it made no runs
  /// above. All cases where the file does not have what the state asks for.
  std::set<std::size_t> ended_cases(std::size_t configuration) const;

  /// The hazard over a measure; none where there is none, or where the job's is over another.
  /// @throws Error where a file states it over another
  const statistics::HazardCurve* hazard_over(const RunMeasure& measure) const;

  /// The measure of a hazard over another one, from which no rate follows; empty: there is none.
  std::string other_hazard(const RunMeasure& measure) const;

  const std::vector<std::string>& configurations() const { return configurations_; }

  /// Runs of a configuration that did not fail, in order.
  const std::vector<std::size_t>& runs_of(std::size_t configuration) const {
    return runs_[configuration];
  }
  std::size_t failed(std::size_t configuration) const { return failed_[configuration]; }

  std::size_t record_of(std::size_t run) const { return record_[run]; }

  /// Row of /records of a run's record; record_of() counts within the set of its configuration.
  std::size_t row_of(std::size_t run) const { return row_[run]; }

  /// Factors of all runs on the records as they were recorded: that of the study times that of the
  /// job or its list, which files of earlier programs do not state.
  std::vector<double> factors_on_records() const;

  /// Whether each of several levels has a suite of its own: a record has runs at one level only.
  bool has_suites_by_level() const { return suites_by_level_; }

  /// Names of what measure() takes: the study's own measure first.
  std::vector<std::string> measures() const;

  /// @param name  of measures(); empty: the study's own
  /// @throws Error with the nearest name
  RunMeasure measure(const std::string& name) const;

  /// For each of the runs: does it exceed the state?
  std::vector<bool> exceedances(std::size_t state, const std::vector<std::size_t>& runs) const;

  /// One observation for each run of a configuration. The group is the record; those of several
  /// levels that are of the same files are one.
  std::vector<statistics::Observation> observations(std::size_t state, std::size_t configuration,
                                                    const RunMeasure& measure) const;

  /// Observations of runs whose outcomes are stated, in a map by their number.
  /// @throws Error for a run that the file lacks
  std::vector<statistics::Observation> observations(const std::map<std::size_t, bool>& exceeded,
                                                    std::size_t configuration,
                                                    const RunMeasure& measure) const;

  /// Runs whose item overturned before it had gone as far as a limit of length: they do not exceed it. 0 for
  /// other states.
  std::size_t overturned_short_of(std::size_t state, std::size_t configuration) const;

  /// The demand of a simple state above a limit, run by run: the largest over its items. Runs that
  /// overturned are at least at the limit or at their demand, whichever is more; runs that moved
  /// less than `floor` are at most there.
  /// @throws Error for other kinds of states, and for events, which have no size
  std::vector<statistics::CloudPoint> cloud(std::size_t state, std::size_t configuration,
                                            const RunMeasure& measure, double floor) const;

 private:
  bool each_record_has_one_of_several_levels() const;
  void join_same_files();

  std::unique_ptr<StudyReader> file_;
  mutable FileValues values_;
  Study study_;
  UnitSystem units_;
  Assessment assessment_;
  std::vector<std::string> configurations_;
  std::vector<std::vector<std::size_t>> runs_;
  std::vector<std::size_t> failed_, record_, row_;
  bool suites_by_level_ = false;
  std::vector<std::size_t> group_;  ///< of each run: its record, or the first of the same files
};

/// Unit of an intensity: the chosen one, else that in which the study states its levels where it is
/// their measure, else that of the job's units for all.
ReportUnit report_unit(const StudyData& data, const RunMeasure& measure);

/// Unit of an intensity that a user states: report_unit() without a chosen one.
ReportUnit unit_of_levels(const StudyData& data, const RunMeasure& measure);

/// Where the job that a results file keeps is read again, for messages and relative names: the path
/// of its file, or a name beside the results where that is empty.
std::string place_of_job(const std::string& job, const std::string& results);

}  // namespace gurney::study
