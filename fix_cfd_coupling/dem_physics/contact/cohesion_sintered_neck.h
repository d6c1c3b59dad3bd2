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
//   [Pa], neckStiffness [N/m] (see above); scalar: neckLatticeConstant [m],
//   surfaceDiffusionPrefactor, volumeDiffusionPrefactor [m2/s], surfaceDiffusionEnergy,
//   volumeDiffusionEnergy [J/mol]; peratomtype, with contact_time_correction on: youngsModulusReal
//   [Pa].
// Words: neck_temperature [K] (default: the grains' property Temp, such as that of LIGGGHTS's fix
//   heat/gran; the mean of two grains; a wall has its grain's), volume_diffusion_from [K] 1323.15,
//   micro_contacts 1, greatest_gap [m] (no default: a neck that is stretched beyond it breaks; it
//   makes the host look that far), contact_time_correction off.
// With a surface tension of 0 for all pairs nothing is done, and the neighbour lists stay as they
// were.
#ifdef COHESION_LAW
COHESION_LAW(CohesionSinteredNeck, sintered_neck, 24)
#else
#ifndef GASGRAIN_COHESION_SINTERED_NECK_H
#define GASGRAIN_COHESION_SINTERED_NECK_H

#include <vector>

#include "coupling/base/vec3.h"
#include "fix_cfd_coupling/dem_physics/contact/cohesion_law.h"
#include "fix_cfd_coupling/dem_physics/contact/contact_stamp.h"
#include "fix_cfd_coupling/dem_physics/contact/neck_laws.h"

namespace gasgrain::contact {

class CohesionSinteredNeck : public CentralCohesionLaw {
 public:
  static std::vector<HistoryValue> history(bool /*of_wall*/) {
    return {{"neck_radius", false},   {"neck_stamp", false},     {"neck_time", false},
            {"neck_dem_time", false}, {"neck_real_time", false}, {"neck_stiffness", false}};
  }

  void words(LawWords& words) {
    words.number("neck_temperature", words_.temperature, 0.0);
    words.number("volume_diffusion_from", words_.volume_diffusion_from, 1323.15);
    words.number("micro_contacts", words_.micro_contacts, 1.0);
    words.number("greatest_gap", words_.greatest_gap, 0.0);
    words.on_off("contact_time_correction", words_.correct_contact_time, false);
  }

  void connect(ContactHost& host) {
    host_ = &host;
    host.refuse_unfit_run();
    const bool linear = host.normal_model_is("hooke") || host.normal_model_is("hooke/stiffness");
    const bool hertzian = host.normal_model_is("hertz") || host.normal_model_is("hertz/stiffness");
    laws_.read(host, words_, {linear, hertzian});
    stamp_.begin_run(host);
    // The band beyond the greatest gap is for the history to forget.
    if (laws_.act()) host.reach(2.0 * words_.greatest_gap);
  }

  void begin_pass() { laws_.send_temperatures(*host_); }

  void touching(ContactView& c, const ContactForces&) {
    if (!laws_.act() || c.history == nullptr) return;
    c.keep = true;
    Neck neck(c.history);
    if (c.updates) {
      if (!stamp_.holds(neck.stamp, c.step)) meet(c, neck);
      neck.stiffness = laws_.stiffness(c.itype, c.jtype, c.kn);
      grow(c, neck);
    }
    c.Fn += laws_(c.itype, c.jtype).held_by_friction(neck.radius);
  }

  void after_all(ContactView& c, const ContactForces& f) {
    if (!laws_.act() || !c.updates || c.history == nullptr) return;
    Neck neck(c.history);
    const Vec3 total = vec(f.force_i);
    const Vec3 normal = vec(c.en);
    const double tangential = (total - total.dot(normal) * normal).norm();
    constexpr double pull_of_overlap = 0.0;
    if (!laws_(c.itype, c.jtype).holds(pull_of_overlap, tangential, neck.radius)) neck.radius = 0.0;
  }

  void apart(ContactView& c, const ContactForces& f) {
    if (!laws_.act() || c.history == nullptr) return;
    Neck neck(c.history);
    const double stretch = c.gap();
    const double attraction = adhesion::neck_attraction(neck.stiffness, stretch);
    const bool bears = stamp_.holds(neck.stamp, c.step) &&
                       laws_(c.itype, c.jtype).holds(attraction, 0.0, neck.radius);
    const bool holds = bears && stretch <= words_.greatest_gap;
    if (bears && !holds && c.updates)
      tell(++overstretched_, c.step,
           "broke at greatest_gap, though they bore the pull: make it greater");
    if (holds && c.updates) grow(c, neck);
    if (!holds && c.updates) neck.forget();
    c.keep = holds;
    if (holds) pull_apart(attraction, c, f);
  }

 private:
  // The values of a contact's history, in their order.
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
  void meet(const ContactView& c, Neck& neck) const {
    neck.forget();
    const auto durations =
        laws_.durations({c.itype, c.jtype, c.meff, c.reduced_radius(), c.kn, c.overlap, -c.vn});
    neck.dem_time = durations.in_dem;
    neck.real_time = durations.real;
  }

  void grow(const ContactView& c, Neck& neck) {
    using namespace adhesion;
    const CollisionDurations durations{neck.dem_time, neck.real_time};
    const double grain =
        c.is_wall ? grain_radius_at_wall(c.radi) : grain_radius_of_pair(c.radi, c.radj);
    const double temperature = laws_.temperature(c.i, c.is_wall ? c.i : c.j);
    const auto& growth = laws_(c.itype, c.jtype).growth;
    const bool was_wide = growth.beyond_first_stage(neck.radius, grain);
    neck.radius = growth.grown(neck.radius, grain, temperature,
                               durations.growth_between(neck.time, neck.time + c.dt));
    neck.time += c.dt;
    neck.stamp = stamp_.now(c.step);
    if (!was_wide && growth.beyond_first_stage(neck.radius, grain))
      tell(++wide_, c.step,
           "grew wider than 0.3 of the radii that touch, where the law of growth ends");
  }

  // At the 1st, 10th, 100th ... of this rank and model.
  void tell(long count, std::int64_t step, const char* what) const {
    long power = 1;
    while (power < count) power *= 10;
    if (power != count) return;
    host_->warn_from_here(
        fmt::format("{}, step {}: {} of this rank's necks {}.", host_->law(), step, count, what));
  }

  long wide_ = 0;
  long overstretched_ = 0;
  NeckWords words_;
  NeckLaws laws_;
  ContactStamp stamp_;
  ContactHost* host_ = nullptr;
};

}  // namespace gasgrain::contact
#endif
#endif
