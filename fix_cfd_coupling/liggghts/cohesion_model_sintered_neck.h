// `cohesion sintered_neck`: necks that grow between hot grains, or a grain and a wall, by
// diffusion, hold them and break (dem_physics/adhesion has the laws, their units, signs and range:
// growth in sintered_neck.h, pull and breakage in neck_strength.h, the growth time of softened
// contacts in neck_contact_time.h).
//
// A neck grows while it exists or the bodies touch. At an overlap the contact's own force acts, and
// the neck breaks when the tangential force of the contact, of all models, reaches tau A; over a
// gap it pulls, and breaks when that pull reaches sigma A. Until it breaks, friction's limit is
// raised by tau A, so that the grains do not slide; a rolling model whose torque goes with the
// normal force feels that too. Over a gap a neck has no tangential force. Its stiffness is the
// contact's where that is one (hooke, hooke/stiffness), else neckStiffness.
//
// Properties, peratomtypepair: neckSurfaceTension [N/m], neckTensileStrength, neckShearStrength
// [Pa],
//   neckStiffness [N/m] (see above); scalar: neckLatticeConstant [m], surfaceDiffusionPrefactor,
//   volumeDiffusionPrefactor [m2/s], surfaceDiffusionEnergy, volumeDiffusionEnergy [J/mol];
//   peratomtype, with contact_time_correction on: youngsModulusReal [Pa].
// Words: neck_temperature [K] (default: the property/atom Temp, as of fix heat/gran; the mean of
// two
//   grains; a wall has its grain's), volume_diffusion_from [K] 1323.15, micro_contacts 1,
//   greatest_gap [m] (no default: a neck that is stretched beyond it breaks; it makes the host look
//   that far), contact_time_correction off, tangential_reduce off.
// With a surface tension of 0 for all pairs nothing is done, and the neighbour lists stay as they
// were.
#ifdef COHESION_MODEL
COHESION_MODEL(COHESION_SINTERED_NECK, sintered_neck, 24)
#else
#ifndef GASGRAIN_COHESION_MODEL_SINTERED_NECK_H
#define GASGRAIN_COHESION_MODEL_SINTERED_NECK_H

