#pragma once

#include "studies/figures/panel.h"

namespace gurney::figures {

/// The legend of a panel at the right end above its axes, and its title, at their left end or,
/// where that is too narrow for both, above the legend.
void draw_head(Svg& svg, const Frame& frame, const Panel& panel);

/// `x` and `y` in px.
void draw_marker(Svg& svg, double x, double y, const Marks& marks);

}  // namespace gurney::figures
