#pragma once

#include <string>

#include "groundmotions/record/record.h"

namespace gurney::groundmotions {

/// The name of a component's file without the name of the component: "RSN1063_NORTHR_RRS228.AT2"
/// of component "228" is "RSN1063_NORTHR_RRS*.AT2". At the end of a name without its extension
/// three digits and the words for up and down may touch what is before them: "C05085" of "085" is
/// "C05*". Empty if the component's name is not in it.
std::string name_without_component(const std::string& file_name, const std::string& component);

/// The same for the first spelling of the component that is in the name: as the file calls it, its
/// azimuth in three digits (360 for 0 too), or the words for a vertical.
std::string name_pattern(const std::string& file_name, const Component& component);

/// The name of a record whose files are named by a pattern: "RSN1063_NORTHR_RRS".
std::string name_of_pattern(std::string pattern);

}  // namespace gurney::groundmotions
