#pragma once

#include "engine/response/response.h"
#include "engine/scene/scene.h"
#include "studies/figures/panel.h"
#include "studies/units/unit_system.h"

namespace gurney::figures {

/// Draws the scene from above: room shapes (low ones, such as thresholds, lighter), zones (those
/// that are occupied at the end darker), tethers, each item's boxes at the start (outline) and at
/// the end (filled, also where it lies), the path of its origin, its front and casters while it
/// stands, the points of impact and a scale bar. Several items carry their numbers and are named at
/// the right of the frame. Every item must have a history.
void draw_plan(Svg& svg, const Frame& frame, const Scene& scene, const Response& response,
               const study::UnitSystem& units = {});

/// Height over width of what draw_plan shows.
double plan_aspect(const Scene& scene, const Response& response);

}  // namespace gurney::figures
