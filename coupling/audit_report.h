// What the audit says at the end of a run: a verdict an effect.
#pragma once

#include <string>
#include <vector>

#include "coupling/audit.h"
#include "coupling/exchange/ledger.h"

namespace gasgrain {

struct AuditRow {
  enum class State { off, on, of_gas_program };

  std::string effect;
  State state = State::off;
  bool needed = false;
  bool wrong = false;      // a warning; of the gas program's own effects nobody knows yet
  double of_drag = 0.0;    // sum over all grains; on: of the ledger's impulses
  double estimated = 0.0;  // the same by the estimates, whatever the ledger has
  double of_weight = 0.0;
  double greatest = 0.0;  // of any one grain: share of the greater of its weight and drag
  double often = 0.0;     // share of grains for which it was needed_share or more
  std::string text;
  std::string remedy;  // the word or key to write, where it is wrong or would be
};

struct AuditReport {
  std::vector<AuditRow> rows;
  std::string heading;  // couplings, grains, extremes

  // For people; the warnings first.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::string json() const;
};

// `whole`: of all ranks. `ledger`: of all ranks.
AuditReport audit_report(const Audit& whole, const Effects& effects, const AuditSetting& setting,
                         const Ledger& ledger);

// Writes audit.txt and audit.json into the folder. Throws Error when it cannot.
void write_audit(const std::string& folder, const AuditReport& report);

}  // namespace gasgrain
