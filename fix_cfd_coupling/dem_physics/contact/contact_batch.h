// The loop over contacts of grains for several contacts at once (lanes.h), for laws without
// cohesion. It gives the forces of ContactLoop::pairs() but for the order of sums and round-off.
//
// Pairs that touch are queued, without a branch on whether they do; a full queue is computed,
// several contacts in each instruction, and what comes of it is added to the grains one contact
// after the other: the order is that of the list, whatever the number of lanes. A queue holds
// contacts of one pair of types, whose constants are the same in all lanes.
//
// Only files that are compiled for an instruction set include this.
#pragma once

#include "fix_cfd_coupling/dem_physics/contact/batch_loop.h"
#include "fix_cfd_coupling/dem_physics/contact/contact_laws.h"
#include "fix_cfd_coupling/dem_physics/contact/lanes.h"

namespace gasgrain::contact {

template <class Isa, class Laws>
class ContactBatch {
 public:
  ContactBatch(Laws& laws, ContactQueue* queues, const Grains& grains, ContactObserver* observer)
      : laws_(laws), queues_(queues), grains_(grains), observer_(observer) {}

  void pairs(const NeighbourList& list, const ContactRows& rows) {
    if (laws_.tangential.types() == 1)
      find_contacts<true>(list, rows);
    else
      find_contacts<false>(list, rows);
  }

  // Grains near to the wall are far apart in memory: what a contact needs is asked for when the
  // contact is found, and has come when it is computed.
  void wall(const WallNeighbours& near, const PrimitiveWall& shape, int type) {
    wall_ = &shape;
    for (int n = 0; n < near.count; ++n) {
      const int i = near.grains[n];
      Triple to_grain;
      const double radius = grains_.radius[i];
      const bool touch = shape.reach(grains_.x[i], to_grain) <= radius;
      ContactQueue& queue = queues_[laws_.tangential.place(grains_.type[i], type)];
      const int last = queue.count;
      queue.i[last] = queue.j[last] = i;
      quad(queue.delta[last]) = Quad{to_grain.x, to_grain.y, to_grain.z, radius};
      if constexpr (width > 0) {
        double* row = near.rows[i];
        queue.row[last] = row;
        const bool was_in_use = near.is_in_use(n, width);
        if (was_in_use && !touch) laws_.forget_touch(row);
        if (was_in_use != touch) near.set_in_use(n, width, touch);
      }
      if (touch) ask_for(i);
      queue.count = last + static_cast<int>(touch);
      if (__builtin_expect(queue.count == ContactQueue::capacity, 0)) compute(queue, queue.count);
    }
    compute_rest();
  }

 private:
  using Real = Lanes<Isa>;
  static constexpr int lanes = Isa::lanes;
  static constexpr int width = Laws::remembered;

  [[gnu::always_inline]] static inline Quad& quad(double* of) {
    return *reinterpret_cast<Quad*>(of);
  }
  [[gnu::always_inline]] static inline const Quad& quad(const double* of) {
    return *reinterpret_cast<const Quad*>(of);
  }

  template <bool of_one_type>
  [[gnu::noinline]] void find_contacts(const NeighbourList& list, const ContactRows& rows) {
    const Grains::Vectors x = grains_.x;
    const double* const radius = grains_.radius;
    const int row_width = rows.width;
    const int index = list.index;
    ContactQueue* queue = queues_ + laws_.tangential.place(1, 1);
    int last = 0;
    for (int n = 0; n < list.count; ++n) {
      const int i = list.grains[n];
      const int* neighbours = list.first[i];
      const int number = list.neighbours[i];
      [[maybe_unused]] int* in_use = width > 0 ? rows.in_use[i] : nullptr;
      [[maybe_unused]] double* row = width > 0 ? rows.values[i] : nullptr;
      const Quad at = quad_of(x[i], radius[i]);
      for (int m = 0; m < number; ++m) {
        const int j = neighbours[m] & index;
        const Quad delta = at + quad_of(x[j], radius[j]) * Quad{-1.0, -1.0, -1.0, 1.0};
        const Quad squares = delta * delta;
        const bool touch = squares[0] + squares[1] + squares[2] < squares[3];
        if constexpr (!of_one_type) {
          queue = queues_ + laws_.tangential.place(grains_.type[i], grains_.type[j]);
          last = queue->count;
        }
        queue->i[last] = i;
        queue->j[last] = j;
        quad(queue->delta[last]) = delta;
        if constexpr (width > 0) {
          queue->row[last] = row;
          if (__builtin_expect(static_cast<int>(touch) < in_use[m], 0)) laws_.forget_touch(row);
          in_use[m] = static_cast<int>(touch);
          row += row_width;
        }
        last += static_cast<int>(touch);
        if constexpr (!of_one_type) queue->count = last;
        if (__builtin_expect(last == ContactQueue::capacity, 0)) {
          compute(*queue, last);
          last = 0;
        }
      }
    }
    if constexpr (of_one_type) queue->count = last;
    compute_rest();
  }

