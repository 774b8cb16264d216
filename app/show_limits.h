// The ranges of numbers that several tables of a show share, inclusive.
#pragma once

#include "app/toml_reader.h"

namespace hazer::app {

inline constexpr Limits kShare{0.0, 1.0};
inline constexpr Limits kColor{0.0, 1.0};
inline constexpr Limits kLength{-1e5, 1e5};  // m
inline constexpr Limits kAngle{-1e5, 1e5};   // deg

}  // namespace hazer::app
