#include "studies/figures/plot_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace gurney::figures {
namespace {

constexpr double kLeft = 62, kRight = 16, kBelow = 40, kTitleSize = 14, kNoteSize = 10.5;

/// Words in lines that are no wider than `width`.
std::vector<std::string> lines_of(const std::string& text, double size, double width) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const bool fits = !lines.empty() && text_width(lines.back() + " " + word, size) <= width;
    if (fits)
      lines.back() += " " + word;
    else
      lines.push_back(fitted(word, size, width));
  }
  return lines;
}

/// Every n-th of the marks, and of the curves without a name. @return n
std::size_t thin_out(Panel& panel, std::size_t most) {
  std::size_t marks = 0, curves = 0;
  for (const Marks& each : panel.marks) marks += each.x.size();
  for (const Curve& each : panel.curves) curves += each.label.empty();
  const std::size_t every = (std::max(marks, curves) + most - 1) / most;
  if (every <= 1) return 1;
  for (Marks& each : panel.marks) {
    Marks kept = each;
    kept.x.clear();
    kept.y.clear();
    for (std::size_t i = 0; i < each.x.size(); i += every) {
      kept.x.push_back(each.x[i]);
      kept.y.push_back(each.y[i]);
    }
    each = std::move(kept);
  }
  if (curves > most) {
    std::size_t seen = 0;
    std::erase_if(panel.curves,
                  [&](const Curve& each) { return each.label.empty() && seen++ % every != 0; });
  }
  return every;
}

double height_of(const PlotPanel& each, double width) {
  if (each.height > 0) return each.height;
  if (each.panel.lanes)
    return std::max(150.0, 62.0 * static_cast<double>(each.panel.curves.size()));
  return std::clamp(each.aspect * width, 120.0, 640.0);
}

}  // namespace

std::string plot_figure(const PlotPage& page, const std::string& title, std::string note,
                        std::vector<PlotPanel> panels) {
  std::size_t every = 1;
  if (page.most_marks > 0)
    for (PlotPanel& each : panels) every = std::max(every, thin_out(each.panel, page.most_marks));
  if (every > 1)
    note += fmt::format("; of many runs or records one in {} is drawn, lines and areas are of all",
                        every);
  constexpr std::size_t kTitleLines = 2;
  const double width = page.width - kLeft - kRight, text_space = page.width - 2 * kRight;
  std::vector<std::string> titles = lines_of(title, 1.08 * kTitleSize, text_space);
  if (titles.size() > kTitleLines) {
    titles.resize(kTitleLines);
    titles.back() += "\u2026";
  }
  const std::vector<std::string> notes = lines_of(note, kNoteSize, text_space);
  const double head =
      12 + 18 * static_cast<double>(titles.size()) + 14 * static_cast<double>(notes.size()) + 4;
  double height = head;
  for (const PlotPanel& each : panels)
    height += head_height(each.panel, width) + height_of(each, width) + kBelow;
  Svg svg(page.width, height + 4);
  double y = 8;
  for (const std::string& line : titles)
    svg.text(kRight, y += 18, line, {.size = kTitleSize, .bold = true});
  for (const std::string& line : notes)
    svg.text(kRight, y += 14, line, {.size = kNoteSize, .color = "#555555"});
  y = head;
  for (const PlotPanel& each : panels) {
    y += head_height(each.panel, width);
    const double left = each.panel.y_axis ? kLeft : kRight;
    const Frame frame{left, y, width + kLeft - left, height_of(each, width)};
    if (each.panel.lanes) {
      draw_lanes(svg, frame, each.panel);
    } else {
      const Scaling scaling = draw(svg, frame, each.panel);
      if (each.overlay) each.overlay(svg, frame, scaling);
    }
    y += frame.height + kBelow;
  }
  return svg.str();
}

}  // namespace gurney::figures
