#pragma once

#include <map>
#include <string>
#include <vector>

#include "studies/limit_states/limit_state.h"
#include "studies/results/study_reader.h"

namespace gurney::study {

/// The table of a study file that holds what a quantity is of: "items".
std::string table_of(Quantity::Of of);

/// The values of the runs of a study file; columns are read when they are first asked for.
class FileValues {
 public:
  explicit FileValues(const StudyReader& file) : file_(file) {}

  /// Of one run, as values_of() has them when the run is made.
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

}  // namespace gurney::study
