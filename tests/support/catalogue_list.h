#pragma once

#include <string>

#include "equipment/catalogue/catalogue.h"

namespace gurney {

/// The catalogue as an error message lists it: `P100, R100, R125`.
inline std::string catalogue_list(equipment::DataKind kind) {
  std::string list;
  for (const std::string& name : equipment::catalogue_names(kind))
    list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace gurney
