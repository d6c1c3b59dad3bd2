// How the records of fix couple/gas move with the particles, between ranks and through restarts.
#include <algorithm>
#include <cstring>

#include "fix_cfd_coupling/fixes/fix_couple_gas.h"
// --
#include "atom.h"
#include "comm.h"

namespace LAMMPS_NS {

namespace {

// Raised with every change of StoredState.
constexpr bigint stored_format = 4;

}  // namespace

void FixCoupleGas::grow_arrays(int size) {
  records_.resize(static_cast<std::size_t>(size));
  exchanges(records_.layout().size);
}

void FixCoupleGas::copy_arrays(int from, int to, int) {
  records_.copy(from, to);
}

void FixCoupleGas::set_arrays(int particle) {
  records_.clear(particle);
}

int FixCoupleGas::pack_exchange(int particle, double* buffer) {
  const int size = records_.layout().size;
  std::copy_n(records_.row(particle), size, buffer);
  return size;
}

int FixCoupleGas::unpack_exchange(int particle, double* buffer) {
  const int size = records_.layout().size;
  std::copy_n(buffer, size, records_.row(particle));
  return size;
}

// The host keeps the length of a fix's share in front of it.
int FixCoupleGas::pack_restart(int particle, double* buffer) {
  buffer[0] = size_restart(particle);
  pack_exchange(particle, buffer + 1);
  return size_restart(particle);
}

// A bed that was only packed may have been written with other effects, by other records.
void FixCoupleGas::unpack_restart(int particle, int nth) {
  double* share = atom->extra[particle];
  for (int n = 0; n < nth; ++n) share += static_cast<int>(share[0]);
  if (last_coupled_ < 0)
    records_.clear(particle);
  else
    unpack_exchange(particle, share + 1);
}

int FixCoupleGas::size_restart(int) {
  return records_.layout().size + 1;
}

int FixCoupleGas::maxsize_restart() {
  return records_.layout().size + 1;
}

// Whole state: start, last coupled step, interval, the gas's last report, then the ledger of all
// ranks. The gas writes its checkpoint of the same step at the same time. Called on every rank;
// rank 0 has the file.
void FixCoupleGas::write_restart(FILE* file) {
  // A gas that is still at work must have answered before it is asked for a checkpoint.
  guarded([&] {
    try {
      coupled_->complete(particles(), records_);
    } catch (const gasgrain::RunFault&) {
      // One that has gone wrong as well has nothing to add to the message.
      if (!autopsy_) throw;
    }
  });
  const auto ledger = coupled_->whole_ledger(particles(), records_).values();
  guarded([&] {
    if (autopsy_)
      no_gas_autopsy_ = coupled_->autopsy(step_now());
    else
      coupled_->checkpoint(step_now());
  });
  if (comm->me != 0) return;
  StoredState state{stored_format,
                    start_,
                    last_coupled_,
                    every_,
                    booked_whole_ ? 1 : 0,
                    records_.layout().size,
                    static_cast<int>(ledger.size()),
                    coupled_->report()};
  const int bytes = static_cast<int>(sizeof(state) + ledger.size() * sizeof(double));
  fwrite(&bytes, sizeof(int), 1, file);
  fwrite(&state, sizeof(state), 1, file);
  fwrite(ledger.data(), sizeof(double), ledger.size(), file);
}

void FixCoupleGas::restart(char* data) {
  StoredState state;
  std::memcpy(&state, data, sizeof(state));
  if (state.format != stored_format)
    gasgrain::stop_everything(
        "the checkpoint is of another version of gasgrain: start the run anew.");
  resumed_ = true;
  // A bed that has not met the gas yet may begin any run; where it met it, the gas is ahead by the
  // interval it was told.
  if (state.last_coupled < 0) return;
  if (state.every != every_)
    gasgrain::stop_everything(fmt::format(
        "the checkpoint was written with 'every {}', the script has 'every {}': keep it.",
        state.every, every_));
  if (state.start != start_)
    gasgrain::stop_everything(fmt::format(
        "the checkpoint was written with 'start {}', the script has 'start {}': keep it.",
        state.start, start_));
  if (state.ledger_values != static_cast<int>(gasgrain::Ledger(effects_).values().size()) ||
      state.record_size != records_.layout().size)
    gasgrain::stop_everything(
        "the checkpoint was written with other effects or another mode on the couple/gas line: "
        "keep "
        "them.");
  last_coupled_ = state.last_coupled;
  booked_whole_ = state.booked_whole != 0;
  restored_report_ = state.last_report;
  restored_ledger_.resize(static_cast<std::size_t>(state.ledger_values));
  std::memcpy(restored_ledger_.data(), data + sizeof(state),
              restored_ledger_.size() * sizeof(double));
}

}  // namespace LAMMPS_NS