  void compute_rest() {
    const int types = laws_.tangential.types();
    for (int a = 1; a <= types; ++a)
      for (int b = 1; b <= types; ++b) {
        ContactQueue& rest = queues_[laws_.tangential.place(a, b)];
        compute(rest, rest.count);
      }
  }

  [[gnu::always_inline]] inline void ask_for(int i) const {
    __builtin_prefetch(grains_.v[i]);
    __builtin_prefetch(grains_.spin[i]);
    __builtin_prefetch(grains_.mass + i);
    __builtin_prefetch(grains_.force[i], 1);
    __builtin_prefetch(grains_.torque[i], 1);
  }

  [[gnu::noinline]] void compute(ContactQueue& queue, int count) {
    queue.count = 0;
    // The lanes beyond the end compute the last contact again, which nobody reads.
    for (int k = count; k % lanes != 0; ++k) {
      queue.i[k] = queue.i[count - 1];
      queue.j[k] = queue.j[count - 1];
      if constexpr (width > 0) queue.row[k] = queue.row[count - 1];
      quad(queue.delta[k]) = quad(queue.delta[count - 1]);
    }
    for (int k = 0; k < count; k += lanes) compute(queue, k, count - k < lanes ? count - k : lanes);
  }

  // 1 of a grain that never moves.
  [[gnu::always_inline]] inline double frozen(int k) const {
    return grains_.frozen != 0 && (grains_.mask[k] & grains_.frozen) != 0 ? 1.0 : 0.0;
  }

  [[gnu::always_inline]] inline void gather(const ContactQueue& queue, int begin,
                                            TouchOf<Real>& touch, TripleOf<Real>& velocity) {
    Quad quads[lanes];
    Real columns[4];
    for (int k = 0; k < lanes; ++k) quads[k] = quad(queue.delta[begin + k]);
    columns_of(quads, columns);
    const TripleOf<Real> delta{columns[0], columns[1], columns[2]};
    const Real sum = columns[3];
    // Those who found the contact rounded otherwise: one that grazes must not be apart.
    const Real distance = delta.norm();
    touch.distance = select(distance < sum, distance, sum);
    touch.normal = (1.0 / touch.distance) * delta;
    touch.overlap = sum - touch.distance;

    const int* i = queue.i + begin;
    const int* j = queue.j + begin;
    if (wall_ != nullptr) {
      gather_at_wall(i, sum, touch, velocity);
      return;
    }
    for (int k = 0; k < lanes; ++k) touch.radius_i.of[k] = grains_.radius[i[k]];
    touch.radius_j = sum - touch.radius_i;
    touch.reduced_radius = touch.radius_i * touch.radius_j / sum;

    for (int k = 0; k < lanes; ++k) quads[k] = quad_of(grains_.v[i[k]], grains_.inertia(i[k]));
    columns_of(quads, columns);
    velocity = {columns[0], columns[1], columns[2]};
    touch.mass_i = columns[3];
    for (int k = 0; k < lanes; ++k) quads[k] = quad_of(grains_.v[j[k]], grains_.inertia(j[k]));
    columns_of(quads, columns);
    velocity -= {columns[0], columns[1], columns[2]};
    touch.mass_j = columns[3];

    touch.reduced_mass = touch.mass_i * touch.mass_j / (touch.mass_i + touch.mass_j);
    for (int k = 0; k < lanes; ++k) quads[k] = quad_of(grains_.spin[i[k]], frozen(i[k]));
    columns_of(quads, columns);
    touch.spin_i = {columns[0], columns[1], columns[2]};
    if (grains_.frozen != 0)
      touch.reduced_mass = select(columns[3] > 0.0, touch.mass_j, touch.reduced_mass);
    for (int k = 0; k < lanes; ++k) quads[k] = quad_of(grains_.spin[j[k]], frozen(j[k]));
    columns_of(quads, columns);
    touch.spin_j = {columns[0], columns[1], columns[2]};
    if (grains_.frozen != 0)
      touch.reduced_mass = select(columns[3] > 0.0, touch.mass_i, touch.reduced_mass);
  }

