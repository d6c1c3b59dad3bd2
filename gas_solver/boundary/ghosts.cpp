#include "gas_solver/boundary/ghosts.h"

namespace gasgrain {
namespace {

// What the layers outside take from the value inside.
struct Mirror {
  double factor = 1.0;
  double addend = 0.0;
};

// Mirrors the layer `first` of an axis over the layers outside of it.
void repeat_outwards(Array3<double>& field, int side, int first, const Mirror& mirror) {
  const int axis = axis_of(side);
  const IndexBox box = field.box();
  IndexBox ghosts = box;
  (is_high(side) ? ghosts.lo : ghosts.hi)[axis] = is_high(side) ? first + 1 : first;
  const std::ptrdiff_t stride = field.stride(axis);
  for_each_cell(ghosts, [&](int i, int j, int k) {
    const auto o = field.offset(i, j, k);
    const int n = axis == 0 ? i : (axis == 1 ? j : k);
    field[o] = mirror.factor * field[o + (first - n) * stride] + mirror.addend;
  });
}

template <class MirrorOfSide>
void fill(const Domain& domain, int component, Array3<double>& field, MirrorOfSide&& mirror) {
  for (int side = 0; side < side_count; ++side) {
    if (!domain.touches(side)) continue;
    const int axis = axis_of(side);
    const int last = axis == component ? domain.own().hi[axis] : domain.own().hi[axis] - 1;
    repeat_outwards(field, side, is_high(side) ? last : domain.own().lo[axis],
                    axis == component ? Mirror{} : mirror(side));
  }
}

}  // namespace

void fill_ghost_cells(const Domain& domain, Array3<double>& cells) {
  fill(domain, -1, cells, [](int) { return Mirror{}; });
}

void fill_ghost_velocities(const Domain& domain, const Walls& walls, int component,
                           Array3<double>& velocity) {
  fill(domain, component, velocity, [&](int side) {
    return walls.sides[side]->sticks ? Mirror{-1.0, 2.0 * walls.velocity[side][component]}
                                     : Mirror{};
  });
}

void fill_parabolic_velocities(const Domain& domain, const Walls& walls, int component,
                               Array3<double>& velocity) {
  for (int side = 0; side < side_count; ++side) {
    const int axis = axis_of(side);
    if (!domain.touches(side) || !walls.sides[side]->sticks || axis == component ||
        domain.grid().cells[axis] == 1)
      continue;
    const double wall = walls.velocity[side][component];
    const std::ptrdiff_t in = inward(side, velocity.stride(axis));
    IndexBox layer = velocity.box();
    layer.lo[axis] = is_high(side) ? domain.own().hi[axis] : domain.own().lo[axis] - 1;
    layer.hi[axis] = layer.lo[axis] + 1;
    for_each_cell(layer, [&](int i, int j, int k) {
      const auto o = velocity.offset(i, j, k);
      velocity[o] = velocity[o + 2 * in] / 3.0 - 2.0 * velocity[o + in] + 8.0 / 3.0 * wall;
    });
  }
}

void fill_ghost_fluxes(const Domain& domain, int component, Array3<double>& flux) {
  fill(domain, component, flux, [](int) { return Mirror{}; });
}

}  // namespace gasgrain
