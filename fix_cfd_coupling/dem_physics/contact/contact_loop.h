// The loops over contacts of one stack of laws (contact_laws.h), compiled for each stack: grains
// with grains of a host's neighbour list, and grains with a wall.
#pragma once

#include <algorithm>

#include "fix_cfd_coupling/dem_physics/contact/contact_laws.h"

namespace gasgrain::contact {

// How far bodies may be apart to be shown to cohesion: so many times r_i + r_j, or with so wide a
// gap [m], whichever is more. At walls the host's list of near grains says it.
struct Reach {
  double times = 1.0;
  double gap = 0.0;

  [[nodiscard]] double of(double radsum) const { return std::max(times * radsum, radsum + gap); }
};

template <class Laws>
class ContactLoop {
 public:
  Laws laws;
  Reach reach;

  void pairs(const Grains& grains, const NeighbourList& list, const ContactRows& rows,
             ContactObserver* observer) {
    const int width = rows.width;
    for (int n = 0; n < list.count; ++n) {
      const int i = list.grains[n];
      const int* neighbours = list.first[i];
      const int count = list.neighbours[i];
      int* in_use = rows.in_use != nullptr ? rows.in_use[i] : nullptr;
      double* row = rows.values != nullptr ? rows.values[i] : nullptr;
      const Vec3 at(grains.x[i][0], grains.x[i][1], grains.x[i][2]);
      const double radius = grains.radius[i];
      Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
      for (int m = 0; m < count; ++m) {
        const int j = neighbours[m] & list.index;
        const Vec3 delta(at[0] - grains.x[j][0], at[1] - grains.x[j][1], at[2] - grains.x[j][2]);
        const double square = delta.squaredNorm();
        const double sum = radius + grains.radius[j];
        int* use = in_use != nullptr ? in_use + m : nullptr;
        if (square >= sum * sum && !shows(square, sum, use)) continue;
        Push push;
        if (!pair(grains, i, j, delta, square, use, row != nullptr ? row + m * width : nullptr,
                  push))
          continue;
        force += push.force_i;
        torque += push.torque_i;
        if (grains.ghosts_take_forces || j < grains.owned)
          for (int d = 0; d < 3; ++d) {
            grains.force[j][d] += push.force_j[d];
            grains.torque[j][d] += push.torque_j[d];
          }
        if (observer != nullptr) observer->acts(i, j, push.force_i, delta);
      }
      for (int d = 0; d < 3; ++d) {
        grains.force[i][d] += force[d];
        grains.torque[i][d] += torque[d];
      }
    }
  }

  // What a contact does to its grains; false: nothing. `use` and `row` may be null where no law has
  // a history.
  bool pair(const Grains& grains, int i, int j, const Vec3& delta, double square, int* use,
            double* row, Push& push) {
    const double radius_i = grains.radius[i], radius_j = grains.radius[j];
    const double sum = radius_i + radius_j;
    ContactView view;
    if constexpr (shows_views) {
      view.i = i;
      view.j = j;
      view.itype = grains.type[i];
      view.jtype = grains.type[j];
      view.is_wall = false;
      view.owns_j = j < grains.owned;
      view.radi = radius_i;
      view.radj = radius_j;
      view.radsum = sum;
      view.rsq = square;
      view.delta = delta.data();
      view.v_i = grains.v[i];
      view.v_j = grains.v[j];
      view.omega_i = grains.spin[i];
      view.omega_j = grains.spin[j];
      of_grain(grains, view);
      view.keep = use != nullptr && *use != 0;
    }
    if (square >= sum * sum) {
      if (use != nullptr && *use != 0) laws.forget_touch(row);
      const bool acts = laws.apart(view, row, push);
      if (use != nullptr) *use = Laws::has_cohesion && view.keep ? 1 : 0;
      return acts;
    }
    Touch touch;
    touch.distance = std::sqrt(square);
    touch.normal = delta * (1.0 / touch.distance);
    touch.overlap = sum - touch.distance;
    touch.radius_i = radius_i;
    touch.radius_j = radius_j;
    touch.reduced_radius = radius_i * radius_j / sum;
    touch.mass_i = grains.inertia(i);
    touch.mass_j = grains.inertia(j);
    touch.reduced_mass = reduced_mass(grains, i, j, touch);
    touch.spin_i = vec(grains.spin[i]);
    touch.spin_j = vec(grains.spin[j]);
    touch.type_i = grains.type[i];
    touch.type_j = grains.type[j];
    touch.updates = grains.updates;
    touch.step = grains.dt;
    if (use != nullptr) *use = 1;
    laws.touching(touch, vec(grains.v[i]) - vec(grains.v[j]), view, row, push);
    return true;
  }

