#pragma once

#include <string>
#include <utility>
#include <vector>

#include "groundmotions/record.h"

namespace gurney {

/// A record and what is known of it besides its files.
struct DescribedRecord {
  const Record* record = nullptr;
  std::vector<std::pair<std::string, std::string>> facts;  ///< of the suite it comes from
};

/// Everything about one record: files, samples, header, processing, intensity measures of the
/// components and of RotD50, what is left at the end, warnings. In 100 columns.
std::string record_report(const DescribedRecord& described);

/// One line for each record, and the line above them.
std::string record_table_head();
std::string record_table_line(const Record& record);

/// What looks wrong: warnings of reading, of amplitudes, of what is left at the end.
std::vector<std::string> record_findings(const Record& record);

/// A JSON object; numbers in SI units, keys with units. Without its last line end.
std::string record_json(const DescribedRecord& described);

}  // namespace gurney
