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

/// The text of the element of this name, and the picture without it.
std::string take(std::string& svg, const std::string& tag) {
  const std::string open = "<" + tag + ">", close = "</" + tag + ">\n";
  const std::size_t at = svg.find(open), end = svg.find(close);
  if (at == std::string::npos || end == std::string::npos) return {};
  const std::string text = svg.substr(at + open.size(), end - at - open.size());
  svg.erase(at, end + close.size() - at);
  return text;
}

/// One picture. Its own description, such as what its lines and areas are, ends the caption.
Html figure(const Drawing& drawing, std::string svg, const std::string& name,
            const std::string& caption) {
  const std::string title = name + "-title", about = name + "-about";
  const std::string note = take(svg, "desc");
  svg = with_own_ids(svg, name);
  const std::size_t end = svg.find('>');
  const Html names = element("title", drawing.caption, {{"id", title}}) +
                     element("desc", drawing.description, {{"id", about}});
  svg.insert(end + 1, "\n" + names.code);
  svg.insert(4,
             " role=\"img\" aria-labelledby=\"" + title + "\" aria-describedby=\"" + about + "\"");
  const Html link =
      element("a", "Save as SVG",
              {{"class", "save"}, {"href", "#" + name + "-figure"}, {"download", name + ".svg"}});
  Html words = escaped(caption.empty() ? "" : caption + " ");
  if (!note.empty() && !caption.empty()) words += Html{"Key: " + note + ". "};
  return element(
      "figure",
      element("div", Html{svg}, {{"class", "paper"}}) + element("figcaption", words + link),
      {{"id", name + "-figure"}});
}

}  // namespace

Html html(const Drawing& drawing) {
  const std::string end = "</svg>\n";
  Html all;
  std::size_t from = 0;
  for (std::size_t count = 1, to; from < drawing.svg.size(); from = to, ++count) {
    const std::size_t at = drawing.svg.find(end, from);
    to = at == std::string::npos ? drawing.svg.size() : at + end.size();
    all += figure(drawing, drawing.svg.substr(from, to - from),
                  count == 1 ? drawing.name : drawing.name + "-" + std::to_string(count),
                  count == 1 ? drawing.caption : "");
  }
  return all;
}

Html side_by_side(const Html& figures) {
  return figures.empty() ? figures : element("div", figures, {{"class", "figures"}});
}

}  // namespace gurney::page
