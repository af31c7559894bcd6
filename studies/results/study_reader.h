#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "studies/results/hdf5_reader.h"

namespace gurney::study {

/// Version of the layout of study files (docs/formats/study_file.md). It rises where a column
/// changes its meaning; one that is new or absent changes nothing.
inline constexpr int kStudyFormatVersion = 2;

/// The tables of a study file, column by column.
class StudyReader {
 public:
  /// @throws Error unless it is a results file of a study, of this version or an earlier one, whose
  /// columns are as long as their tables and whose indices lead to rows that exist.
  explicit StudyReader(const std::string& path);

  const std::string& path() const { return path_; }
  std::string text_attribute(const std::string& name) const { return file_.text_attribute(name); }
  std::string job_text() const { return text_attribute("job_text"); }

  bool has(const std::string& table) const;
  bool has_column(const std::string& column) const { return columns_.contains(column); }
  std::vector<std::string> columns_of(const std::string& table) const;  ///< in order of their names

  /// A column, such as "items/peak_displacement". runs/analysis_case was called runs/unit before
  /// 2026-11-22.
  /// @throws Error where there is none; it names the program that wrote the file
  std::vector<double> numbers(const std::string& column) const;
  std::vector<std::string> strings(const std::string& column) const;

  /// Demands of items and of marked points that this program computes and the file does not have,
  /// such as "peak_yaw"; of a point "point: peak_displacement". Each is missing, not 0.
  std::vector<std::string> missing_demands() const;

  std::size_t runs() const { return runs_; }

  /// For each run the rows of a table that are its own: first and one past the last.
  std::vector<std::pair<std::size_t, std::size_t>> rows_of_runs(const std::string& table) const;

 private:
  std::string path_;
  Hdf5Reader file_;
  void check_tables();
  void require_column(const std::string& column) const;
  void check_demand(const std::string& column, const std::vector<double>& values) const;
  void check_indices() const;
  void check_order(const std::string& table) const;
  void check_items() const;
  void check_record_sets() const;

  std::map<std::string, std::uint64_t> rows_;  ///< of each table
  std::set<std::string> columns_;              ///< such as "items/peak_displacement"
  std::size_t runs_ = 0;
};

}  // namespace gurney::study
