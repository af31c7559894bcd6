#pragma once

#include <string>
#include <vector>

#include "studies/analysis/configuration_view.h"

namespace gurney::study {

/// An input that is not the same; empty: it is not there.
struct InputDifference {
  std::string key;  ///< "item.brakes", "study.draws"
  std::string a, b;
};

/// What two configurations were made from, as far as study files keep it.
struct InputDifferences {
  std::vector<InputDifference> job;          ///< with the levels of their factors put in
  std::vector<InputDifference> assumptions;  ///< numbers without a source, from data files
  std::vector<InputDifference> data_files;   ///< items, casters, rooms, ...: SHA-256
  std::vector<InputDifference> program;
  std::vector<std::string> records_of_a, records_of_b;  ///< of one only
  std::vector<std::string> records_changed;             ///< same name, other files or processing
  std::size_t records_common = 0;

  bool none() const;
};

InputDifferences input_differences(const ConfigurationView& a, const ConfigurationView& b);

}  // namespace gurney::study
