#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/peers/cross_check.h"

namespace gurney::benchmark {

/// One engine with one set-up.
struct Engine {
  std::string name, setup;
  std::vector<double> steps;   ///< [s]; or tolerances of Gurney's own steps
  bool chooses_steps = false;  ///< by a tolerance
  bool euler = false;          ///< positions by the semi-implicit Euler method
  bool shared_model = false;   ///< rigid treads and the best set-up: part of the common truth
  std::function<peers::Path(const peers::CrossCheck&, double step)> run = {};
  std::function<peers::Path(const peers::CrossCheck&, double step)> fixed_step = {};
};

/// Those that the product links: Gurney and Bullet.
std::vector<Engine> own_engines(const std::vector<double>& steps,
                                const std::vector<double>& tolerances);

/// These, MuJoCo and ODE.
std::vector<Engine> engines(const std::vector<double>& steps,
                            const std::vector<double>& tolerances);

}  // namespace gurney::benchmark
