#include "gas_solver/pressure/mass_flux.h"

#include "coupling/base/listed.h"
#include "gas_solver/operators/quantity.h"

namespace gasgrain {

void MassFlux::update(GasState& state, const std::vector<InflowFace>& inflow) {
  const Array3<double>& eps = state.void_fraction;
  visit_apart(
      [&](const auto& rho) {
        for (int d = 0; d < 3; ++d) {
          const Array3<double>& u = state.velocity[d];
          Array3<double>& flux = state.mass_flux[d];
          const std::ptrdiff_t s = eps.stride(d);
          IndexBox faces = domain_.inner_faces(d);
          faces.hi[d] = std::max(faces.hi[d], domain_.own().hi[d]);
          for_each_cell(faces, [&](int i, int j, int k) {
            const auto o = eps.offset(i, j, k);
            flux[o] = face_value(rho, o, s) * face_mean(eps, o, s) * u[o];
          });
          for (const bool high : {false, true}) {
            const int side = side_of(d, high);
            const bool open = !sides_[side]->normal_velocity_given;
            for_each_cell(domain_.side_faces(side), [&](int i, int j, int k) {
              const auto o = eps.offset(i, j, k);
              const auto cell = o + inner_cell_offset(side, s);
              flux[o] = open ? rho(cell) * eps[cell] * u[o] : 0.0;
            });
          }
        }
      },
      quantity(state.density, density_));
  for (const InflowFace& face : inflow) {
    const double into = is_high(face.side) ? -1.0 : 1.0;
    const Int3& f = face.face;
    state.mass_flux[axis_of(face.side)](f[0], f[1], f[2]) = into * face.mass_flux;
  }
  halo_.exchange({&state.mass_flux[0], &state.mass_flux[1], &state.mass_flux[2]});
  for (int d = 0; d < 3; ++d) fill_ghost_fluxes(domain_, d, state.mass_flux[d]);
}

SideFlows MassFlux::measure(const GasState& state) const {
  std::vector<double> sums(3, 0.0);  // inflow, outflow, faces of backflow
  const Vec3 h = domain_.grid().spacing();
  for (int side = 0; side < side_count; ++side) {
    const int d = axis_of(side);
    const double area = domain_.grid().cell_volume() / h[d];
    const double outward = is_high(side) ? 1.0 : -1.0;
    const bool open = !sides_[side]->normal_velocity_given;
    for_each_cell(domain_.side_faces(side), [&](int i, int j, int k) {
      const double out = outward * state.mass_flux[d](i, j, k) * area;
      sums[open ? 1 : 0] += open ? out : -out;
      if (open && out < 0) sums[2] += 1;
    });
  }
  domain_.comm().sum_in_place(sums);
  return {sums[0], sums[1], static_cast<long>(sums[2])};
}

}  // namespace gasgrain
