#pragma once

#include "studies/page/document.h"
#include "studies/page/page.h"

namespace gurney::page {

/// The page of the results file of one run.
Document run_document(const PageRequest& request);

}  // namespace gurney::page
