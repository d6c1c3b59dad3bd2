// The constants of `cohesion sintered_neck` (cohesion_sintered_neck.h names them), read from the
// script, checked, and combined into what a contact asks.
#pragma once

#include <algorithm>

#include "fix_cfd_coupling/dem_physics/adhesion/neck_contact_time.h"
#include "fix_cfd_coupling/dem_physics/adhesion/neck_strength.h"
#include "fix_cfd_coupling/dem_physics/adhesion/sintered_neck.h"
#include "fix_cfd_coupling/dem_physics/contact/contact_host.h"

namespace gasgrain::contact {

// What the script writes after the model's name.
struct NeckWords {
  double temperature = 0.0;  // [K]; 0: that of the grains
  double volume_diffusion_from = 0.0;
  double micro_contacts = 0.0;
  double greatest_gap = 0.0;  // [m]
  bool correct_contact_time = false;
};

// What is known of the normal model.
struct NormalKind {
  bool linear = false;    // a stiffness that stays
  bool hertzian = false;  // the 3/2 law
};

// The necks of two types.
struct NeckLaw {
  adhesion::Sintering growth;
  adhesion::NeckStrength strength;
  double stiffness = 0.0;  // [N/m]; 0: the contact's
  double friction = 0.0;

  [[nodiscard]] bool holds(double pull, double tangential, double neck) const {
    return strength.holds(pull, tangential, growth.area(neck));
  }
  // Normal force [N] by which friction's limit rises by what the neck bears in shear.
  [[nodiscard]] double held_by_friction(double neck) const {
    return friction > 0.0 ? strength.greatest_shear(growth.area(neck)) / friction : 0.0;
  }
};

// Two bodies that meet.
struct Meeting {
  int itype, jtype;
  double mass;            // reduced [kg]
  double reduced_radius;  // [m]
  double stiffness;       // force over overlap, as the host has it [N/m]
  double overlap;         // [m]
  double speed;           // of approach [m/s]
};

class NeckLaws {
 public:
  // Ends the run with all faults in one message.
  void read(const ContactHost& host, const NeckWords& words, const NormalKind& normal);

  // Whether necks can grow at all.
  [[nodiscard]] bool act() const { return act_; }
  [[nodiscard]] const NeckLaw& operator()(int i, int j) const { return laws_(i, j); }
  [[nodiscard]] double stiffness(int i, int j, double of_contact) const {
    return own_stiffness_ ? laws_(i, j).stiffness : of_contact;
  }
  // To the ghosts; the host does so only when told to. Collective.
  void send_temperatures(ContactHost& host) const;
  // Of a contact between two grains [K]; of a wall: i twice.
  [[nodiscard]] double temperature(int i, int j) const;
  [[nodiscard]] adhesion::CollisionDurations durations(const Meeting& meeting) const;

 private:
  void read_temperature(const ContactHost& host);
  void read_real_contact(const ContactHost& host);

  PairTable<NeckLaw> laws_;
  bool act_ = false;
  bool own_stiffness_ = false;
  NormalKind normal_;
  NeckWords words_;
  GrainScalar temperature_;         // none: that of the words
  PairTable<double> real_modulus_;  // E* [Pa]
  PairTable<double> restitution_;
};

}  // namespace gasgrain::contact
