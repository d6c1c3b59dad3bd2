// How fix couple/gas keeps the audit of its run (coupling/audit.h).
#include <algorithm>

#include "coupling/audit_report.h"
#include "fix_cfd_coupling/fixes/fix_couple_gas.h"
#include "fix_cfd_coupling/fixes/host_session.h"
// --
#include "comm.h"
#include "dialect_gravity.h"
#include "modify.h"
#include "update.h"

namespace LAMMPS_NS {

gasgrain::AuditSetting FixCoupleGas::audit_setting() const {
  return {coupled_->properties(), gasgrain::gravity_of(*modify).norm(), every_ * update->dt,
          overlapped_};
}

// A look costs a tenth of a coupling: where that is every few DEM steps, one in `steps_a_look`
// does.
void FixCoupleGas::look_for_audit() {
  constexpr long steps_a_look = 10;
  const long couplings_a_look = std::max(1L, steps_a_look / every_);
  if ((interval_watch_.couplings - 1) % couplings_a_look != 0) return;
  const gasgrain::Stopwatch watch(coupled_->costs(), coupled_->costs().task("coupling: audit"));
  audit_.look(particles(), records_, coupled_->fields(), coupled_->frame(), audit_setting());
}

void FixCoupleGas::report_audit(const gasgrain::Ledger& ledger) {
  if (audit_.couplings() == 0) return;
  const gasgrain::Audit whole = audit_.whole(gasgrain::session().local);
  if (comm->me != 0) return;
  const auto report = gasgrain::audit_report(whole, effects_, audit_setting(), ledger);
  guarded([&] { gasgrain::write_audit(output_, report); });
  for (FILE* sink : {screen, logfile})
    if (sink != nullptr) fmt::print(sink, "{}", report.text());
}

}  // namespace LAMMPS_NS
