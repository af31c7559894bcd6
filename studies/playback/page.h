#pragma once

#include <string>
#include <vector>

#include "studies/playback/page_data.h"

namespace gurney::playback {

/// A page that needs no other file and nothing from a network.
std::string playback_page(const std::vector<PageRun>& runs,
                          const std::vector<PageRun>& ghosts = {});

}  // namespace gurney::playback
