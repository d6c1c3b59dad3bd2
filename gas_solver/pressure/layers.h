// Coefficients of a pressure system that change along one axis only, and which systems have them.
#pragma once

#include <array>
#include <vector>

#include "gas_solver/pressure/pressure_system.h"

namespace gasgrain {

// A layer is one cell thick, across `axis`.
struct Layers {
  int axis = 2;
  std::vector<double> across;  // faces between layers n - 1 and n, one more than cells
  std::array<std::vector<double>, 2> along;  // faces within layer n, along plane_axes(axis)
  std::vector<double> storage;               // cells of layer n
};

// The axes whose layers can be transformed, best first: each side of the other two axes gives the
// normal velocity, or is periodic. Empty when outlets lie on sides of more than one axis.
std::vector<int> layer_axes(const PressureSystem& system);

// The first of these axes along which alone the coefficients change, up to round-off; -1: none.
// Collective, and the same on all ranks.
int layered_axis(const Domain& domain, const PressureSystem& system);

// Means of each layer, harmonic ones of the faces: where bubbles make the layers differ, conjugate
// gradients preconditioned with these need 0.5 to 0.75 of the iterations that they need with
// arithmetic means (tests/bench/pressure_bench, contrasts 24 to 10000). Collective.
Layers layer_means(const Domain& domain, const PressureSystem& system, int axis);

}  // namespace gasgrain
