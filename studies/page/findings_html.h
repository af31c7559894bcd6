#pragma once

#include <string>
#include <vector>

#include "studies/findings/findings.h"
#include "studies/page/document.h"

namespace gurney::page {

/// Findings as HTML; what has no label is left out, and a table without rows. A click on the title
/// of a column sorts; the first column names the rows. Numbers are kept as they are, in SI.
Html html(const findings::Section& section);
Html html(const findings::Table& table);

/// Cautions in a box, the rest of many folded away.
Html caution_box(const findings::Texts& cautions);

/// A part of a page for each section with a title within one.
/// @param ids  of them
std::vector<Section> sections_of(const findings::Section& findings, const findings::Texts& ids);

}  // namespace gurney::page
