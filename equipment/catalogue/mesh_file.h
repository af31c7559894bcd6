#pragma once

#include <string>
#include <vector>

#include "engine/base/vector.h"

namespace gurney::equipment {

/// One object of a mesh: the corners of its triangles, in the unit of the file.
struct MeshObject {
  std::string name;
  std::vector<Vector3> points;
};

/// The objects of an STL file, ASCII (one for each `solid`) or binary (one), or of an OBJ file (one for
/// each `o` or `g` with faces). Normals, colours and materials are passed over.
/// @throws Error with `file:line` for a missing file, another format, a line that is not as it must be,
///         and a mesh without triangles.
std::vector<MeshObject> read_mesh(const std::string& path);

}  // namespace gurney::equipment
