#include "studies/run/complete_study.h"

#include "studies/results/study_reader.h"
#include "studies/run/study_identity.h"

namespace gurney::study {
namespace {

std::string inputs_in(const StudyReader& file) {
  std::string lines;
  const auto sets = file.strings("records/set"), records = file.strings("records/name"),
             of_record = file.strings("records/files");
  for (std::size_t row = 0; row < records.size(); ++row)
    lines += record_line(sets.at(row), records[row], of_record.at(row));
  const auto names = file.strings("data_files/name"), hashes = file.strings("data_files/sha256");
  for (std::size_t row = 0; row < names.size(); ++row)
    lines += data_file_line(names[row], hashes.at(row));
  return inputs_from(lines, file.job_text());
}

}  // namespace

std::string difference_to_results(const std::string& path, const Batch& batch) {
  const std::string theirs = inputs_in(StudyReader(path)), ours = inputs_of(batch);
  return theirs == ours ? std::string() : difference(theirs, ours);
}

}  // namespace gurney::study
