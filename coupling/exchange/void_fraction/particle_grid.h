// Particle-grid method: solids are shared among blocks of gas cells that are some diameters wide,
// and spread evenly over the cells of a block.
//
//   w(cell) = (volume of the cube about the particle within the block) / (volume of the cube)
//             / (cells of the block)
//
// Along an axis a block has n = round(SIZE d / h) gas cells, at least one, SIZE = `size` in
// diameters d, and the cube is n cells wide. Where the axis is no multiple of n the blocks are as
// equal as can be, none less than n: block b of B begins at cell floor(b cells / B). Between blocks
// of n cells the shares are the linear weights of the blocks' centres.
//
// Source: F. Alobaid, thesis, TU Darmstadt (2013), section 8.1.3, eqs 8.3 to 8.5; the cube is that
//   of J.M. Link, Development and Validation of a Discrete Particle Model of a Spout-fluid Bed
//   Granulator (2006), as told there.
// Inputs: position [m], diameter [m], the greatest in the bed at the first coupling. Output:
//   dimensionless weights, positive, sum 1.
// Valid range: any size of cells; where h > SIZE d / 1.5 the blocks are cells and the weights
//   trilinear. They are continuous in position; the void fraction has steps between blocks.
// Default size 2.5: the middle of the two to three diameters that the thesis recommends.
// Walls: what of the cube is beyond a wall counts for the block at the wall.
// Same as the thesis: the particles see the mean of a block's cells (eq 8.3), linear between blocks
//   (eq 8.4); a block's cells are given equal parts (eq 8.5).
// Deviations: what particles give is shared with the weights with which they see the gas, so that
//   one is the adjoint of the other; the thesis collects it by the offset method. Eq 8.5 divides by
//   n for the void fraction, too; that is right for volumes and forces, and a void fraction is the
//   same in the block and its cells. The thesis takes gradients on blocks, here they are means of
//   the cells' own.
#pragma once

#include <string_view>

#include "coupling/base/axis_weights.h"
#include "coupling/base/tile_frame.h"
#include "coupling/exchange/separable_spread.h"

namespace gasgrain {

// The cells of an axis cut into blocks. Unwrapped indices: along a periodic axis they go on.
struct AxisBlocks {
  int cells = 1;
  int blocks = 1;

  AxisBlocks() = default;
  AxisBlocks(int cells_of_axis, int least)
      : cells(cells_of_axis), blocks(std::max(1, cells_of_axis / least)) {}

  [[nodiscard]] int first_cell(int block) const {
    const int period = floor_of(block, blocks);
    return period * cells + (block - period * blocks) * cells / blocks;
  }
  [[nodiscard]] int block_of(int cell) const {
    const int period = floor_of(cell, cells);
    return period * blocks + ((cell - period * cells + 1) * blocks - 1) / cells;
  }
  [[nodiscard]] int greatest() const { return (cells + blocks - 1) / blocks; }

 private:
  static int floor_of(int a, int n) {
    if (a >= 0 && a < n) return 0;  // in most cases; divisions are slow
    return a >= 0 ? a / n : -((n - 1 - a) / n);
  }
};

struct VoidFractionParticleGrid {
  static constexpr std::string_view name = "particle_grid";
  static constexpr double greatest_jump = 0.0;
  static constexpr double default_size = 2.5;

  double size = default_size;  // in diameters
  double diameter = 0.0;       // [m]; 0: twice the radius asked about

  // Cells along the cube's edge.
  [[nodiscard]] int cube(const BoxGrid& grid, int axis, double radius) const {
    const double edge = size * (diameter > 0.0 ? diameter : 2.0 * radius);
    const double n = std::round(edge * grid.cells[axis] / (grid.hi[axis] - grid.lo[axis]));
    return static_cast<int>(std::clamp(n, 1.0, static_cast<double>(grid.cells[axis])));
  }
  [[nodiscard]] AxisBlocks blocks(const BoxGrid& grid, int axis, double radius) const {
    return {grid.cells[axis], cube(grid, axis, radius)};
  }

  // All of the particle's block and of the next.
  [[nodiscard]] int reach(const BoxGrid& grid, int axis, double radius) const {
    return 2 * blocks(grid, axis, radius).greatest() - 1;
  }

  // The points that are spread are the blocks.
  [[nodiscard]] IndexRange points(const BoxGrid& grid, int axis, double radius,
                                  IndexRange cells) const {
    const AxisBlocks axis_blocks = blocks(grid, axis, radius);
    return {axis_blocks.block_of(cells.lo), axis_blocks.block_of(cells.hi - 1) + 1};
  }
  template <class F>
  void for_each_weight(const TileFrame& frame, const Vec3& x, double radius, F&& f) const {
    std::array<AxisWeights, 3> axes;
    for (int d = 0; d < 3; ++d) {
      const int n = cube(frame.grid, d, radius);
      const AxisBlocks axis_blocks(frame.grid.cells[d], n);
      const double s = frame.in_cells(x[d], d);
      const double end = s + 0.5 * n;
      const int first = axis_blocks.block_of(frame.cell(s - 0.5 * n, d));
      // No block is narrower than the cube, which therefore meets one face at most.
      const int face = axis_blocks.first_cell(first + 1);
      const double beyond = (end - face) / n;
      const bool both = beyond > 0.0 && frame.cell(end, d) >= face;
      axes[d].add(first, both ? 1.0 - beyond : 1.0);
      if (both) axes[d].add(first + 1, beyond);
    }
    for_each_product(axes, f);
  }

  [[nodiscard]] AxisSpread spread(const BoxGrid& grid, int axis, double radius,
                                  IndexRange points) const {
    const AxisBlocks axis_blocks = blocks(grid, axis, radius);
    AxisSpread spread(points,
                      {axis_blocks.first_cell(points.lo), axis_blocks.first_cell(points.hi)});
    for (int block = points.lo; block < points.hi; ++block) {
      const int from = axis_blocks.first_cell(block);
      const int to = axis_blocks.first_cell(block + 1);
      for (int cell = from; cell < to; ++cell) spread.add(cell, block, 1.0 / (to - from));
    }
    return spread;
  }
};

}  // namespace gasgrain
