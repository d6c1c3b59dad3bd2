// fix ID all couple/gas every N [start STEP] [output DIR] [mode MODE] [gas FILE [gas_restart FILE]]
//                       EFFECTS...
//
// Couples the bed with the gas solver of the same launch, or with one inside this program.
// The physics is in coupling/exchange, the story of a step in coupling/coupled_step. The words
// after the keywords are the scene's effects (coupling/exchange/effects.h).
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

#include "coupling/audit.h"
#include "coupling/coupled_step.h"
#include "coupling/exchange/particle_exchange.h"
#include "coupling/run_history.h"
#include "coupling/run_watch.h"
#include "fix_cfd_coupling/fixes/host_error.h"
// --
#include "dialect_clocks.h"
#include "dialect_fix.h"

namespace LAMMPS_NS {

class FixParcels;

class FixCoupleGas : public HostFix {
 public:
  FixCoupleGas(LAMMPS* host, int narg, char** arg);
  ~FixCoupleGas() override;

  int mask() override;
  void init() override;
  void setup_pre_exchange() override;
  void setup(int) override;
  void pre_exchange() override;
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

  // Of the gas.
  [[nodiscard]] const gasgrain::BoxGrid& grid() const { return coupled_->grid(); }

 protected:
  void begin() override;

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
  // The deepest contact of two grains, over the smaller diameter; walls are not looked at.
  struct Overlap {
    double ratio = 0.0;
    int i = -1;  // the pair's local indices, -1: none touch
    int j = -1;
  };
  [[nodiscard]] Overlap greatest_overlap() const;
  // The watch over the run: fix_couple_gas_watch.cpp
  void check_contacts();
  [[nodiscard]] gasgrain::HostGrains host_grains() const;
  [[nodiscard]] gasgrain::Moment moment() const;
  void watch_grains_that_move_on();
  void watch_state(const Overlap& overlap);
  void watch_count(double grains);
  void watch_interval();
  void tell(const std::string& text) const;
  void tell_of_interval() const;
  void put_stray_grains_into_box();
  [[noreturn]] void stop_with_autopsy(const std::string& fault);
  // Costs, fix_couple_gas_costs.cpp.
  void begin_setup_costs();
  void end_setup_costs();
  void take_host_costs();
  void tell_costs();
  // The audit: fix_couple_gas_audit.cpp
  [[nodiscard]] gasgrain::AuditSetting audit_setting() const;
  void look_for_audit();
  void report_audit(const gasgrain::Ledger& ledger);
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
  const FixParcels* parcels_ = nullptr;  // what each of the host's atoms stands for; null: a grain
  std::unique_ptr<gasgrain::CoupledStep> coupled_;
  std::unique_ptr<gasgrain::HistoryFile> history_;
  gasgrain::Audit audit_;
  gasgrain::ExchangeRecords records_;  // one per particle, moves with it
  bigint last_coupled_ = -1;           // step; -1: never
  bigint last_recorded_ = -1;          // step
  bool resumed_ = false;
  bool booked_whole_ = false;            // the last step's force was booked with both of its halves
  std::vector<double> restored_ledger_;  // of a checkpoint, until it is handed on
  gasgrain::Report restored_report_;     // of a checkpoint, rank 0
  std::array<double, 4> shown_{};        // f_ID[1..4]

  // Of the watch
  struct IntervalWatch {
    gasgrain::IntervalNeed last;  // of all ranks, of the last coupling
    long couplings = 0;
    long too_long = 0;     // couplings, of them
    double advised = 0.0;  // the interval that would have done for all of them [s]
  };
  bool contacts_checked_ = false;  // of this run
  bool contacts_told_ = false;
  bool autopsy_ = false;        // the state is being written because the run has gone wrong
  std::string no_gas_autopsy_;  // why
  long left_box_ = 0;           // grains of this rank since the last line, where they may
  IntervalWatch interval_watch_;
  gasgrain::HostClocks host_clocks_;
  double setup_begin_ = 0.0;   // age of the cost ledger less what has names [s]
  double named_before_ = 0.0;  // what had names when the run began [s]
};

// Errors that ranks meet during the run end the launch with one message.
template <class Action>
void FixCoupleGas::guarded(Action&& action) {
  try {
    action();
  } catch (const gasgrain::RunFault& fault) {
    stop_with_autopsy(fault.what());
  } catch (const gasgrain::Error& e) {
    // Alone, or (an error of a gas inside) with all the others.
    gasgrain::stop_everything(e.what());
  }
}

}  // namespace LAMMPS_NS
