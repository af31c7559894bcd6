#pragma once

// Random123 refuses machines that it does not know; it asks nothing but their name.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <stdexcept>

#define __arm__ 1
#define R123_USE_GNU_UINT128 1
#include_next <Random123/philox.h>
#undef __arm__
