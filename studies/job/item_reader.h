#pragma once

#include "engine/config/table.h"
#include "engine/scene/loads.h"
#include "equipment/catalogue/load_item.h"
#include "equipment/catalogue/uncertain.h"
#include "studies/job/remarks.h"

namespace gurney::study {

/// Which item, what is changed on it, where it stands.
struct JobItem {
  InitialMotion initial;  ///< position and yaw
  equipment::ItemDescription description;
  equipment::ItemOptions options;
};

/// A table [item] or [[item]] of a job. Errors are noted in the document; then the description
/// and options are not for use.
/// @param remarks  on options that reach no caster, or not all
equipment::Uncertain<JobItem> read_job_item(config::Table& item, Remarks& remarks);

}  // namespace gurney::study
