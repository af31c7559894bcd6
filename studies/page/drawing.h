#pragma once

#include <string>

#include "studies/page/html.h"

namespace gurney::page {

/// A figure of the page.
struct Drawing {
  std::string name;  ///< unique on the page, of letters and dashes: also that of its file
  std::string svg;   ///< as studies/report draws it
  std::string caption;
  std::string description;  ///< for those who do not see it
};

/// The SVG as part of the page, with a link that saves it.
Html html(const Drawing& drawing);

}  // namespace gurney::page