  void wall(const Grains& grains, const WallNeighbours& near, const PrimitiveWall& shape, int type,
            ContactObserver* observer) {
    for (int n = 0; n < near.count; ++n) {
      const int i = near.grains[n];
      Vec3 delta;
      const double distance = shape.reach(grains.x[i], delta);
      double* row = near.rows != nullptr ? near.rows[i] : nullptr;
      double* use = row != nullptr ? row + laws.places.width : nullptr;
      Push push;
      if (!at_wall(grains, i, shape, type, delta, distance, use, row, push)) continue;
      for (int d = 0; d < 3; ++d) {
        grains.force[i][d] += push.force_i[d];
        grains.torque[i][d] += push.torque_i[d];
      }
      if (observer != nullptr) observer->acts(i, -1, push.force_i, delta);
    }
  }

 private:
  static constexpr bool shows_views = Laws::has_cohesion || Laws::has_rolling;

  // A pair that is apart but concerns somebody: cohesion reaches it, or it has touched.
  [[nodiscard]] bool shows(double square, double sum, const int* use) const {
    if (use != nullptr && *use != 0) return true;
    if constexpr (!Laws::has_cohesion) return false;
    const double far = reach.of(sum);
    return square < far * far;
  }

  static void of_grain(const Grains& grains, ContactView& view) {
    view.updates = grains.updates;
    view.dt = grains.dt;
    view.step = grains.step;
    view.area_ratio = 1.0;
    view.place = 0.0;
    view.parts = nullptr;
    view.acts = false;
  }

  static double reduced_mass(const Grains& grains, int i, int j, const Touch& touch) {
    if (grains.frozen != 0) {
      if ((grains.mask[j] & grains.frozen) != 0) return touch.mass_i;
      if ((grains.mask[i] & grains.frozen) != 0) return touch.mass_j;
    }
    return touch.mass_i * touch.mass_j / (touch.mass_i + touch.mass_j);
  }

  bool at_wall(const Grains& grains, int i, const PrimitiveWall& shape, int type, const Vec3& delta,
               double distance, double* use, double* row, Push& push) {
    const double radius = grains.radius[i];
    const bool apart = distance > radius;
    const bool was_used = use != nullptr && *use != 0.0;
    if (apart && !was_used && !Laws::has_cohesion) return false;
    ContactView view;
    if constexpr (shows_views) {
      view.i = i;
      view.j = -1;
      view.itype = grains.type[i];
      view.jtype = type;
      view.is_wall = true;
      view.owns_j = false;
      view.radi = radius;
      view.radj = 0.0;
      view.radsum = radius;
      view.rsq = distance * distance;
      view.delta = delta.data();
      view.v_i = grains.v[i];
      view.v_j = shape.velocity.data();
      view.omega_i = grains.spin[i];
      view.omega_j = nullptr;
      of_grain(grains, view);
      view.keep = was_used;
    }
    if (apart) {
      if (was_used) laws.forget_touch(row);
      const bool acts = laws.apart(view, row, push);
      if (use != nullptr) *use = Laws::has_cohesion && view.keep ? 1.0 : 0.0;
      return acts;
    }
    Touch touch;
    touch.is_wall = true;
    touch.distance = distance;
    touch.normal = delta * (1.0 / distance);
    touch.overlap = radius - distance;
    touch.radius_i = radius;
    touch.radius_j = 0.0;
    touch.reduced_radius = radius;
    if constexpr (Laws::levers_are_radii)
      if (shape.round) touch.reduced_radius = shape.reduced_radius(grains.x[i], radius);
    touch.mass_i = touch.mass_j = touch.reduced_mass = grains.inertia(i);
    touch.spin_i = vec(grains.spin[i]);
    touch.spin_j.setZero();
    touch.type_i = grains.type[i];
    touch.type_j = type;
    touch.updates = grains.updates;
    touch.step = grains.dt;
    if (use != nullptr) *use = 1.0;
    laws.touching(touch, vec(grains.v[i]) - vec(shape.velocity.data()), view, row, push);
    return true;
  }
};

}  // namespace gasgrain::contact
