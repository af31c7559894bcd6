#pragma once

#include "studies/findings/findings.h"
#include "studies/page/html.h"

namespace gurney::page {

/// Tables that a click sorts, facts as a list, sentences as paragraphs: what has a label.
Html html(const findings::Section& section);
Html html(const findings::Table& table);

}  // namespace gurney::page
