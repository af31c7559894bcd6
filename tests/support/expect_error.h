#pragma once

#include <gtest/gtest.h>

#include <string>

#include "engine/base/error.h"

/// Holds when `statement` throws a gurney::Error whose text contains `fragment`.
#define EXPECT_ERROR(statement, fragment)                                   \
  try {                                                                     \
    statement;                                                              \
    ADD_FAILURE() << #statement " threw nothing, expected: " << (fragment); \
  } catch (const gurney::Error& error) {                                    \
    EXPECT_NE(std::string(error.what()).find(fragment), std::string::npos)  \
        << "got: " << error.what() << "\nexpected: " << (fragment);         \
  }
