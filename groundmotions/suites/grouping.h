#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "groundmotions/record/record.h"
#include "groundmotions/suites/suite.h"

namespace gurney::groundmotions {

/// A component of a file as far as it matters to its neighbours.
struct FoundComponent {
  std::filesystem::path path;
  std::optional<int> channel = {};  ///< from 1; none: the only component of its file
  std::string name;                 ///< of the component
  std::string pattern;              ///< name_pattern() of the file's name; may be empty
  std::string content;              ///< event and station, in plain_words(); may be empty
  std::string site;                 ///< site_of()
  std::string place;                ///< location or sensor as the file writes it; may be empty
  bool vertical = false;
  bool lacks_direction = false;           ///< only the file's name may say it
  std::optional<double> azimuth = {};     ///< [rad]
  std::optional<double> start_time = {};  ///< [s since 1970]
  double duration = 0;                    ///< [s]
  double time_step = 0;                   ///< [s]
  Eigen::Index samples = 0;
  ReadOptions options = {};
};

/// @param channel  of several in the file, from 1
FoundComponent found_component(const std::filesystem::path& path, const Component& component,
                               std::optional<int> channel, const ReadOptions& options);

/// The components of one file as records: one for each site, all channels in one if there is one
/// site. A site whose channels cannot be one record (two verticals, three horizontals, two that are
/// parallel) gives a record for each of its channels, if they say their directions or their site;
/// else they stay together, to be refused with what there is.
std::vector<SuiteRecord> records_of_file(const std::vector<FoundComponent>& channels);

/// Files of one component as records, of different names. Components belong together if folder and
/// site are the same and
/// - their files are named alike but for the component (file_names.h where only the name says it), or
/// - event and station are the same and together they can be one record: one vertical and two
///   horizontals at most, none parallel, that start together. Where there are more than that, those
///   whose names are most alike.
/// @param doubts  files that may belong together and are not joined
std::vector<SuiteRecord> records_of_components(std::vector<FoundComponent> components,
                                               std::vector<std::string>& doubts);

/// The name of a component's file without the name of the component: "RSN1063_NORTHR_RRS228.AT2"
/// of component "228" is "RSN1063_NORTHR_RRS*.AT2". At the end of a name without its extension
/// three digits and the words for up and down may touch what is before them: "C05085" of "085" is
/// "C05*". Empty if the component's name is not in it.
std::string name_without_component(const std::string& file_name, const std::string& component);

/// Pattern by the first spelling of the component that is in the name: as the file calls it, its
/// azimuth in three digits (360 for 0 too), or the words for a vertical.
std::string name_pattern(const std::string& file_name, const Component& component);

/// The name of a record whose files are named by a pattern: "RSN1063_NORTHR_RRS".
std::string name_of_pattern(std::string pattern);

}  // namespace gurney::groundmotions
