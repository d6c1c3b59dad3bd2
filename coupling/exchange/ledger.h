// The ledger of momentum: what the gas gave = what the particles took, over the whole run, in N s.
//
//   given        impulse that the gas lost to the particles, as its solver reports it: the sum over
//                cells of V (K u - S) interval
//   taken        impulse that the particles received from the forces that the gas answers for,
//                DEM step by DEM step
//   outstanding  carry (taken - expected) of the particles that are there: the gas will give it
//                with the next coupling
//   left         carry of particles that were removed: the gas will never give it
//   exchanged    sum over particles, steps and components of |impulse taken|: the scale
//
//   residual = |given - taken + outstanding + left| / exchanged, round-off when all is well.
//
// Beside it the impulses that complete the particles' own balance:
//   free         of the forces that the gas does not answer for: that of the pressure gradient (in
//                model A the gas keeps its share of grad p in its own balance), outer fields
//   host         of the host's own forces; contacts between particles cancel, so that walls and
//                weight remain
//   change of the particles' momentum = taken + free + host
//
// Each rank keeps its own sums; values() may be added over the ranks and given to a ledger of the
// whole.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "coupling/exchange/applied_forces.h"
#include "coupling/exchange/effects.h"

namespace gasgrain {

class Ledger {
 public:
  explicit Ledger(const Effects& effects);

  void add_given(const Vec3& impulse) { given_ += impulse; }
  void add_taken(const AppliedForces& applied);
  void add_left(const Vec3& carry_of_removed) { left_ += carry_of_removed; }
  // Of each effect, in the order of Effects::names() [N s].
  void add_work(const std::vector<double>& work);
  // Replaces the carry outstanding: of the particles that are there now.
  void set_outstanding(const Vec3& carry) { outstanding_ = carry; }

  [[nodiscard]] const Vec3& given() const { return given_; }
  [[nodiscard]] const Vec3& taken() const { return taken_; }
  [[nodiscard]] const Vec3& outstanding() const { return outstanding_; }
  [[nodiscard]] const Vec3& left() const { return left_; }
  [[nodiscard]] double exchanged() const { return exchanged_; }
  // Zero when nothing was exchanged and nothing is amiss; infinite when something is.
  [[nodiscard]] double residual() const;

  // Names of the effects that are on and have done nothing so far.
  [[nodiscard]] std::vector<std::string> idle_effects() const;

  // All sums, in an order that only depends on the effects, to be added over ranks and set.
  [[nodiscard]] std::vector<double> values() const;
  void set_values(const std::vector<double>& values);

  // Columns of history.csv, units in the names, and their values.
  [[nodiscard]] std::vector<std::string> column_names() const;
  [[nodiscard]] std::vector<double> column_values() const;
  // For people, one line, and one more when an effect did nothing.
  [[nodiscard]] std::string text() const;

 private:
  [[nodiscard]] std::array<const Vec3*, 6> sums() const;

  std::vector<std::string> effects_;
  std::vector<double> work_;
  Vec3 given_ = Vec3::Zero();
  Vec3 taken_ = Vec3::Zero();
  Vec3 outstanding_ = Vec3::Zero();
  Vec3 left_ = Vec3::Zero();
  Vec3 free_ = Vec3::Zero();
  Vec3 host_ = Vec3::Zero();
  double exchanged_ = 0.0;
};

}  // namespace gasgrain
