#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

}  // namespace gurney::page
