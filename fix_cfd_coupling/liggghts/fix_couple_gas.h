// fix ID all couple/gas every N [start STEP] [output DIR] [mode MODE] [gas FILE [gas_restart FILE]]
//                       EFFECTS...
//
// Couples the bed with the gas solver of the same launch, or with one inside this program.
// LIGGGHTS's dialect only: the physics is in coupling/exchange, the story of a step in
// coupling/coupled_step. The words after the keywords are the scene's effects
// (coupling/exchange/effects.h).
//   every N     DEM steps between two couplings
//   start STEP  the gas starts at this step; before it the bed is packed without gas (default: at
//   once)
//   output DIR  folder of history.csv, run.json, checkpoints (default: results)
//   mode MODE   in_turn (default) or overlapped: the gas advances while the grains move on
//   gas FILE    the gas solver runs inside the DEM ranks with this gas.toml (default: in its own
//               program, gasgrain-gas, of the same launch)
//   gas_restart FILE   its checkpoint to go on from
// f_ID[1..4]: bed height [m], bubble diameter [m], ledger residual, Courant number of the gas.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "coupling/coupled_step.h"
#include "coupling/exchange/particle_exchange.h"
#include "coupling/run_history.h"
#include "fix_cfd_coupling/liggghts/host_error.h"
// --
#include "fix.h"

namespace LAMMPS_NS {

class FixCoupleGas : public Fix {
 public:
  FixCoupleGas(LAMMPS* host, int narg, char** arg);
  ~FixCoupleGas() override;

  int setmask() override;
  void post_create() override;
  void init() override;
  void setup(int) override;
  void post_force(int) override;
  void end_of_step() override;
  void post_run() override;

  void grow_arrays(int size) override;
  void copy_arrays(int from, int to, int) override;
  void set_arrays(int particle) override;
  int pack_exchange(int particle, double* buffer) override;
  int unpack_exchange(int particle, double* buffer) override;
  int pack_restart(int particle, double* buffer) override;
  void unpack_restart(int particle, int nth) override;
  int size_restart(int) override;
  int maxsize_restart() override;
  void write_restart(FILE* file) override;
  void restart(char* data) override;

  double compute_vector(int n) override;
  double memory_usage() override;

 private:
  // What a restart file holds beside the records of the particles; the ledger's sums follow it.
  struct StoredState {
    bigint format;
    bigint start;
    bigint last_coupled;
    int every;
    int booked_whole;
    int record_size;
    int ledger_values;
    gasgrain::Report last_report;
  };

  void read_arguments(int narg, char** arg);
  [[nodiscard]] std::unique_ptr<gasgrain::GasPartner> gas_partner() const;
  void meet_partner();
  [[nodiscard]] gasgrain::ParticleView particles() const;
  [[nodiscard]] bool due(bigint step) const;
  [[nodiscard]] bigint step_now() const;
  void couple();
  void open_history();
  void record();
  void apply_forces(double share_of_step);
  void warn_of_later_forces() const;
  [[nodiscard]] double greatest_overlap() const;
  template <class Action>
  void guarded(Action&& action);

  // Of the script
  int every_ = 0;
  bigint start_ = 0;
  std::string output_ = "results";
  bool overlapped_ = false;
  std::string gas_input_;    // of a gas inside; empty: the gas is a program of the launch
  std::string gas_restart_;  // its checkpoint; empty: a new run
  gasgrain::Effects effects_;

  // Of the run
  std::unique_ptr<gasgrain::CoupledStep> coupled_;
  std::unique_ptr<gasgrain::HistoryFile> history_;
  gasgrain::ExchangeRecords records_;  // one per particle, moves with it
  bigint last_coupled_ = -1;           // step; -1: never
  bigint last_recorded_ = -1;          // step
  bool resumed_ = false;
  bool booked_whole_ = false;            // the last step's force was booked with both of its halves
  std::vector<double> restored_ledger_;  // of a checkpoint, until it is handed on
  gasgrain::Report restored_report_;     // of a checkpoint, rank 0
  std::array<double, 4> shown_{};        // f_ID[1..4]
};

// Errors that ranks meet during the run end the launch with one message.
template <class Action>
void FixCoupleGas::guarded(Action&& action) {
  try {
    action();
  } catch (const gasgrain::Error& e) {
    // Alone, or (an error of a gas inside) with all the others.
    gasgrain::stop_everything(e.what());
  }
}

}  // namespace LAMMPS_NS
