#pragma once

#include <string>
#include <vector>

#include "groundmotions/record/record.h"

namespace gurney::cli {

/// What a record came from and what was done to it, as comments of a CSV file.
std::vector<std::string> record_comments(const groundmotions::Record& record);

/// The text of a record in Gurney's CSV, with its comments.
std::string record_csv(const groundmotions::Record& record);

/// The name of a record, without what cannot stand in the name of a file.
std::string file_name(std::string record_name);

/// @throws Error if `path` is a file that the record was read from.
void refuse_input_as_output(const std::string& path, const groundmotions::Record& record);

/// Writes one file whole or not at all, and prints its name unless `quiet`. @throws Error as
/// OutputFiles does.
void write_output(const std::string& path, const std::string& text, bool overwrite,
                  bool quiet = false);

}  // namespace gurney::cli
