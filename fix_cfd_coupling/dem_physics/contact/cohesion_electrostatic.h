// `cohesion electrostatic`: forces of charged grains on each other and to a wall
// (dem_physics/adhesion/electrostatic.h has the laws, their units, signs and range).
//
// Charges [C]: the grains' property electricCharge, with values sent to the ghosts (LIGGGHTS:
//   `fix ID all property/atom electricCharge scalar RESTART yes no Q`); without it, the charge of
//   an atom style that has one.
// Words: greatest_gap [m], to which charges act (no default: the force has no end of its own);
//   medium_permittivity 1, wall_permittivity inf (a conductor; 1: no image), wall_charge [C/m2] 0,
//   breakdown_field [V/m] 3e6, tangential_reduce off.
// A wall, also one of a mesh, is a plane through the nearest point. Grains charged beyond the
// breakdown are counted and warned of when a run begins; their charge stays.
#ifdef COHESION_LAW
COHESION_LAW(CohesionElectrostatic, electrostatic, 22)
#else
#ifndef GASGRAIN_COHESION_ELECTROSTATIC_H
#define GASGRAIN_COHESION_ELECTROSTATIC_H

#include <algorithm>
#include <cmath>

#include "fix_cfd_coupling/dem_physics/adhesion/electrostatic.h"
#include "fix_cfd_coupling/dem_physics/contact/cohesion_law.h"

namespace gasgrain::contact {

class CohesionElectrostatic : public CentralCohesionLaw {
 public:
  void words(LawWords& words) {
    CentralCohesionLaw::words(words);
    words.number("greatest_gap", greatest_gap_, 0.0);
    words.number("medium_permittivity", law_.medium_permittivity, 1.0);
    words.number("wall_permittivity", law_.wall_permittivity, adhesion::conductor);
    words.number("wall_charge", law_.wall_charge, 0.0);
    words.number("breakdown_field", law_.breakdown_field, 3e6);
  }

  void connect(ContactHost& host) {
    host_ = &host;
    host.refuse_unfit_run();
    try {
      InputFaults("The reach of charges")
          .positive(
              "greatest_gap", greatest_gap_, "m",
              "give it after the model's name, some 10 radii, where the force of two grains is "
              "1/36 of that at touch")
          .refuse();
      check(law_);
    } catch (const Error& fault) {
      host.refuse(fault.what());
    }
    find_charges(host);
    warn_of_breakdown(host);
    host.reach(greatest_gap_);
  }

  void begin_pass() {
    if (sends_) host_->send_to_ghosts(charges_);
  }
  void touching(ContactView& c, const ContactForces& f) { pull_touching(attraction(c), c, f); }
  void apart(ContactView& c, const ContactForces& f) { pull_apart(attraction(c), c, f); }

 private:
  [[nodiscard]] double attraction(const ContactView& c) const {
    if (c.gap() > greatest_gap_) return 0.0;
    const double* q = *charges_.values;
    if (c.is_wall) return law_.to_wall(q[c.i], c.radi, c.gap());
    return law_.between_spheres(q[c.i], q[c.j], c.radi, c.radj, c.gap());
  }

  void find_charges(const ContactHost& host) {
    constexpr auto property = "electricCharge";
    const GrainScalar own = host.grain_scalar(property);
    charges_ = own ? own : host.grain_scalar("q");
    sends_ = static_cast<bool>(own);
    const GrainScalarLines lines = host.grain_scalar_lines(property);
    const std::string rest = fmt::format(" (C), and the charges of groups by {}.", lines.set);
    if (!charges_) host.refuse("the grains have no charges. Add " + lines.make + rest);
    if (own && !own.on_ghosts)
      host.refuse("the charges of electricCharge are not sent to the other ranks. " + lines.send +
                  rest);
  }

  // Once per run and model; the walls have the same grains.
  void warn_of_breakdown(const ContactHost& host) const {
    if (host.is_wall()) return;
    const double* radius = host.radii();
    double over = 0.0;
    double worst = 0.0;
    for (int i = 0; i < host.grains(); ++i) {
      if (law_.over_breakdown(charges_[i], radius[i])) over += 1.0;
      worst = std::max(worst, std::abs(charges_[i]) / law_.breakdown_charge(radius[i]));
    }
    MPI_Allreduce(MPI_IN_PLACE, &over, 1, MPI_DOUBLE, MPI_SUM, host.communicator());
    MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_DOUBLE, MPI_MAX, host.communicator());
    if (over == 0.0) return;
    host.warn(
        fmt::format("{}: {:g} grains carry more charge than the gas bears at their "
                    "surface (breakdown_field {:g} V/m), up to {:.3g} times. The "
                    "run goes on with it.",
                    host.law(), over, law_.breakdown_field, worst));
  }

  double greatest_gap_ = 0.0;
  adhesion::Electrostatic law_;
  GrainScalar charges_;
  bool sends_ = false;  // those of an atom style the host sends itself
  ContactHost* host_ = nullptr;
};

}  // namespace gasgrain::contact
#endif
#endif
