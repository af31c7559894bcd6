#include <algorithm>
#include <sstream>

#include "studies/figures/panel.h"

namespace gurney::figures {
namespace {

constexpr double kKey = 24, kGap = 5, kSpace = 12, kRow = 13, kSize = 10, kTitleSize = 12,
                 kTitleLine = 15;

struct Entry {
  std::string label;
  const Curve* curve;
  const Marks* marks;
};

std::vector<Entry> entries_of(const Panel& panel) {
  std::vector<Entry> entries;
  if (panel.legend_columns == 0) return entries;
  for (const Curve& curve : panel.curves)
    if (!curve.label.empty()) entries.push_back({curve.label, &curve, nullptr});
  for (const Marks& marks : panel.marks)
    if (!marks.label.empty()) entries.push_back({marks.label, nullptr, &marks});
  return entries;
}

/// Entries row by row, in columns that are as wide as their widest.
struct Legend {
  std::vector<Entry> entries;
  std::vector<double> widths;  ///< of the columns
  double width = 0;

  std::size_t rows() const {
    return widths.empty() ? 0 : (entries.size() + widths.size() - 1) / widths.size();
  }
};

Legend legend_of(std::vector<Entry> entries, std::size_t columns) {
  Legend legend{std::move(entries), std::vector<double>(columns, 0.0), 0};
  for (std::size_t i = 0; i < legend.entries.size(); ++i) {
    double& width = legend.widths[i % columns];
    width = std::max(width, kKey + kGap + kSpace + text_width(legend.entries[i].label, kSize));
  }
  for (const double width : legend.widths) legend.width += width;
  return legend;
}

/// With as many columns as the panel asks for, or as there is room for.
Legend legend_of(const Panel& panel, double width) {
  std::vector<Entry> entries = entries_of(panel);
  if (entries.empty()) return {};
  for (Entry& entry : entries)
    entry.label = fitted(entry.label, kSize, width - kKey - kGap - kSpace);
  for (auto columns = std::min(static_cast<std::size_t>(panel.legend_columns), entries.size());;
       --columns) {
    Legend legend = legend_of(entries, columns);
    if (legend.width <= width || columns == 1) return legend;
  }
}

/// Height of the names of guides above the axes.
double guide_height(const Panel& panel) {
  const bool named =
      std::ranges::any_of(panel.guides, [](const Guide& guide) { return !guide.label.empty(); });
  return named ? 13 : 0;
}

std::vector<std::string> title_lines(const Panel& panel, double width) {
  constexpr std::size_t kMost = 3;
  return lines_of(panel.title, kBold * kTitleSize, width, kMost);
}

double title_height(const Panel& panel, double width) {
  const auto lines = static_cast<double>(title_lines(panel, width).size());
  return lines > 0 ? kTitleLine * lines + 1 : 0;
}

/// Whether title and last row of the legend do not fit beside each other.
bool stacked(const Panel& panel, const Legend& legend, double width) {
  return !panel.title.empty() && !legend.entries.empty() &&
         kBold * text_width(panel.title, kTitleSize) + legend.width + kSpace > width;
}

void draw_key(Svg& svg, double x, double y, const Entry& entry) {
  if (entry.curve) svg.line(x, y, x + kKey, y, entry.curve->pen);
  if (entry.curve && entry.curve->key)
    draw_marker(svg, x + kKey / 2, y,
                {"", {}, {}, {.stroke = entry.curve->pen.stroke}, *entry.curve->key, 2.8});
  if (entry.marks) draw_marker(svg, x + kKey / 2, y, *entry.marks);
}

}  // namespace

double overhang(const Panel& panel, double left) {
  const bool named =
      std::ranges::any_of(panel.rows, [](const std::string& name) { return !name.empty(); });
  return named ? left - 16 : 0;
}

double head_height(const Panel& panel, double width) {
  const Legend legend = legend_of(panel, width);
  const double rows = kRow * static_cast<double>(legend.rows());
  const double title = title_height(panel, width);
  return 8 + guide_height(panel) +
         (stacked(panel, legend, width) ? rows + title : std::max(rows, title));
}

void draw_head(Svg& svg, const Frame& axes, const Panel& panel) {
  const double lift = guide_height(panel);
  const double out = overhang(panel, axes.x);
  const Frame frame{axes.x - out, axes.y - lift, axes.width + out, axes.height + lift};
  const Legend legend = legend_of(panel, frame.width);
  const auto rows = legend.rows();
  for (std::size_t i = 0; i < legend.entries.size(); ++i) {
    const auto columns = legend.widths.size();
    double x = frame.x + frame.width - legend.width + kSpace;
    for (std::size_t column = 0; column < i % columns; ++column) x += legend.widths[column];
    const std::size_t row = i / columns;
    const double y = frame.y - 13 - kRow * static_cast<double>(rows - 1 - row);
    draw_key(svg, x, y, legend.entries[i]);
    svg.text(x + kKey + kGap, y + 3.5, legend.entries[i].label, {.size = kSize});
  }
  const double up = stacked(panel, legend, frame.width) ? kRow * static_cast<double>(rows) : 0;
  const std::vector<std::string> titles = title_lines(panel, frame.width);
  double y = frame.y - 9 - up - kTitleLine * static_cast<double>(titles.size());
  for (const std::string& line : titles)
    svg.text(frame.x, y += kTitleLine, line, {.size = kTitleSize, .bold = true});
}

void draw_marker(Svg& svg, double x, double y, const Marks& marks) {
  const double r = marks.radius, wide = 1.25 * r;
  Pen pen = marks.pen;
  if (pen.fill.empty()) pen.fill = "#ffffff";
  if (!pen.dash.empty()) pen.dash = "none";
  Pen stroke = marks.pen;
  stroke.dash = "none";  // never that of a curve in grey
  switch (marks.marker) {
    case Marker::kCircle:
      svg.circle(x, y, r, pen);
      break;
    case Marker::kSquare:
      svg.rectangle(x - 0.9 * r, y - 0.9 * r, 1.8 * r, 1.8 * r, pen);
      break;
    case Marker::kTriangle:
      svg.polyline({{x, y - wide}, {x - wide, y + 0.8 * wide}, {x + wide, y + 0.8 * wide}}, pen,
                   true);
      break;
    case Marker::kDiamond:
      svg.polyline({{x, y - wide}, {x - wide, y}, {x, y + wide}, {x + wide, y}}, pen, true);
      break;
    case Marker::kCross:
      svg.polyline({{x - r, y - r}, {x + r, y + r}, {x, y}, {x - r, y + r}, {x + r, y - r}},
                   stroke);
      break;
  }
}

double text_width(const std::string& text, double size) {
  constexpr double kOther = 0.64;  // of letters beyond ASCII [em]
  // Advances of DejaVu Sans from the space to the tilde [1/1000 em].
  constexpr int kAdvances[] = {
      318,  401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361, 318, 337,
      636,  636, 636, 636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531,
      1000, 684, 686, 698, 770, 632, 575, 775, 752, 295, 295, 656, 557, 863, 748, 787,
      603,  787, 695, 635, 611, 732, 684, 989, 685, 611, 685, 390, 337, 390, 838, 500,
      500,  613, 635, 550, 635, 615, 352, 635, 634, 278, 278, 579, 278, 974, 634, 612,
      635,  635, 411, 521, 392, 634, 592, 818, 592, 592, 525, 636, 337, 636, 838};
  double width = 0;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code >= ' ' && code <= '~')
      width += kAdvances[code - ' '] / 1000.0;
    else if ((code & 0xc0) != 0x80)  // the first of its character
      width += kOther;
  }
  return size * width;
}

std::string fitted(const std::string& text, double size, double width) {
  if (text_width(text, size) <= width) return text;
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t next = at + 1;
    while (next < text.size() && (static_cast<unsigned char>(text[next]) & 0xc0) == 0x80) ++next;
    if (text_width(text.substr(0, next) + "x", size) > width) break;
    result = text.substr(0, next);
    at = next;
  }
  return result + "\u2026";
}

std::vector<std::string> lines_of(const std::string& text, double size, double width,
                                  std::size_t most) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const bool fits = !lines.empty() && text_width(lines.back() + " " + word, size) <= width;
    if (fits)
      lines.back() += " " + word;
    else
      lines.push_back(fitted(word, size, width));
  }
  if (lines.size() > most) {
    const std::string next = lines[most];
    lines.resize(most);
    lines.back() = fitted(lines.back() + " " + next, size, width);
  }
  return lines;
}

Marker marker(std::size_t index) {
  constexpr Marker kMarkers[] = {Marker::kCircle, Marker::kSquare, Marker::kTriangle,
                                 Marker::kDiamond};
  return kMarkers[index % std::size(kMarkers)];
}

}  // namespace gurney::figures
