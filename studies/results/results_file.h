#pragma once

#include <string>

#include "engine/response/response.h"
#include "studies/results/hdf5_writer.h"
#include "studies/results/run_facts.h"

namespace gurney::study {

/// Version of the layout in docs/formats/results_file.md. It grows when a reader could break.
inline constexpr int kResultsFormatVersion = 2;

/// The bytes of a results file of one run, laid out as docs/formats/results_file.md says. The same
/// run gives the same bytes: no date, machine or folder is in them.
std::string results_image(const RunFacts& facts, const Response& response);

/// Writes type of file and program as attributes.
void add_program(Hdf5Writer& file, const std::string& filetype, int format_version);

}  // namespace gurney::study
