#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/config/range.h"
#include "studies/calibration/trials/csv_text.h"
#include "studies/calibration/trials/trial.h"

namespace gurney::calibration {

/// Facts of a trial by key, from `# key = value` lines and, in a table of averages, from
/// the cells of its row. Errors are noted; the results are for use only without any.
class Facts {
 public:
  /// @param at  the place for keys that are missing
  Facts(CsvErrors& errors, TextCell at) : errors_(&errors), at_(std::move(at)) {}

  void add(const std::string& key, const TextCell& value);

  /// `fallback` empty: the key must be there.
  std::string text(const std::string& key, std::optional<std::string> fallback = {});
  double number(const std::string& key, const config::Range& range,
                std::optional<double> fallback = {});
  std::size_t choice(const std::string& key, const std::vector<std::string>& allowed);

  /// Numbers apart by blanks; empty if the key is not there.
  std::vector<double> numbers(const std::string& key, const config::Range& range);

  bool has(const std::string& key) const { return values_.contains(key); }
  const TextCell& at(const std::string& key) const;  ///< the value's place, else the trial's
  CsvErrors& errors() { return *errors_; }

  /// Every key asked for so far.
  std::vector<std::string> asked() const { return {asked_.begin(), asked_.end()}; }

 private:
  const TextCell* find(const std::string& key, bool needed);
  void note_outside(const TextCell& cell, const std::string& key, const config::Range& range,
                    const std::string& text, double value);

  CsvErrors* errors_;
  TextCell at_;
  std::map<std::string, TextCell> values_;
  std::set<std::string> asked_;
};

/// Message for a cell that is no number.
std::string not_a_number(const std::string& key, const std::string& text);

/// Names of files, in the order of their enumerators.
const std::vector<std::string>& names_of_kinds();
const std::vector<std::string>& names_of_locked();
const std::vector<std::string>& names_of_uses();
const std::vector<std::string>& names_of_origins();

/// Reads the keys of docs/formats/trial_file.md. Which must be there depends on the kind.
TrialSetup read_setup(Facts& facts, TrialKind kind);

}  // namespace gurney::calibration
