#include "studies/page/drawing.h"

#include <string_view>

namespace gurney::page {
namespace {

void replace_all(std::string& text, std::string_view from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

/// Ids of the figure, which are those of its clip paths, become unique on the page. Texts between
/// the tags stay as they are.
std::string with_own_ids(const std::string& svg, const std::string& name) {
  std::string result;
  std::size_t at = 0;
  while (at < svg.size()) {
    const std::size_t open = svg.find('<', at);
    const std::size_t close = open == std::string::npos ? open : svg.find('>', open);
    result += svg.substr(at, open == std::string::npos ? open : open - at);
    if (close == std::string::npos) break;
    std::string tag = svg.substr(open, close + 1 - open);
    replace_all(tag, "id=\"clip", "id=\"" + name + "-clip");
    replace_all(tag, "url(#clip", "url(#" + name + "-clip");
    result += tag;
    at = close + 1;
  }
  return result;
}

}  // namespace

Html html(const Drawing& drawing) {
  const std::string title = drawing.name + "-title", about = drawing.name + "-about";
  std::string svg = with_own_ids(drawing.svg, drawing.name);
  const std::size_t end = svg.find('>');
  const Html names = element("title", drawing.caption, {{"id", title}}) +
                     element("desc", drawing.description, {{"id", about}});
  svg.insert(end + 1, "\n" + names.code);
  svg.insert(4,
             " role=\"img\" aria-labelledby=\"" + title + "\" aria-describedby=\"" + about + "\"");
  const Html link = element("a", "Save as SVG",
                            {{"class", "save"},
                             {"href", "#" + drawing.name + "-figure"},
                             {"download", drawing.name + ".svg"}});
  return element("figure",
                 element("div", Html{svg}, {{"class", "paper"}}) +
                     element("figcaption", escaped(drawing.caption + " ") + link),
                 {{"id", drawing.name + "-figure"}});
}

}  // namespace gurney::page
