#pragma once

#include <string>

#include "engine/config/document.h"

namespace gurney::config {

/// Puts the elements of the table `patch` over those of the table `base`.
///
/// Tables are merged, key by key; any other element, and a table with the key `value` (a quantity),
/// replaces what was there. In an array of tables `[[caster]]` the patch names the tables it
/// changes by their `name`, or, before those, all by `*`: `caster."front left".brake = true`.
/// Places stay those of the patch. A name no table has is noted in `document`.
/// @param path  of the patch, for messages
void overlay(Node& base, const Node& patch, const std::string& path, Document& document);

}  // namespace gurney::config
