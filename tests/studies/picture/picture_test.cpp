#include "studies/picture/picture.h"

#include <gtest/gtest.h>

#include "engine/base/error.h"
#include "studies/figures/panel.h"
#include "tests/support/error_text.h"

namespace gurney::picture {
namespace {

constexpr double kMmPerInch = 25.4;

std::string figure(double width, double height, const std::string& text = "text") {
  figures::Svg svg(width, height);
  for (std::size_t i = 0; i < 7; ++i)
    svg.line(0, 10.0 * static_cast<double>(i), width, 0, {.stroke = figures::palette(i)});
  svg.text(10, 10, text);
  return svg.str();
}

unsigned big_endian(const std::string& bytes, std::size_t at) {
  unsigned value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = 256 * value + static_cast<unsigned char>(bytes[at + i]);
  return value;
}

TEST(Picture, FormatIsNamedByTheSuffix) {
  EXPECT_EQ(format_of("a.svg"), Format::kSvg);
  EXPECT_EQ(format_of("folder.svg/a.pdf"), Format::kPdf);
  EXPECT_EQ(format_of("a.b.png"), Format::kPng);
  for (const char* path : {"a.eps", "a", "a.PDF", ".png", "a.svg.gz"})
    EXPECT_THROW(format_of(path), Error) << path;
}

TEST(Picture, LengthsHaveUnits) {
  EXPECT_DOUBLE_EQ(length_in_mm("85mm"), 85);
  EXPECT_DOUBLE_EQ(length_in_mm("8.5cm"), 85);
  EXPECT_DOUBLE_EQ(length_in_mm("2in"), 2 * kMmPerInch);
  EXPECT_DOUBLE_EQ(length_in_mm("72pt"), kMmPerInch);
  EXPECT_DOUBLE_EQ(length_in_mm("96px"), kMmPerInch);
  for (const char* text : {"", "85", "mm", "85 mm", "85m", "-85mm", "nanmm", "1mm", "1e9mm"})
    EXPECT_THROW(length_in_mm(text), Error) << text;
}

TEST(Picture, PdfHasItsSizeOnPaper) {
  // 85 mm = 240.945 pt; half as high as wide.
  const std::string pdf = written(figure(700, 350), Format::kPdf, {.width_mm = 85});
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  const auto at = pdf.find("/MediaBox [ 0 0 ");
  ASSERT_NE(at, std::string::npos);
  double width = 0, height = 0;
  ASSERT_EQ(std::sscanf(pdf.c_str() + at, "/MediaBox [ 0 0 %lf %lf ]", &width, &height), 2);
  EXPECT_NEAR(width, 85 / kMmPerInch * 72, 0.01);
  EXPECT_NEAR(height, width / 2, 0.01);
}

TEST(Picture, PngHas300PixelsToTheInch) {
  // IHDR: width and height from the 17th byte on (PNG, section 11.2.2).
  const std::string own = written(figure(960, 480), Format::kPng);
  EXPECT_EQ(big_endian(own, 16), 3000u);
  EXPECT_EQ(big_endian(own, 20), 1500u);
  const std::string narrow = written(figure(960, 480), Format::kPng, {.width_mm = 50.8});
  EXPECT_EQ(big_endian(narrow, 16), 600u);
  EXPECT_THROW(written(figure(100, 5000), Format::kPng, {.width_mm = 1000}), Error);
}

TEST(Picture, SvgHasItsWidth) {
  const std::string svg = written(figure(700, 350), Format::kSvg, {.width_mm = 85});
  EXPECT_NE(svg.find("width=\"85mm\" height=\"42.5mm\" viewBox=\"0 0 700 350\""),
            std::string::npos);
  EXPECT_EQ(written(figure(700, 350), Format::kSvg), figure(700, 350));
}

TEST(Picture, TheSameFigureGivesTheSameBytes) {
  for (const Format format : {Format::kPdf, Format::kPng})
    EXPECT_EQ(written(figure(100, 100), format), written(figure(100, 100), format));
  EXPECT_EQ(written(figure(100, 100), Format::kPdf).find("CreationDate"), std::string::npos);
}

TEST(Picture, GreyCurvesDiffer) {
  const std::string grey = in_grey(figure(100, 100, "stroke=\"#0072B2\" <stroke=\"#D55E00\">"));
  std::set<std::string> pens;
  std::size_t lines = 0;
  for (auto at = grey.find("<line"); at != std::string::npos; at = grey.find("<line", at + 1)) {
    const auto pen = grey.find("stroke=", at);
    pens.insert(grey.substr(pen, grey.find("/>", pen) - pen));
    ++lines;
  }
  EXPECT_EQ(lines, 7u);
  EXPECT_EQ(pens.size(), 7u);
  EXPECT_NE(grey.find("stroke=&quot;#0072B2&quot; &lt;stroke=&quot;#D55E00&quot;&gt;"),
            std::string::npos)
      << "texts stay as they are";
  EXPECT_EQ(in_grey("<a fill=\"#ff0000\"/>"), "<a fill=\"#7f7f7f\"/>");
}

TEST(Picture, HostileTextsAreText) {
  std::string all = "<script>alert(1)</script> \"'&; ]]> \xc3\xa9\xe6\xbc\xa2 \xff";
  all += std::string("\x00\x01\x1b[31m\n", 8) + std::string(20000, 'x');
  const std::string svg = figure(300, 100, all);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  for (const Format format : {Format::kSvg, Format::kPdf, Format::kPng})
    EXPECT_GT(written(svg, format).size(), 500u);
}

}  // namespace
}  // namespace gurney::picture
