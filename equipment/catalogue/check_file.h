#pragma once

#include <string>
#include <vector>

#include "engine/config/document.h"
#include "equipment/catalogue/caster_type.h"
#include "equipment/catalogue/catalogue.h"

namespace gurney::equipment {

/// @throws Error where the file states the schema of another kind of file of ours: what it is, and
///         which command takes it. Any other schema is left to the reader.
/// @param wanted  such as `gurney-job/1`; empty: any that `gurney equipment check` takes
void refuse_other_kind(config::Document& document, const std::string& wanted);

/// Whether the file is one that check_data_file() takes: an item, a caster, a floor covering, a
/// room or a kind of tether.
/// @throws Error if it is missing or cannot be parsed
bool holds_equipment(const std::string& file);

/// Lists what is allowed but hardly meant: a chassis lighter or heavier than equipment can be, a
/// centre of mass outside its shape, a caster that swivels without trail.
std::vector<std::string> implausible(const EquipmentModel& item);

/// Likewise: a contact patch wider than its wheel, a wheel whose mass lies beyond its rim.
std::vector<std::string> implausible(const CasterType& caster);

/// A data file without errors.
struct CheckedFile {
  DataKind kind = DataKind::kItem;
  std::string name;                   ///< what the file calls it
  std::vector<std::string> warnings;  ///< of stability and plausibility
};

/// Reads an item (with all its variants), a caster or a floor covering, whichever `schema` says.
/// @throws Error with every error of the file.
CheckedFile check_data_file(const std::string& file);

}  // namespace gurney::equipment
