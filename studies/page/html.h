#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "studies/findings/findings.h"

/// The report of a results file as one HTML page.
namespace gurney::page {

/// HTML code. Names and other texts of files get into it by escaped() alone.
struct Html {
  std::string code;

  Html& operator+=(const Html& more) {
    code += more.code;
    return *this;
  }
  bool empty() const { return code.empty(); }
};

inline Html operator+(Html a, const Html& b) { return a += b; }

/// A text of any content and length as HTML that shows it, in elements and in attributes.
/// Control characters are shown as printable() has them.
Html escaped(std::string_view text);

using Attributes = std::vector<std::pair<std::string, std::string>>;

/// @param attributes  names, which must be plain, and values of any text
Html element(const std::string& tag, const Html& content, const Attributes& attributes = {});
Html element(const std::string& tag, std::string_view text, const Attributes& attributes = {});

Html paragraph(std::string_view text);
Html list(const std::vector<std::string>& texts);

/// A line for each name with its value.
Html facts(const std::vector<std::pair<std::string, std::string>>& named);

/// "1 run", "3 runs".
std::string counted(std::size_t count, const std::string& what);

/// Content that is folded away below a line of text.
Html folded(std::string_view summary, const Html& content);

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
