#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

#include "groundmotions/formats/format.h"
#include "groundmotions/formats/fortran_fields.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/record/acceleration_unit.h"
#include "groundmotions/record/record.h"

/// Statements of a file on itself, checked against the user's options and against its samples. Lines
/// are counted from 1.
namespace gurney::groundmotions {

/// The unit a file states, or else options.unit; an error if there is none or both differ.
/// @param line  that states it or should; 0: no line in particular
AccelerationUnit agreed_unit(const std::optional<AccelerationUnit>& stated, std::size_t line,
                             const ReadOptions& options, FileErrors& errors);

/// The unit that a file states on `line`; an error if it is no unit of acceleration or differs
/// from options.unit.
AccelerationUnit checked_unit(std::string_view stated, std::size_t line, const ReadOptions& options,
                              FileErrors& errors);

/// The time step that a file states, or else options.time_step [s]; an error if there is none,
/// both differ, or it is not is_time_step().
/// @param line  that states it or should; 0: no line in particular
double agreed_time_step(const std::optional<double>& stated, std::size_t line,
                        const ReadOptions& options, FileErrors& errors);

/// The time step that a file states as `key` on `line` [s]; an error unless it is_time_step() and
/// agrees with options.time_step to 1e-6.
double checked_time_step(double stated, std::string_view key, std::size_t line,
                         const ReadOptions& options, FileErrors& errors);

/// An error unless the file holds as many samples as it states as `key` on `line`, 2 at least.
void check_count(double stated, std::string_view key, std::size_t line, std::size_t held,
                 FileErrors& errors);

/// An error of a line (0: of the file) for fewer samples than a record needs.
void check_enough(double samples, std::size_t line, FileErrors& errors);

/// A warning if the component has not the length that `line` states; an error if it is not within
/// a factor of 1.5.
/// @param length  [s]; not above 0: not stated
void check_length(double length, std::size_t line, Component& component, FileErrors& errors);

/// Compares the peak that a file states with that of its samples: a warning if they differ by more
/// than half of the last digit of `stated` and 0.1 % (an assumption: samples have four digits), a
/// error if by more than a factor of 1.5.
/// @param unit  of `stated`
void check_peak(std::string_view stated, const AccelerationUnit& unit, std::size_t line,
                Component& component, FileErrors& errors);

/// The peak a header states: its size and by how much it may be rounded [m/s2]; its line.
struct StatedPeak {
  double size = 0;
  double rounding = 0;
  std::size_t line = 1;
};

/// A warning if the samples, as they are or without their mean, have another peak; an error if
/// theirs is not within a factor of 1.5.
/// @param samples  as the file has them [m/s2]
void check_peak(const StatedPeak& peak, const Eigen::VectorXd& samples, Component& component,
                FileErrors& errors);

/// Base of the readers of layouts with a header and samples: what all have at hand, and the checks of
/// their statements.
class LayoutReader {
 public:
  LayoutReader(const SourceFile& file, const ReadOptions& options, FileErrors& errors)
      : file_(file), options_(options), errors_(errors), fields_(file, errors) {}

 protected:
  AccelerationUnit agreed_unit(const std::optional<AccelerationUnit>& stated,
                               std::size_t line) const {
    return groundmotions::agreed_unit(stated, line, options_, errors_);
  }
  double agreed_time_step(const std::optional<double>& stated, std::size_t line) const {
    return groundmotions::agreed_time_step(stated, line, options_, errors_);
  }
  void check_length(double length, std::size_t line, Component& component) const {
    groundmotions::check_length(length, line, component, errors_);
  }
  void check_peak(const StatedPeak& peak, Component& component) const {
    groundmotions::check_peak(peak, component.acceleration, component, errors_);
  }

  /// Text behind the colon of a line that must be there.
  std::string_view value(std::string_view key, std::size_t& line) const {
    return needed_behind(file_.lines(), key, line, errors_);
  }

  /// Puts the texts behind keys, where there are any, into the component's header.
  /// @param facts  name in the header, key in the file
  void state_facts(std::initializer_list<std::pair<const char*, const char*>> facts,
                   Component& component) const;

  const SourceFile& file_;
  const ReadOptions& options_;
  FileErrors& errors_;
  FieldReader fields_;
};

}  // namespace gurney::groundmotions