  [[gnu::always_inline]] inline void gather_at_wall(const int* i, const Real& radius,
                                                    TouchOf<Real>& touch,
                                                    TripleOf<Real>& velocity) {
    Quad quads[lanes];
    Real columns[4];
    touch.is_wall = true;
    touch.radius_i = touch.reduced_radius = radius;
    if constexpr (Laws::levers_are_radii)
      if (wall_->round)
        for (int k = 0; k < lanes; ++k)
          touch.reduced_radius.of[k] = wall_->reduced_radius(grains_.x[i[k]], radius.of[k]);
    for (int k = 0; k < lanes; ++k) quads[k] = quad_of(grains_.v[i[k]], grains_.inertia(i[k]));
    columns_of(quads, columns);
    velocity = {columns[0] - wall_->velocity[0], columns[1] - wall_->velocity[1],
                columns[2] - wall_->velocity[2]};
    touch.mass_i = touch.mass_j = touch.reduced_mass = columns[3];
    for (int k = 0; k < lanes; ++k) quads[k] = quad_of(grains_.spin[i[k]], 0.0);
    columns_of(quads, columns);
    touch.spin_i = {columns[0], columns[1], columns[2]};
  }

  [[gnu::always_inline]] inline void read_rows(double* const* row, Real* stored) {
    Quad quads[lanes];
    Real columns[4];
    for (int from = 0; from < width; from += 3) {
      for (int k = 0; k < lanes; ++k)
        quads[k] = Quad{row[k][from], row[k][from + 1], row[k][from + 2], 0.0};
      columns_of(quads, columns);
      for (int d = 0; d < 3; ++d) stored[from + d] = columns[d];
    }
  }
  [[gnu::always_inline]] inline void write_rows(double* const* row, const Real* stored, int count) {
    Quad quads[lanes];
    for (int from = 0; from < width; from += 3) {
      const Real columns[4] = {stored[from], stored[from + 1], stored[from + 2], 0.0};
      quads_of(columns, quads);
      for (int k = 0; k < count; ++k)
        for (int d = 0; d < 3; ++d) row[k][from + d] = quads[k][d];
    }
  }

  [[gnu::always_inline]] inline void compute(const ContactQueue& queue, int begin, int count) {
    TouchOf<Real> touch;
    TripleOf<Real> velocity;
    gather(queue, begin, touch, velocity);
    touch.updates = grains_.updates;
    touch.step = grains_.dt;
    touch.types = static_cast<std::size_t>(&queue - queues_);
    if constexpr (prepares<decltype(laws_.normal)>)
      for (int k = 0; k < lanes; ++k)
        touch.prepared.of[k] =
            laws_.normal.prepare(touch.reduced_radius.of[k], touch.reduced_mass.of[k], touch.types);
    Real stored[width + 1];
    read_rows(queue.row + begin, stored);
    TripleOf<Real> force, torque_i, torque_j;
    laws_.touching_in_lanes(touch, velocity, stored, force, torque_i, torque_j);
    write_rows(queue.row + begin, stored, count);

    Quad pushes[lanes], twists_i[lanes], twists_j[lanes];
    quads_of({force.x, force.y, force.z, 0.0}, pushes);
    quads_of({torque_i.x, torque_i.y, torque_i.z, 0.0}, twists_i);
    quads_of({torque_j.x, torque_j.y, torque_j.z, 0.0}, twists_j);
    for (int k = 0; k < count; ++k) {
      const int i = queue.i[begin + k], j = queue.j[begin + k];
      add_to(grains_.force[i], pushes[k]);
      add_to(grains_.torque[i], twists_i[k]);
      if (wall_ != nullptr) continue;
      if (grains_.ghosts_take_forces || j < grains_.owned) {
        add_to(grains_.force[j], -pushes[k]);
        add_to(grains_.torque[j], twists_j[k]);
      }
    }
    if (observer_ == nullptr) return;
    for (int k = 0; k < count; ++k) {
      const double* delta = queue.delta[begin + k];
      observer_->acts(queue.i[begin + k], wall_ != nullptr ? -1 : queue.j[begin + k],
                      {pushes[k][0], pushes[k][1], pushes[k][2]}, {delta[0], delta[1], delta[2]});
    }
  }

  Laws& laws_;
  ContactQueue* queues_;
  const Grains grains_;
  ContactObserver* observer_;
  const PrimitiveWall* wall_ = nullptr;  // in the place of all j
};

template <class Isa, class Laws>
void pairs_in_lanes(Laws& laws, ContactQueue* queues, const Grains& grains,
                    const NeighbourList& list, const ContactRows& rows, ContactObserver* observer) {
  ContactBatch<Isa, Laws>(laws, queues, grains, observer).pairs(list, rows);
}

template <class Isa, class Laws>
void wall_in_lanes(Laws& laws, ContactQueue* queues, const Grains& grains,
                   const WallNeighbours& near, const PrimitiveWall& shape, int type,
                   ContactObserver* observer) {
  ContactBatch<Isa, Laws>(laws, queues, grains, observer).wall(near, shape, type);
}

}  // namespace gasgrain::contact
