#pragma once

#include <string>

#include "studies/page/html.h"

namespace gurney::page {

/// A figure of the page.
struct Drawing {
  std::string name;  ///< unique on the page, of letters and dashes: also that of its file
  std::string svg;   ///< as studies/figures draws it; of several pictures each becomes a figure
  std::string caption;
  std::string description;  ///< for those who do not see it
};

/// The SVG as part of the page, with a link that saves it.
Html html(const Drawing& drawing);

/// Figures in columns, as many as there is room for.
Html side_by_side(const Html& figures);

}  // namespace gurney::page
