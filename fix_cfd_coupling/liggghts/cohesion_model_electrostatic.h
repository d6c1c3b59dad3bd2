// `cohesion electrostatic`: forces of charged grains on each other and to a wall
// (dem_physics/adhesion/electrostatic.h has the laws, their units, signs and range).
//
// Charges [C]: `fix ID all property/atom electricCharge scalar RESTART yes no Q`, with values sent
// to
//   the ghosts (the second word yes); without it, the charge of an atom style that has one.
// Words: greatest_gap [m], to which charges act (no default: the force has no end of its own);
//   medium_permittivity 1, wall_permittivity inf (a conductor; 1: no image), wall_charge [C/m2] 0,
//   breakdown_field [V/m] 3e6, tangential_reduce off.
// A wall, also one of a mesh, is a plane through the nearest point. Grains charged beyond the
// breakdown are counted and warned of when a run begins; their charge stays.
#ifdef COHESION_MODEL
COHESION_MODEL(COHESION_ELECTROSTATIC, electrostatic, 22)
#else
#ifndef GASGRAIN_COHESION_MODEL_ELECTROSTATIC_H
#define GASGRAIN_COHESION_MODEL_ELECTROSTATIC_H

#include <algorithm>

#include "fix_cfd_coupling/dem_physics/adhesion/electrostatic.h"
#include "fix_cfd_coupling/liggghts/contact_styles_cohesion_base.h"
// --
#include "atom.h"
#include "comm.h"
#include "fix_property_atom.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class CohesionModel<COHESION_ELECTROSTATIC> : public gasgrain::OwnCohesionModel {
 public:
  CohesionModel(LAMMPS_NS::LAMMPS* host, History* history, Model* model)
      : OwnCohesionModel(host, history, model) {}

  void registerSettings(Settings& settings) override {
    OwnCohesionModel::registerSettings(settings);
    settings.registerDoubleSetting("greatest_gap", greatest_gap_, 0.0);
    settings.registerDoubleSetting("medium_permittivity", law_.medium_permittivity, 1.0);
    settings.registerDoubleSetting("wall_permittivity", law_.wall_permittivity,
                                   gasgrain::adhesion::conductor);
    settings.registerDoubleSetting("wall_charge", law_.wall_charge, 0.0);
    settings.registerDoubleSetting("breakdown_field", law_.breakdown_field, 3e6);
  }

  void connectToProperties(PropertyRegistry& registry) override {
    const gasgrain::ContactProperties properties(*lmp, "cohesion electrostatic");
    properties.refuse_unfit_run();
    try {
      gasgrain::InputFaults("The reach of charges")
          .positive(
              "greatest_gap", greatest_gap_, "m",
              "give it after the model's name, some 10 radii, where the force of two grains is "
              "1/36 of that at touch")
          .refuse();
      check(law_);
    } catch (const gasgrain::Error& fault) {
      properties.refuse(fault.what());
    }
    find_charges(properties);
    warn_of_breakdown(properties);
    reach(greatest_gap_, registry, properties);
  }

  // The host sends a property/atom to the ghosts only when told to.
  void beginPass(Intersect&, Force&, Force&) override {
    if (property_ != nullptr) property_->do_forward_comm();
  }
  void surfacesIntersect(Intersect& data, Force& i, Force& j) override {
    pull(attraction(data), data, i, j);
  }
  void surfacesClose(Close& data, Force& i, Force& j) override {
    pull(attraction(data), data, i, j);
  }

 private:
  // Asked for anew: the host moves them when it makes place for more grains.
  [[nodiscard]] const double* charges() const {
    return property_ != nullptr ? property_->vector_atom : atom->q;
  }
  [[nodiscard]] double attraction(const Close& data) const {
    if (gap(data) > greatest_gap_) return 0.0;
    const double* q = charges();
    if (data.is_wall) return law_.to_wall(q[data.i], data.radi, gap(data));
    return law_.between_spheres(q[data.i], q[data.j], data.radi, data.radj, gap(data));
  }

  void find_charges(const gasgrain::ContactProperties& properties) {
    property_ = static_cast<LAMMPS_NS::FixPropertyAtom*>(modify->find_fix_property(
        "electricCharge", "property/atom", "scalar", 0, 0, properties.model().c_str(), false));
    constexpr auto line =
        "'fix ID all property/atom electricCharge scalar yes yes no VALUE' (C), and the charges of "
        "groups by 'set group ID property/atom electricCharge VALUE'";
    if (property_ == nullptr && atom->q_flag == 0)
      properties.refuse(fmt::format("the grains have no charges. Add {}.", line));
    if (property_ != nullptr && property_->comm_forward == 0)
      properties.refuse(
          fmt::format("the charges of electricCharge are not sent to the other ranks. Write its "
                      "second word yes: {}.",
                      line));
  }

  // Once per run and model; the walls have the same grains.
  void warn_of_breakdown(const gasgrain::ContactProperties& properties) {
    if (is_wall()) return;
    const double* q = charges();
    double over = 0.0;
    double worst = 0.0;
    for (int i = 0; i < atom->nlocal; ++i) {
      if (law_.over_breakdown(q[i], atom->radius[i])) over += 1.0;
      worst = std::max(worst, std::abs(q[i]) / law_.breakdown_charge(atom->radius[i]));
    }
    MPI_Allreduce(MPI_IN_PLACE, &over, 1, MPI_DOUBLE, MPI_SUM, world);
    MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_DOUBLE, MPI_MAX, world);
    if (over == 0.0 || comm->me != 0) return;
    error->warning(FLERR,
                   fmt::format("{}: {:g} grains carry more charge than the gas bears at their "
                               "surface (breakdown_field {:g} V/m), up to {:.3g} times. The "
                               "run goes on with it.",
                               properties.model(), over, law_.breakdown_field, worst)
                       .c_str());
  }

  double greatest_gap_ = 0.0;
  gasgrain::adhesion::Electrostatic law_;
  LAMMPS_NS::FixPropertyAtom* property_ = nullptr;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS
#endif
#endif
