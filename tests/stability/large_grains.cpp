// Grains 1, 2 and 5 cells wide, wherever they are: in a cell, on a face, an edge, a corner, on
// their way across a face that is a periodic side.
//
// Bounds: the void fraction stays above what the gas bears; neither it nor the drag moves at once
// when a face is crossed; a grain in a stream feels the drag of its law. The negative controls are
// choices of the scene: `centre`, weights of a cell's width, `self_disturbance ignored`.
#include <gtest/gtest.h>

#include "gas_solver/packing_limit.h"
#include "tests/stability/face_crossing.h"

namespace gasgrain::stability {
namespace {

constexpr double least_eps = 1.0 - solids_limit - 1e-9;

// The drag on a grain that is held in the steady stream, over that of the law.
double held_drag(int across, int side, double reynolds, const std::string& rest,
                 const Vec3& place) {
  const Stream scene(1.0 / across, side * across, reynolds);
  CoupledBed bed(scene.input, "drag schiller_naumann void_fraction " + rest, scene.pace,
                 scene.grain(place));
  bed.held = true;
  for (int n = 0; n < 12; ++n) bed.advance();
  EXPECT_LT(bed.report().continuity_residual, 1e-6);
  EXPECT_LT(bed.ledger().residual(), 1e-10);
  EXPECT_GE(least_void_fraction(bed.gas()), least_eps);
  const double stokes = 3.0 * pi * scene.input.viscosity * Stream::diameter * Stream::speed;
  return bed.forces()[0] / (stokes * (1.0 + 0.15 * std::pow(reynolds, 0.687)));
}

const Vec3 in_a_cell(0.5, 0.5, 0.5);
const std::array<Vec3, 3> on_a_face_an_edge_a_corner{Vec3(0.0, 0.5, 0.5), Vec3(0.0, 0.0, 0.5),
                                                     Vec3(0.0, 0.0, 0.0)};

// What a grain of the images beside it holds up has to pass between them: creeping gas that is
// driven through feels up to some d / side more.
double law_bound(int side, double reynolds) {
  return reynolds < 1.0 ? 1.0 + 1.0 / side : 1.025;
}

TEST(large_grains, feel_the_drag_of_the_law_in_a_cell_on_a_face_an_edge_and_a_corner) {
  for (const int across : {1, 2, 5})
    for (const double reynolds : {0.5, 20.0}) {
      if (across == 5 && reynolds > 1.0) continue;  // dear, and the easier of the two
      const int side = across == 5 ? 8 : 12;
      const double inside = held_drag(across, side, reynolds, "kernel", in_a_cell);
      EXPECT_GT(inside, 1.0) << across;
      EXPECT_LT(inside, law_bound(side, reynolds)) << across;
      double furthest = 0.0;
      for (const Vec3& place : on_a_face_an_edge_a_corner) {
        if (across == 5 && place[2] != 0.0) continue;  // cells so small that the corner will do
        const double there = held_drag(across, side, reynolds, "kernel", place);
        furthest = std::max(furthest, std::abs(there - inside));
      }
      std::printf("%d cells across, Re %g: %.4f of the law's drag, elsewhere within %.4f\n", across,
                  reynolds, inside, furthest);
      EXPECT_LT(furthest, 0.01) << across;
    }
}

TEST(large_grains, that_ignore_their_own_disturbance_or_see_one_cell_miss_the_law) {
  for (const int across : {1, 2}) {
    const double ignored = held_drag(across, 12, 0.5, "kernel self_disturbance ignored", in_a_cell);
    const double narrow = held_drag(across, 12, 0.5, "trilinear", in_a_cell);
    std::printf(
        "%d cells across, Re 0.5: %.4f of the law's drag with self_disturbance ignored, "
        "%.4f with trilinear\n",
        across, ignored, narrow);
    EXPECT_LT(ignored, 0.93) << across;
    EXPECT_LT(narrow, 0.5) << across;
  }
}

Crossing crossing(int across, const std::string& method) {
  const Crossing met = cross_a_face(1.0 / across, (across == 5 ? 6 : 8) * across,
                                    "drag schiller_naumann void_fraction " + method);
  std::printf("%d cells across, %s: drag jumps by %.4f, eps by %.4f; eps from %.3f\n", across,
              method.c_str(), met.force_jump, met.eps_jump, met.eps_least);
  EXPECT_LT(met.ledger_residual, 1e-10);
  EXPECT_GE(met.eps_least, least_eps);
  EXPECT_LE(met.eps_most, 1.0 + 1e-12);
  return met;
}

TEST(large_grains, cross_a_face_without_a_jump_of_eps_or_drag) {
  for (const int across : {1, 2, 5})
    for (const char* method : {"kernel", "particle_grid"}) {
      const Crossing met = crossing(across, method);
      EXPECT_LT(met.eps_jump, 1e-3);
      EXPECT_LT(met.force_jump, 5e-3);
      EXPECT_LT(met.force_spread, 0.02);
    }
  // Narrower methods move more of the grain, but in proportion to its way: 0.02 of a cell.
  for (const int across : {1, 2})
    for (const char* method : {"exact", "offset", "trilinear"})
      EXPECT_LT(crossing(across, method).eps_jump, 0.05);
}

TEST(large_grains, by_their_centre_alone_break_the_bounds_at_every_face) {
  for (const int across : {1, 2, 5}) {
    const Crossing met = crossing(across, "centre");
    EXPECT_GT(met.eps_jump, 0.5);
    EXPECT_GT(met.force_jump, 0.3);
  }
}

}  // namespace
}  // namespace gasgrain::stability
