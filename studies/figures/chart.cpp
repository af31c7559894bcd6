#include "studies/figures/chart.h"

#include <fmt/format.h>

#include <algorithm>

namespace gurney::figures {
namespace {

constexpr double kLeft = 62, kRight = 16, kBelow = 40, kTitleSize = 14, kNoteSize = 10.5,
                 kNoteLine = 14;

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
    kept.runs.clear();
    for (std::size_t i = 0; i < each.x.size(); i += every) {
      kept.add(each.x[i], each.y[i]);
      if (!each.runs.empty()) kept.runs.push_back(each.runs[i]);
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

/// Names of rows have the room that they need, up to a part of the panel.
double left_of(const Panel& panel, double width) {
  if (panel.rows.empty()) return kLeft;
  double widest = 0;
  for (const std::string& name : panel.rows) widest = std::max(widest, text_width(name, 10));
  return std::clamp(widest + 14, kRight, 0.42 * width);
}

double height_of(const PlotPanel& each, double width) {
  constexpr double kRow = 26;
  if (each.height > 0) return each.height;
  if (!each.panel.rows.empty()) return kRow * static_cast<double>(each.panel.rows.size());
  if (each.panel.lanes)
    return std::max(150.0, 62.0 * static_cast<double>(each.panel.curves.size()));
  return std::clamp(each.aspect * width, 120.0, 640.0);
}

/// Panels in the cells of a grid.
class Grid {
 public:
  Grid(const std::vector<PlotPanel>& panels, std::size_t columns, double width)
      : columns_(columns), cell_((width - kRight) / static_cast<double>(columns)) {
    for (const PlotPanel& panel : panels) place(panel);
    for (const Cell& cell : cells_) {
      if (cell.panel->down > 1) continue;
      Row& row = rows_[cell.row];
      row.head = std::max(row.head,
                          head_height(cell.panel->panel,
                                      frame_width(cell) + overhang(cell.panel->panel, left(cell))));
      row.height = std::max(row.height, height_of(*cell.panel, frame_width(cell)));
    }
  }

  double height() const { return top_of(rows_.size()); }

  void draw(Svg& svg, double top) const {
    for (const Cell& cell : cells_) {
      const Panel& panel = cell.panel->panel;
      const double y = top + top_of(cell.row) + rows_[cell.row].head;
      const std::size_t last = cell.row + cell.panel->down - 1;
      const double height = cell.panel->down > 1
                                ? top + top_of(last) + rows_[last].head + rows_[last].height - y
                                : height_of(*cell.panel, frame_width(cell));
      const double x = cell_ * static_cast<double>(cell.column) + left(cell);
      const Frame frame{x, y, frame_width(cell), height};
      if (panel.lanes) {
        draw_lanes(svg, frame, panel);
      } else {
        const Scaling scaling = figures::draw(svg, frame, panel);
        if (cell.panel->overlay) cell.panel->overlay(svg, frame, scaling);
      }
    }
  }

 private:
  struct Cell {
    const PlotPanel* panel;
    std::size_t column, row;
  };
  struct Row {
    double head = 0, height = 0;
  };

  /// At the first place where it covers no other.
  void place(const PlotPanel& panel) {
    const std::size_t across = std::min(panel.across, columns_);
    for (std::size_t at = 0;; ++at) {
      const Cell cell{&panel, at % columns_, at / columns_};
      if (cell.column + across > columns_) continue;
      const bool free = std::ranges::none_of(cells_, [&](const Cell& other) {
        return cell.row < other.row + other.panel->down && other.row < cell.row + panel.down &&
               cell.column < other.column + other.panel->across &&
               other.column < cell.column + across;
      });
      if (!free) continue;
      cells_.push_back(cell);
      rows_.resize(std::max(rows_.size(), cell.row + panel.down));
      return;
    }
  }

  double wide(const Cell& cell) const {
    return cell_ * static_cast<double>(std::min(cell.panel->across, columns_));
  }
  double left(const Cell& cell) const { return left_of(cell.panel->panel, wide(cell)); }
  double frame_width(const Cell& cell) const {
    const double gap = columns_ > 1 ? kRight / 2 : 0;
    return wide(cell) - left(cell) - cell.panel->beside - gap;
  }
  double top_of(std::size_t row) const {
    double top = 0;
    for (std::size_t i = 0; i < row; ++i) top += rows_[i].head + rows_[i].height + kBelow;
    return top;
  }

  std::size_t columns_;
  double cell_;
  std::vector<Cell> cells_;
  std::vector<Row> rows_;
};

}  // namespace

std::string Chart::svg(const PlotPage& page) const {
  Chart drawn = *this;
  std::size_t every = 1;
  for (PlotPanel& each : drawn.panels) {
    each.panel.overlaid = bool(each.overlay);
    if (page.most_marks > 0) every = std::max(every, thin_out(each.panel, page.most_marks));
  }
  if (every > 1)
    drawn.note += fmt::format(
        "; of many runs or records one in {} is drawn, lines and areas are of all", every);
  if (!page.apart) return drawn.picture(page);
  std::string all;
  for (PlotPanel& each : drawn.panels) {
    each.across = each.down = 1;
    all += Chart{"", drawn.note, {each}}.picture(page);
  }
  return all;
}

std::string Chart::picture(const PlotPage& page) const {
  constexpr std::size_t kTitleLines = 2;
  const double space = page.width - 2 * kRight;
  const std::vector<std::string> titles = lines_of(title, kBold * kTitleSize, space, kTitleLines);
  const std::vector<std::string> notes = lines_of(page.apart ? "" : note, kNoteSize, space);
  const auto size = [](const auto& lines) { return static_cast<double>(lines.size()); };
  const double head = 12 + 18 * size(titles) + kNoteLine * size(notes) + 4;
  const Grid grid(panels, columns, page.width);
  Svg svg(page.width, head + grid.height() + kNoteLine * size(footnotes) + 4);
  if (page.apart) svg.describe(note);
  double y = 8;
  for (const std::string& line : titles)
    svg.text(kRight, y += 18, line, {.size = kTitleSize, .bold = true});
  for (const std::string& line : notes)
    svg.text(kRight, y += kNoteLine, line, {.size = kNoteSize, .color = "#555555"});
  grid.draw(svg, head);
  y = head + grid.height() - 4;
  for (const std::string& line : footnotes)
    svg.text(kRight, y += kNoteLine, fitted(line, kNoteSize, space),
             {.size = kNoteSize, .color = "#555555"});
  return svg.str();
}

std::vector<PlotPanel> of_height(std::vector<Panel> panels, double height) {
  std::vector<PlotPanel> all;
  for (Panel& each : panels) all.push_back({.panel = std::move(each), .height = height});
  return all;
}

}  // namespace gurney::figures
