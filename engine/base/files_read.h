#pragma once

#include <string>

namespace gurney {

/// Notes a file that this process has read: no output may take its place.
void note_read(const std::string& path);

/// Whether this process has read the file that has this name now, under any name. Threads may ask
/// and note at once.
bool was_read(const std::string& path);

}  // namespace gurney
