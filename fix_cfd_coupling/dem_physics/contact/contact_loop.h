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

  void pairs(const Grains& of_host, const NeighbourList& list, const ContactRows& rows,
             ContactObserver* observer) {
    const Grains grains = of_host;  // for the compiler: nothing that is written changes it
    const int width = rows.width;
    for (int n = 0; n < list.count; ++n) {
      const int i = list.grains[n];
      const int* neighbours = list.first[i];
      const int count = list.neighbours[i];
      int* in_use = rows.in_use != nullptr ? rows.in_use[i] : nullptr;
      double* row = rows.values != nullptr ? rows.values[i] : nullptr;
      const Triple at = Triple::of(grains.x[i]);
      const double radius = grains.radius[i];
      Triple force, torque;
      for (int m = 0; m < count; ++m) {
        const int j = neighbours[m] & list.index;
        const Triple delta = at - Triple::of(grains.x[j]);
        const double square = delta.dot(delta);
        const double sum = radius + grains.radius[j];
        int* use = Laws::remembers_touch || in_use != nullptr ? in_use + m : nullptr;
        if (square >= sum * sum && !shows(square, sum, use)) continue;
        Push push;
        if (!pair(grains, i, j, delta, square, use,
                  Laws::remembers_touch || row != nullptr ? row + m * width : nullptr, push))
          continue;
        force += push.force_i;
        torque += push.torque_i;
        if (grains.ghosts_take_forces || j < grains.owned) {
          if constexpr (Laws::has_cohesion)
            push.force_j.add_to(grains.force[j]);
          else
            (-push.force_i).add_to(grains.force[j]);
          push.torque_j.add_to(grains.torque[j]);
        }
        if (observer != nullptr) tell(*observer, i, j, push.force_i, delta);
      }
      force.add_to(grains.force[i]);
      torque.add_to(grains.torque[i]);
    }
  }

  // What a contact does to its grains; false: nothing. `use` and `row` may be null where no law has
  // a history.
  [[gnu::always_inline]] inline bool pair(const Grains& grains, int i, int j, const Triple& delta,
                                          double square, int* use, double* row, Push& push) {
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
    touch.normal = (1.0 / touch.distance) * delta;
    touch.overlap = sum - touch.distance;
    touch.radius_i = radius_i;
    touch.radius_j = radius_j;
    touch.reduced_radius = radius_i * radius_j / sum;
    touch.mass_i = grains.inertia(i);
    touch.mass_j = grains.inertia(j);
    touch.reduced_mass = reduced_mass(grains, i, j, touch);
    touch.spin_i = Triple::of(grains.spin[i]);
    touch.spin_j = Triple::of(grains.spin[j]);
    touch.types = laws.tangential.place(grains.type[i], grains.type[j]);
    touch.updates = grains.updates;
    touch.step = grains.dt;
    if (Laws::remembers_touch || use != nullptr) *use = 1;
    laws.touching(touch, Triple::of(grains.v[i]) - Triple::of(grains.v[j]), view, row, push);
    return true;
  }

  void wall(const Grains& grains, const WallNeighbours& near, const PrimitiveWall& shape, int type,
            ContactObserver* observer) {
    for (int n = 0; n < near.count; ++n) {
      const int i = near.grains[n];
      Triple delta;
      const double distance = shape.reach(grains.x[i], delta);
      double* row = near.rows != nullptr ? near.rows[i] : nullptr;
      const bool was_in_use = row != nullptr && near.is_in_use(n, laws.places.width);
      bool in_use = was_in_use;
      Push push;
      const bool acts = at_wall(grains, i, shape, type, delta, distance, in_use, row, push);
      if (row != nullptr && in_use != was_in_use) near.set_in_use(n, laws.places.width, in_use);
      if (!acts) continue;
      push.force_i.add_to(grains.force[i]);
      push.torque_i.add_to(grains.torque[i]);
      if (observer != nullptr) observer->acts(i, -1, push.force_i, delta);
    }
  }

 private:
  // By value: what an unknown function could see would have to be kept in memory.
  [[gnu::noinline]] static void tell(ContactObserver& observer, int i, int j, Triple force,
                                     Triple delta) {
    observer.acts(i, j, force, delta);
  }

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

  bool at_wall(const Grains& grains, int i, const PrimitiveWall& shape, int type,
               const Triple& delta, double distance, bool& in_use, double* row, Push& push) {
    const double radius = grains.radius[i];
    const bool apart = distance > radius;
    if (apart && !in_use && !Laws::has_cohesion) return false;
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
      view.keep = in_use;
    }
    if (apart) {
      if (in_use) laws.forget_touch(row);
      const bool acts = laws.apart(view, row, push);
      in_use = Laws::has_cohesion && view.keep;
      return acts;
    }
    Touch touch;
    touch.is_wall = true;
    touch.distance = distance;
    touch.normal = (1.0 / distance) * delta;
    touch.overlap = radius - distance;
    touch.radius_i = radius;
    touch.radius_j = 0.0;
    touch.reduced_radius = radius;
    if constexpr (Laws::levers_are_radii)
      if (shape.round) touch.reduced_radius = shape.reduced_radius(grains.x[i], radius);
    touch.mass_i = touch.mass_j = touch.reduced_mass = grains.inertia(i);
    touch.spin_i = Triple::of(grains.spin[i]);
    touch.types = laws.tangential.place(grains.type[i], type);
    touch.updates = grains.updates;
    touch.step = grains.dt;
    in_use = true;
    laws.touching(touch, Triple::of(grains.v[i]) - Triple::of(shape.velocity.data()), view, row,
                  push);
    return true;
  }
};

}  // namespace gasgrain::contact
