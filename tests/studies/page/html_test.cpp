#include "studies/page/html.h"

#include <gmock/gmock.h>

#include "tests/studies/page/balanced.h"

namespace gurney::page {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Html, ShowsAnyTextAsText) {
  EXPECT_EQ(escaped("<script>alert('a' && \"b\")</script>").code,
            "&lt;script&gt;alert(&#39;a&#39; &amp;&amp; &quot;b&quot;)&lt;/script&gt;");
  EXPECT_EQ(escaped("\u03b8 \u65e5\u672c").code, "\u03b8 \u65e5\u672c");
  EXPECT_EQ(escaped(std::string_view("a\x1b\x00z", 4)).code, "a\\x1b\\x00z");
  EXPECT_EQ(escaped("\xff").code, "\\xff");
  EXPECT_EQ(escaped("{{script}}").code, "{{script}}");
}

TEST(Html, QuotesCannotEndAnAttribute) {
  const Html code = element("td", "x", {{"title", "\" onclick=\"alert(1)"}});
  EXPECT_EQ(code.code, "<td title=\"&quot; onclick=&quot;alert(1)\">x</td>");
  EXPECT_EQ(unbalanced(code.code), "");
}

TEST(Html, CheckOfTagsFindsErrors) {
  EXPECT_EQ(unbalanced("<p><b>x</b></p>"), "");
  EXPECT_EQ(unbalanced("<p><b>x</p></b>"), "</p> closes b");
  EXPECT_EQ(unbalanced("<p>x"), "not closed: p");
  EXPECT_EQ(unbalanced("<p id=\"a\"></p><p id=\"a\"></p>"), "twice: id a");
  EXPECT_EQ(unbalanced("<p id=a></p>"), "no quotes: <p id=a");
}

TEST(PageTable, KeepsTheNumberOfTheFileBesideTheText) {
  const findings::Table table{
      "", "<caption>", {{"", "A"}, {"", "B", {".3g", "m"}}}, {{"<b>", 0.1 + 0.2}}};
  const std::string code = html(table).code;
  EXPECT_THAT(code, HasSubstr("data-value=\"0.30000000000000004\">0.3</td>"));
  EXPECT_THAT(code, HasSubstr("<caption>&lt;caption&gt;</caption>"));
  EXPECT_THAT(code, HasSubstr("scope=\"row\" class=\"short\">&lt;b&gt;</th>"));
  EXPECT_EQ(unbalanced(code), "");
  EXPECT_EQ(html(findings::Table{"", "no rows", {{"", "A"}}}).code, "");
}

TEST(PageTable, ShowsADashForNoNumber) {
  const std::string code = html(findings::Table{"", "", {{"", "A"}}, {{std::nan("")}}}).code;
  EXPECT_THAT(code, HasSubstr(">\u2013</th>"));
  EXPECT_THAT(code, Not(HasSubstr("data-value")));
}

TEST(PageDrawing, HasIdsOfItsOwnAndLeavesTextsAlone) {
  const Drawing drawing{"a-name",
                        "<svg width=\"1\"><clipPath id=\"clip1\"></clipPath>\n<g "
                        "clip-path=\"url(#clip1)\"></g><text>url(#clip1)</text></svg>\n",
                        "Caption <1>", "About"};
  const std::string code = html(drawing).code;
  EXPECT_THAT(code, HasSubstr("<clipPath id=\"a-name-clip1\">"));
  EXPECT_THAT(code, HasSubstr("clip-path=\"url(#a-name-clip1)\""));
  EXPECT_THAT(code, HasSubstr("<text>url(#clip1)</text>"));
  EXPECT_THAT(code, HasSubstr("role=\"img\" aria-labelledby=\"a-name-title\""));
  EXPECT_THAT(code, HasSubstr("<title id=\"a-name-title\">Caption &lt;1&gt;</title>"));
  EXPECT_THAT(code, HasSubstr("download=\"a-name.svg\""));
  EXPECT_EQ(unbalanced(code), "");
}

}  // namespace
}  // namespace gurney::page
