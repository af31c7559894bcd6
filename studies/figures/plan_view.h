#pragma once

#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "studies/figures/panel.h"
#include "studies/units/unit_system.h"

namespace gurney::figures {

/// Axes of the scene from above, with all that moves on them, and the paths of the items.
Panel plan_panel(const Scene& scene, const Response& response, const study::UnitSystem& units = {});

/// Draws the scene on these axes: room shapes (low ones, such as thresholds, lighter), zones (those
/// that are occupied at the end darker), tethers, each item's boxes at the start (outline) and at
/// the end (filled, also where it lies), its front and casters while it stands, the points of
/// impact and a scale bar. Several items carry their numbers and are named at the right of the
/// frame. Every item must have a history.
/// @param in_unit  as draw() returns it
void draw_plan(Svg& svg, const Frame& frame, const Scaling& in_unit, const Scene& scene,
               const Response& response, const study::UnitSystem& units = {});

/// Height over width of the axes.
double plan_aspect(const Panel& plan);

}  // namespace gurney::figures
