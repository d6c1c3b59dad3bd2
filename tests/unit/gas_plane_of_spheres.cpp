#include "gas_solver/plane_of_spheres.h"

#include <gtest/gtest.h>

namespace gasgrain {
namespace {

// Volume fraction of spheres in cells of the plane's depth from the area fraction of their discs.
double fraction_in_cell(double discs) {
  return discs / 1.5 / plane_depth_in_diameters;
}

TEST(plane_of_spheres, closest_packing_of_the_plane_becomes_that_of_space) {
  const double hexagonal = M_PI / (2 * std::sqrt(3.0));
  EXPECT_NEAR(solids_in_space(fraction_in_cell(hexagonal)), M_PI / (3 * std::sqrt(2.0)), 1e-14);
}

TEST(plane_of_spheres, lattices_of_equal_distance_become_each_other) {
  for (const double distance : {1.0, 1.2, 2.0}) {
    const double hexagonal = M_PI / 4 / (std::sqrt(3.0) / 2 * distance * distance);
    const double cubic = 4 * M_PI / 6 / std::pow(std::sqrt(2.0) * distance, 3);
    EXPECT_NEAR(solids_in_space(fraction_in_cell(hexagonal)), cubic, 1e-14);
  }
}

TEST(plane_of_spheres, depth_of_a_cell_keeps_the_volume_of_spheres_on_a_square_lattice) {
  const double square = M_PI / 4;
  EXPECT_NEAR(solids_in_space(fraction_in_cell(square)), fraction_in_cell(square), 1e-14);
}

}  // namespace
}  // namespace gasgrain