#include "coupling/base/vec3.h"
#include "fix_cfd_coupling/liggghts/cohesion_model_sintered_neck_laws.h"
#include "fix_cfd_coupling/liggghts/contact_styles_cohesion_base.h"
#include "fix_cfd_coupling/liggghts/contact_styles_stamp.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class CohesionModel<COHESION_SINTERED_NECK> : public gasgrain::OwnCohesionModel {
 public:
  CohesionModel(LAMMPS_NS::LAMMPS* host, History* history, Model* model)
      : OwnCohesionModel(host, history, model),
        neck_(history->add_history_value("neck_radius", "0")) {
    for (const char* name :
         {"neck_stamp", "neck_time", "neck_dem_time", "neck_real_time", "neck_stiffness"})
      history->add_history_value(name, "0");
  }

  void registerSettings(Settings& settings) override {
    settings.registerDoubleSetting("neck_temperature", words_.temperature, 0.0);
    settings.registerDoubleSetting("volume_diffusion_from", words_.volume_diffusion_from, 1323.15);
    settings.registerDoubleSetting("micro_contacts", words_.micro_contacts, 1.0);
    settings.registerDoubleSetting("greatest_gap", words_.greatest_gap, 0.0);
    settings.registerOnOff("contact_time_correction", words_.correct_contact_time, false);
  }

  void connectToProperties(PropertyRegistry& registry) override {
    const gasgrain::ContactProperties properties(*lmp, "cohesion sintered_neck");
    properties.refuse_unfit_run();
    const bool linear = normal_model_is("hooke") || normal_model_is("hooke/stiffness");
    const bool hertzian = normal_model_is("hertz") || normal_model_is("hertz/stiffness");
    laws_.read(*lmp, properties, words_, {linear, hertzian});
    stamp_.begin_run(*lmp);
    // The band beyond the greatest gap is for the history to forget.
    if (laws_.act()) reach(2.0 * words_.greatest_gap, registry, properties);
  }

  void beginPass(Intersect&, Force&, Force&) override { laws_.send_temperatures(); }

  void surfacesIntersect(Intersect& data, Force&, Force&) override {
    if (!laws_.act() || data.contact_history == nullptr) return;
    keep_history(data, true);
    Neck neck(data.contact_history + neck_);
    if (updates(data)) {
      if (!stamp_.holds(neck.stamp)) meet(data, neck);
      neck.stiffness = laws_.stiffness(data.itype, data.jtype, data.kn);
      grow(data, neck);
    }
    data.Fn += laws_(data.itype, data.jtype).held_by_friction(neck.radius);
  }

  // All models have added their forces.
  void endSurfacesIntersect(Intersect& data, Force& i, Force&) override {
    if (!laws_.act() || !updates(data)) return;
    Neck neck(data.contact_history + neck_);
    const gasgrain::Vec3 total(i.delta_F[0], i.delta_F[1], i.delta_F[2]);
    const gasgrain::Vec3 normal(data.en[0], data.en[1], data.en[2]);
    const double tangential = (total - total.dot(normal) * normal).norm();
    constexpr double pull_of_overlap = 0.0;
    if (!laws_(data.itype, data.jtype).holds(pull_of_overlap, tangential, neck.radius))
      neck.radius = 0.0;
  }

  void surfacesClose(Close& data, Force& i, Force& j) override {
    if (!laws_.act() || data.contact_history == nullptr) return;
    Neck neck(data.contact_history + neck_);
    const double stretch = gap(data);
    const double attraction = gasgrain::adhesion::neck_attraction(neck.stiffness, stretch);
    const bool bears = stamp_.holds(neck.stamp) &&
                       laws_(data.itype, data.jtype).holds(attraction, 0.0, neck.radius);
    const bool holds = bears && stretch <= words_.greatest_gap;
    if (bears && !holds && updates(data))
      tell(++overstretched_, "broke at greatest_gap, though they bore the pull: make it greater");
    if (holds && updates(data)) grow(data, neck);
    if (!holds && updates(data)) neck.forget();
    keep_history(data, holds);
    if (holds) pull(attraction, data, i, j);
  }

 private:
  // The values of a contact's history, in the order in which they are claimed.
  struct Neck {
    explicit Neck(double* history)
        : radius(history[0]),
          stamp(history[1]),
          time(history[2]),
          dem_time(history[3]),
          real_time(history[4]),
          stiffness(history[5]) {}
    void forget() { radius = stamp = time = dem_time = real_time = stiffness = 0.0; }

    double& radius;  // x [m], of one micro-contact; 0: no neck
    double& stamp;
    double& time;      // in touch [s]
    double& dem_time;  // durations of the free collision [s]; equal: no correction
    double& real_time;
    double& stiffness;  // [N/m]
  };

  // A contact that was not there a step before.
  void meet(const Intersect& data, Neck& neck) const {
    neck.forget();
    const auto durations = laws_.durations(
        {data.itype, data.jtype, data.meff, reduced_radius(data), data.kn, data.deltan, -data.vn});
    neck.dem_time = durations.in_dem;
    neck.real_time = durations.real;
  }

  void grow(const Close& data, Neck& neck) {
    using namespace gasgrain::adhesion;
    const double dt = update->dt;
    const CollisionDurations durations{neck.dem_time, neck.real_time};
    const double grain =
        data.is_wall ? grain_radius_at_wall(data.radi) : grain_radius_of_pair(data.radi, data.radj);
    const double temperature = laws_.temperature(data.i, data.is_wall ? data.i : data.j);
    const auto& growth = laws_(data.itype, data.jtype).growth;
    const bool was_wide = growth.beyond_first_stage(neck.radius, grain);
    neck.radius = growth.grown(neck.radius, grain, temperature,
                               durations.growth_between(neck.time, neck.time + dt));
    neck.time += dt;
    neck.stamp = stamp_.now();
    if (!was_wide && growth.beyond_first_stage(neck.radius, grain))
      tell(++wide_, "grew wider than 0.3 of the radii that touch, where the law of growth ends");
  }

  // At the 1st, 10th, 100th ... of this rank and model.
  void tell(long count, const char* what) const {
    long power = 1;
    while (power < count) power *= 10;
    if (power != count) return;
    error->warning(FLERR,
                   fmt::format("cohesion sintered_neck, step {}: {} of this rank's necks {}.",
                               update->ntimestep, count, what)
                       .c_str());
  }

  int neck_;
  long wide_ = 0;
  long overstretched_ = 0;
  gasgrain::NeckWords words_;
  gasgrain::NeckLaws laws_;
  gasgrain::ContactStamp stamp_;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS
#endif
#endif
