#pragma once

#include <cstddef>
#include <functional>
#include <future>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/floor_motion.h"
#include "groundmotions/record/record.h"
#include "groundmotions/record/source_facts.h"
#include "groundmotions/suites/suite.h"
#include "studies/plan/study_job.h"
#include "studies/prepare/run_job.h"

namespace gurney::study {

/// Motions of a building's floor, and synthetic motions of the ground, each made once for all
/// configurations and draws under it. Those asked for last are kept, up to a number of bytes, so
/// that memory does not grow with the study.
class FloorRecords {
 public:
  using Shared = std::shared_ptr<const groundmotions::Record>;

  explicit FloorRecords(std::size_t bytes) : most_(bytes) {}

  /// A ground motion times `scale`; `set` is of the building and its floor.
  struct Key {
    std::size_t set = 0, record = 0;
    double scale = 1;
    bool operator==(const Key&) const = default;
  };

  /// The motion of the floor, by `make` unless it is kept. May be called from several threads:
  /// those that ask for the same motion wait for the one that makes it.
  /// @throws what `make` throws
  Shared of(const Key& key, const std::function<groundmotions::Record()>& make);

 private:
  struct Kept {
    Key key;
    std::shared_future<Shared> motion;
    std::size_t bytes = 0;  ///< 0: it is being made
  };

  void count(const Key& key, const groundmotions::Record& record);
  void forget(const Key& key);

  std::mutex mutex_;
  std::list<Kept> kept_;  ///< that asked for last is the first
  std::size_t bytes_ = 0, most_;
};

/// Facts of a ground motion as read and processed, at scale 1, without its samples.
struct GroundMotion {
  std::string files;  ///< SHA-256 and name of each of its files, one a line
  std::vector<std::string> processing;
  double duration = 0;           ///< [s]; 0: the floor rests
  double intensity = 0;          ///< the measure that levels are stated in [SI]
  std::vector<double> measures;  ///< as Study::measures [SI]; NaN: the record has none
  std::vector<std::string> record_warnings;
  std::vector<std::string> warnings;  ///< those of the record and of its plausibility
  groundmotions::SourceFacts source;
};

constexpr std::size_t kStepsOfIda = 4;  ///< steps of an IDA whose values are known before it runs

/// The records of all configurations that shake alike.
class MotionSet {
 public:
  /// @param floors  for the motions of floors, those of set `index` among them
  /// @throws Error for a suite without records, or with files that are none
  MotionSet(const Job& job, const Study& study, FloorRecords& floors, std::size_t index);

  std::size_t size() const { return names_.size(); }
  const std::string& name(std::size_t record) const { return names_[record]; }

  /// Read at the first call; may be called from several threads.
  /// @throws Error as motion_of() does, and for an intensity that is zero
  const GroundMotion& ground(std::size_t record) const;

  /// The motion itself; no components: the floor rests. Recorded motions stay in memory. Synthetic
  /// ones, of which a study may have a million, are made again where they are not among those asked
  /// for last.
  FloorRecords::Shared ground_record(std::size_t record) const;

  /// Values of the study's measure, or factors, at which a record is run in the first stage: all
  /// levels of the plan, or of a suite by level the one it belongs to. For an IDA they are those of
  /// its first kStepsOfIda steps.
  std::vector<double> levels(std::size_t record) const;

  /// Factor that the job or its list states of a record; the study scales the product.
  double stated_scale(std::size_t record) const;

  /// Factor on the ground motion that gives a value of the study's measure.
  double scale_for(std::size_t record, double value) const;

  /// Motion under the items from the record times `scale`, before it is turned: that of
  /// the building's floor, or of the ground where there is no building.
  FloorRecords::Shared floor_record(std::size_t record, double scale) const;
  bool has_building() const { return request_ && request_->building; }

  /// Motion of the floor under the record times `scale`.
  /// @param warnings  gets those of the building, such as of isolators beyond their capacity
  FloorMotion floor(std::size_t record, double scale, double angle,
                    std::vector<std::string>& warnings) const;

  /// Adds the facts that are reported of it; none where the floor rests.
  std::optional<Motion> motion(std::size_t record, double scale, double angle) const;

 private:
  void read_suites();
  groundmotions::Record read(std::size_t record) const;
  GroundMotion facts_of(std::size_t record, const groundmotions::Record& motion) const;
  /// Files of floor motions from another program.
  /// @throws Error where a record has none, or cannot be scaled as the study does
  void add_tables(const groundmotions::Record& motion, GroundMotion& facts) const;
  groundmotions::SourceFacts source_of(const groundmotions::Record& record,
                                       std::size_t index) const;
  bool is_synthetic() const { return request_ && request_->synthetic; }
  bool scaled_by_measure() const { return intensity_.kind != IntensityPlan::Kind::kScales; }

  std::optional<RecordRequest> request_;
  std::vector<groundmotions::SuiteRecord> suite_;
  std::vector<std::size_t> level_of_;  ///< of each record of suites by level; empty: all have all
  std::vector<std::string> notes_;     ///< of the suite; warnings of its first record
  IntensityPlan intensity_;
  std::vector<KeptMeasure> kept_;
  std::vector<std::string> names_;
  struct Slot {
    std::once_flag once;
    GroundMotion motion;
    FloorRecords::Shared record;  ///< none of synthetic motions
  };
  std::unique_ptr<Slot[]> slots_;
  FloorRecords& floors_;
  std::size_t index_;
};

/// The motions of a study. Configurations whose excitation is the same share them.
class StudyMotions {
 public:
  explicit StudyMotions(const StudyJob& job);

  std::size_t sets() const { return sets_.size(); }
  const MotionSet& set(std::size_t index) const { return *sets_[index]; }
  std::size_t index_of(std::size_t configuration) const { return of_configuration_[configuration]; }
  const MotionSet& set_of(std::size_t configuration) const {
    return *sets_[of_configuration_[configuration]];
  }

  /// Reads every record, with several threads.
  /// @throws Error with the errors of all
  void read_all(int threads) const;

 private:
  std::unique_ptr<FloorRecords> floors_;
  std::vector<std::unique_ptr<MotionSet>> sets_;
  std::vector<std::size_t> of_configuration_;
};

}  // namespace gurney::study
