#include "studies/page/document.h"

#include <map>

#include "embedded/chart_js.h"
#include "embedded/page_css.h"
#include "embedded/page_html.h"
#include "embedded/page_js.h"

namespace gurney::page {
namespace {

/// The browser loads the page again, and keeps its place.
constexpr const char* kAgain = "<meta http-equiv=\"refresh\" content=\"3\">\n";

/// The text with each `{{name}}` of it replaced; what is put in is not looked at again.
std::string filled(std::string_view text,
                   const std::map<std::string_view, std::string_view>& with) {
  std::string result;
  while (true) {
    const std::size_t open = text.find("{{"), close = text.find("}}", open);
    if (close == std::string_view::npos) return result.append(text);
    result.append(text.substr(0, open));
    result.append(with.at(text.substr(open + 2, close - open - 2)));
    text.remove_prefix(close + 2);
  }
}

}  // namespace

std::string html(const Document& document) {
  Html contents, body;
  for (const Section& section : document.sections) {
    if (section.content.empty()) continue;
    const std::string heading = section.id + "-heading";
    contents += element("li", element("a", section.title, {{"href", "#" + section.id}}));
    body += element("section", element("h2", section.title, {{"id", heading}}) + section.content,
                    {{"id", section.id}, {"aria-labelledby", heading}});
  }
  const std::string title = escaped(document.title).code,
                    subtitle = escaped(document.subtitle).code,
                    program = escaped(document.program).code;
  return filled(embedded::page_html, {{"title", title},
                                      {"again", document.again ? kAgain : ""},
                                      {"subtitle", subtitle},
                                      {"program", program},
                                      {"style", embedded::page_css},
                                      {"script", embedded::page_js},
                                      {"charts", embedded::chart_js},
                                      {"contents", contents.code},
                                      {"sections", body.code}});
}

}  // namespace gurney::page
