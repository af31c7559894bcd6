#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "groundmotions/formats/format.h"
#include "groundmotions/formats/fortran_fields.h"
#include "groundmotions/formats/source_file.h"
#include "groundmotions/record/acceleration_unit.h"
#include "groundmotions/record/record.h"

/// Statements of a file on itself, checked against the user's options and against its samples. TextLines
/// are counted from 1; line 0 is the file as a whole.
namespace gurney::groundmotions {

using TextLines = std::span<const std::string_view>;

/// The text behind a key of a header; line 0: there is no such line.
struct HeaderLine {
  std::string_view text;
  std::size_t line = 0;
};

/// Text behind the colon of the first line that starts with `key`, blanks before it apart. A key may
/// end with its colon.
HeaderLine find_line(TextLines lines, std::string_view key);

/// A number that a file states: `key` on `line`.
struct StatedNumber {
  double value = 0;
  std::string_view key;
  std::size_t line = 0;
};

/// The peak a header states: its size and by how much it may be rounded [m/s2]; its line.
struct StatedPeak {
  double size = 0;
  double rounding = 0;
  std::size_t line = 1;
};

/// A component of samples in a unit.
Component component_of(const Eigen::Ref<const Eigen::VectorXd>& samples,
                       const AccelerationUnit& unit, double time_step);
Component component_of(const std::vector<double>& samples, const AccelerationUnit& unit,
                       double time_step);

/// Lines, options and errors of the file that a layout is read from, and the checks that all layouts share.
struct LayoutReader {
  LayoutReader(const SourceFile& source, const ReadOptions& given);
  LayoutReader(const LayoutReader&) = delete;  // fields points to errors

  const SourceFile& file;
  const ReadOptions& options;
  TextLines
      header;  ///< where keys are looked for; all lines of a text unless the reader narrows it
  FileErrors errors;
  FieldReader fields;

  void error(std::size_t line, const std::string& message);
  /// Reports an error that makes all that follow needless. @throws Error
  void refuse(std::size_t line, const std::string& message);
  /// @throws Error if there are errors
  std::vector<Component> checked(std::vector<Component> components) const;

  HeaderLine find(std::string_view key) const { return find_line(header, key); }
  HeaderLine needed(std::string_view key);  ///< an error if it is not there
  /// An error and 0 if the text is no number, perhaps with `unit` behind it.
  double number_of(const HeaderLine& stated, std::string_view key, std::string_view unit = {});
  /// Puts the texts behind keys, where there are any, into the component's header.
  /// @param facts  name in the header, key in the file
  void state_facts(std::initializer_list<std::pair<const char*, const char*>> facts,
                   Component& component) const;

  /// The unit a file states, or else options.unit; an error if there is none or both differ.
  /// @param line  that states it or should
  AccelerationUnit agreed_unit(const std::optional<AccelerationUnit>& stated, std::size_t line);

  /// The unit that a file states; an error if it is no unit of acceleration or differs from
  /// options.unit.
  AccelerationUnit checked_unit(std::string_view stated, std::size_t line);

  /// The time step that a file states, or else options.time_step [s]; an error if there is none,
  /// both differ, or it is not is_time_step().
  /// @param line  that states it or should
  double agreed_time_step(const std::optional<double>& stated, std::size_t line);

  /// The time step that a file states [s]; an error unless it is_time_step() and agrees with
  /// options.time_step to 1e-6.
  double checked_time_step(const StatedNumber& stated);

  /// An error unless the file holds as many samples as it states, 2 at least.
  void check_count(const StatedNumber& stated, std::size_t held);

  /// An error for fewer samples than a record needs.
  void check_enough(double samples, std::size_t line);

  /// A warning if the component has not the length that `line` states; an error if it is not within
  /// a factor of 1.5.
  /// @param length  [s]; not above 0: not stated
  void check_length(double length, std::size_t line, Component& component);

  /// Compares the peak that a file states with that of its samples: a warning if they differ by
  /// more than half of the last digit of `stated` and 0.1 % (an assumption: samples have four
  /// digits), an error if by more than a factor of 1.5.
  /// @param unit  of `stated`
  void check_peak(const HeaderLine& stated, const AccelerationUnit& unit, Component& component);

  /// A warning if the samples, as they are or without their mean, have another peak; an error if
  /// theirs is not within a factor of 1.5.
  /// @param samples  as the file has them [m/s2]
  void check_peak(const StatedPeak& peak, const Eigen::VectorXd& samples, Component& component);

  /// The component of all numbers from line `first` (from 0) to the end of the file.
  /// @throws Error if there are errors, or not `count` samples
  Component read_to_end(std::size_t first, const AccelerationUnit& unit, double time_step,
                        const StatedNumber& count);
};

}  // namespace gurney::groundmotions
