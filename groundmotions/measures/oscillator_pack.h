#pragma once

#include "engine/base/lanes.h"
#include "groundmotions/measures/oscillator.h"

namespace gurney::groundmotions {

/// Oscillators of four periods under one load, side by side in SIMD registers.
struct OscillatorPack {
  Lanes uu{}, uv{}, u_p0{}, u_p1{}, vu{}, vv{}, v_p0{}, v_p1{};

  void set(std::size_t lane, const OscillatorStep& s) {
    uu[lane] = s.uu, uv[lane] = s.uv, u_p0[lane] = s.u_p0, u_p1[lane] = s.u_p1;
    vu[lane] = s.vu, vv[lane] = s.vv, v_p0[lane] = s.v_p0, v_p1[lane] = s.v_p1;
  }

  void step(double p0, double p1, Lanes& u, Lanes& v) const {
    const Lanes last = u;
    u = (uu * last + uv * v) + (u_p0 * p0 + u_p1 * p1);
    v = (vu * last + vv * v) + (v_p0 * p0 + v_p1 * p1);
  }
};

}  // namespace gurney::groundmotions
