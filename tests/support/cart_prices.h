#pragma once

#include <string>

namespace gurney::study {

/// Beginning of a list of consequences: the price of a cart, and two limit states.
inline const std::string kCartPrices = R"(schema = "gurney-consequences/1"
currency = "EUR"
year = 2025
[[price]]
item = "cart"
price = 1000
[[limit_state]]
name = "moved"
demand = "peak_displacement"
above = 10
unit = "cm"
[[limit_state]]
name = "fell"
event = "overturned"
)";

}  // namespace gurney::study
