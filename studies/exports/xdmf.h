#pragma once

#include <string>

#include "studies/exports/export.h"

namespace gurney::study {

/// A run as moving shapes, for ParaView and VisIt: NAME.xdmf (XDMF 3) names the times and points
/// into NAME_shapes.h5, where each time has the points of items and casters (turned about their
/// swivel axes), and the room has its points once; cells carry `item`, the index of the item in the file, or -1 for the room.
/// @param name  of both files, without ending
/// @throws Error unless the file is that of one run with histories
void export_xdmf(const std::string& path, const std::string& name, const TakeFile& take);

}  // namespace gurney::study
