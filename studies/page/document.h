#pragma once

#include <string>
#include <vector>

#include "studies/page/html.h"

namespace gurney::page {

/// A part of the page with a heading, which the table of contents leads to.
struct Section {
  std::string id;  ///< of letters and dashes
  std::string title;
  Html content;
};

struct Document {
  std::string title;
  std::string subtitle;
  std::vector<Section> sections;  ///< those without content are left out
  std::string program;            ///< that wrote the page
  bool again = false;             ///< loads itself again, since it is written again
};

/// The page, which needs no other file.
std::string html(const Document& document);

}  // namespace gurney::page
