// The drag ledger: what the gas gave = what the particles took, over the whole run, in N s.
//
//   given        drag impulse that the gas lost, as its solver reports it: the sum over cells of
//                V (K u - S) interval
//   taken        drag impulse that the particles received, DEM step by DEM step
//   outstanding  carry (taken - expected) of the particles that are there: the gas will give it
//   with
//                the next coupling
//   left         carry of particles that were removed: the gas will never give it
//   exchanged    sum over particles, steps and components of |impulse taken|: the scale
//
//   residual = |given - taken + outstanding + left| / exchanged, round-off when all is well.
//
// The force of the pressure gradient is no part of it: in model A the gas keeps its share of grad p
// in its own balance.
//
// Each rank keeps its own sums; values() may be added over the ranks and given to a ledger of the
// whole.
#pragma once

#include <string>
#include <vector>

#include "coupling/exchange/effects.h"
#include "coupling/exchange/particle_exchange.h"

namespace gasgrain {

class Ledger {
 public:
  explicit Ledger(const Effects& effects);

  void add_given(const Vec3& impulse) { given_ += impulse; }
  void add_taken(const AppliedDrag& applied);
  void add_left(const Vec3& carry_of_removed) { left_ += carry_of_removed; }
  // What set_records() returned.
  void add_steady_work(const std::vector<double>& work);
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
  [[nodiscard]] static std::vector<std::string> column_names();
  [[nodiscard]] std::vector<double> column_values() const;
  // One paragraph for the log, idle effects included.
  [[nodiscard]] std::string text() const;

 private:
  bool has_drag_;
  std::vector<std::string> forces_;
  std::vector<double> work_;  // per force, sum of |F| interval [N s]
  Vec3 given_ = Vec3::Zero();
  Vec3 taken_ = Vec3::Zero();
  Vec3 outstanding_ = Vec3::Zero();
  Vec3 left_ = Vec3::Zero();
  double exchanged_ = 0.0;
};

}  // namespace gasgrain
