#pragma once

#include <string>
#include <utility>
#include <vector>

namespace gurney::figures {

/// How a line or an area is drawn. An empty colour draws nothing.
struct Pen {
  std::string stroke = "#000000";
  double width = 1;
  std::string dash = {};  ///< SVG stroke-dasharray, such as "4 3"
  std::string fill = {};
  double opacity = 1;
};

enum class Anchor { kStart, kMiddle, kEnd };

struct TextStyle {
  double size = 11;  ///< [px]
  Anchor anchor = Anchor::kStart;
  bool bold = false;
  bool upwards = false;  ///< turned by 90 degrees, reads from below
  std::string color = "#222222";
};

/// A picture in Scalable Vector Graphics; x to the right, y down, in px.
class Svg {
 public:
  using Points = std::vector<std::pair<double, double>>;

  Svg(double width, double height);

  void line(double x1, double y1, double x2, double y2, const Pen& pen);
  void rectangle(double x, double y, double width, double height, const Pen& pen);
  void circle(double x, double y, double radius, const Pen& pen);
  void polyline(const Points& points, const Pen& pen, bool closed = false);
  void text(double x, double y, const std::string& text, const TextStyle& style = {});

  /// What follows is drawn inside this rectangle only, until end_group().
  void begin_clip(double x, double y, double width, double height);

  /// What follows belongs together, until end_group(); a page reads the attributes.
  /// @param attributes  names, which must be plain, and values of any text
  void begin_group(const std::vector<std::pair<std::string, std::string>>& attributes);
  void end_group();

  /// Says what the picture shows; it is not drawn.
  void describe(const std::string& text);

  std::string str() const;

 private:
  std::string body_;
  double width_, height_;
  int clips_ = 0;
};

}  // namespace gurney::figures
