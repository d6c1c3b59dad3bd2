// Exact method: each cell has the part of the sphere that lies in it.
//
//   w(i, j, k) = (volume of the sphere within the cell) / (volume of the sphere)
//
// Source: eq 7.2 of F. Alobaid, thesis, TU Darmstadt (2013), after Hoomans et al. (1996), which
//   calls it the most accurate and too expensive; the volumes are those of sphere_box_overlap.h.
// Inputs: position [m], radius r [m]. Output: dimensionless weights, positive, sum 1, each right to
//   1e-14 for a position known that well in radii: a coordinate of n cells is rounded to 1e-16 n
//   cells.
// Assumptions: spheres do not overlap; else eps counts what they share twice. Walls are planes of
//   the box.
// Valid range: any size of cells against particles. The weights are continuous in position: when a
//   sphere touches a face, the part beyond it grows with the square of its depth.
// Walls: the cell at a wall has no outer face but reaches on to infinity, and so has all of the
//   sphere that lies beyond it, edges and corners of the box included. Nothing is cut off.
//
// The sphere's bounding box is cut by the faces of the cells into a grid of corners. Each pair of
// faces has its wedge found once, and each corner its volume; a cell is a difference of eight.
// Where just one face cuts the sphere this is the cap's formula, and without one the weight is 1.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "coupling/base/tile_frame.h"
#include "coupling/exchange/void_fraction/sphere_box_overlap.h"

namespace gasgrain {

struct VoidFractionExact {
  static constexpr std::string_view name = "exact";
  static constexpr double greatest_jump = 0.0;

  static int reach(const BoxGrid& grid, int axis, double radius) {
    return static_cast<int>(std::ceil(radius / grid.spacing()[axis]));
  }

  template <class F>
  static void for_each_weight(const TileFrame& frame, const Vec3& x, double radius, F&& f) {
    Int3 first;
    Int3 n;  // cells
    Vec3 s;
    Vec3 r;
    for (int d = 0; d < 3; ++d) {
      s[d] = frame.in_cells(x[d], d);
      r[d] = frame.length_in_cells(radius, d);
      first[d] = frame.cell(s[d] - r[d] * without_dust, d);
      n[d] = frame.cell(s[d] + r[d] * without_dust, d) - first[d] + 1;
    }
    if (n[0] * n[1] * n[2] == 1) {
      f(first[0], first[1], first[2], 1.0);
      return;
    }
    if (n[0] <= small && n[1] <= small && n[2] <= small) {
      SmallStore store;
      cut_into_cells(store, first, n, s, r, f);
    } else {
      LargeStore store(n);
      cut_into_cells(store, first, n, s, r, f);
    }
  }

 private:
  // A cap so flat that it is no part of the sphere in double precision is left to the cell before:
  // round-off then cannot make a sphere touch one cell more than its reach.
  static constexpr double without_dust = 1.0 - 1e-9;
  static constexpr int small = 3;  // cells along an axis whose tables are kept on the stack

  struct SmallStore {
    std::array<std::array<SphereCut, small + 1>, 3> cut;
    std::array<std::array<double, (small + 1) * (small + 1)>, 3> wedge;
    std::array<double, (small + 1) * (small + 1) * (small + 1)> corner;
  };
  struct LargeStore {
    explicit LargeStore(const Int3& n)
        : corner(static_cast<std::size_t>(n[0] + 1) * (n[1] + 1) * (n[2] + 1)) {
      for (int d = 0; d < 3; ++d) {
        cut[d].resize(n[d] + 1);
        wedge[d].resize(static_cast<std::size_t>(n[(d + 1) % 3] + 1) * (n[(d + 2) % 3] + 1));
      }
    }
    std::array<std::vector<SphereCut>, 3> cut;
    std::array<std::vector<double>, 3> wedge;
    std::vector<double> corner;
  };

  template <class Store, class F>
  static void cut_into_cells(Store& store, const Int3& first, const Int3& n, const Vec3& s,
                             const Vec3& r, F& f) {
    for (int d = 0; d < 3; ++d) {
      store.cut[d][0] = sphere_cut(-1.0);
      for (int m = 1; m < n[d]; ++m) store.cut[d][m] = sphere_cut((first[d] + m - s[d]) / r[d]);
      store.cut[d][n[d]] = sphere_cut(1.0);
    }
    const auto& [cut_x, cut_y, cut_z] = store.cut;
    // The wedges of the two axes after d, the first of them running fastest; the outermost planes
    // touch the sphere and have none.
    for (int d = 0; d < 3; ++d) {
      const int a = (d + 1) % 3;
      const int b = (d + 2) % 3;
      double* wedge = store.wedge[d].data();
      std::fill_n(wedge, (n[a] + 1) * (n[b] + 1), 0.0);
      for (int l = 1; l < n[b]; ++l)
        for (int m = 1; m < n[a]; ++m)
          wedge[m + (n[a] + 1) * l] = half_wedge(store.cut[a][m], store.cut[b][l]);
    }
    double* corner = store.corner.data();
    for (int k = 0; k <= n[2]; ++k)
      for (int j = 0; j <= n[1]; ++j) {
        const double wedge_yz = store.wedge[0][j + (n[1] + 1) * k];
        for (int i = 0; i <= n[0]; ++i)
          *corner++ = corner_volume(
              cut_x[i], cut_y[j], cut_z[k],
              wedge_yz + store.wedge[1][k + (n[2] + 1) * i] + store.wedge[2][i + (n[0] + 1) * j]);
      }

    const int row = n[0] + 1;
    const int layer = row * (n[1] + 1);
    const double share = 3.0 / (4.0 * pi);
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i) {
          if (nearest(cut_x[i], cut_x[i + 1]) + nearest(cut_y[j], cut_y[j + 1]) +
                  nearest(cut_z[k], cut_z[k + 1]) >=
              1.0)
            continue;
          const double* c = store.corner.data() + i + row * j + layer * k;
          const double volume =
              ((c[1 + row + layer] - c[row + layer]) - (c[1 + layer] - c[layer])) -
              ((c[1 + row] - c[row]) - (c[1] - c[0]));
          // Of a sliver at an edge of the cell round-off may leave less than nothing.
          if (volume > 0.0) f(first[0] + i, first[1] + j, first[2] + k, share * volume);
        }
  }

  // The square of the least distance from the centre to what is between two planes.
  static double nearest(const SphereCut& below, const SphereCut& above) {
    return below.at > 0.0 ? below.square : above.at < 0.0 ? above.square : 0.0;
  }
};

}  // namespace gasgrain
