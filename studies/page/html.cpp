#include "studies/page/html.h"

#include "engine/base/printable.h"

namespace gurney::page {
namespace {

/// Blanks between elements inside a line would show.
bool ends_line(std::string_view tag) {
  for (const std::string_view block : {"tr", "p", "li", "ul", "dd", "dl", "h3", "div", "figure",
                                       "section", "details", "table", "caption", "script"})
    if (tag == block) return true;
  return false;
}

}  // namespace

Html escaped(std::string_view text) {
  std::string result;
  for (const char c : printable(text)) switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  return {result};
}

Html element(const std::string& tag, const Html& content, const Attributes& attributes) {
  std::string open = "<" + tag;
  for (const auto& [name, value] : attributes)
    open += " " + name + "=\"" + escaped(value).code + "\"";
  return {open + ">" + content.code + "</" + tag + (ends_line(tag) ? ">\n" : ">")};
}

Html element(const std::string& tag, std::string_view text, const Attributes& attributes) {
  return element(tag, escaped(text), attributes);
}

Html paragraph(std::string_view text) { return element("p", text); }

Html list(const std::vector<std::string>& texts) {
  Html items;
  for (const std::string& text : texts) items += element("li", text);
  return items.empty() ? items : element("ul", items);
}

Html facts(const std::vector<std::pair<std::string, std::string>>& named) {
  Html items;
  for (const auto& [name, value] : named) items += element("dt", name) + element("dd", value);
  return items.empty() ? items : element("dl", items);
}

Html folded(std::string_view summary, const Html& content) {
  return element("details", element("summary", summary) + content);
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace gurney::page
