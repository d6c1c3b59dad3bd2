#include "gas_solver/coupled_gas_port.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "gas_solver/gas_fault.h"
#include "gas_solver/io/cost_file.h"

namespace gasgrain {
namespace {

Report report_of_fault(const Error& fault) {
  Report report;
  report.fault = 1;
  put_text(report.fault_text, fault.what());
  return report;
}

}  // namespace

CoupledGas::CoupledGas(const GasInput& input, const GasFiles& files, const Communicator& comm)
    : solver_(input, comm),
      port_(solver_, input, files.input),
      out_(files.out),
      restarted_(!files.restart.empty()),
      output_every_(input.output_every),
      note_(input, 0.0),
      cost_output_(solver_.costs().task("output")) {
  if (comm.is_root()) std::filesystem::create_directories(out_ + "/checkpoint");
  MPI_Barrier(comm.handle());
  if (restarted_) solver_.read_checkpoint(files.restart);
  note_ = SubstepNote(input, solver_.time());
}

void CoupledGas::meet(const DemHello& dem) {
  // Two that do not fit end here: the files of an earlier run stay as they are.
  if (!pairing_faults(dem, port_.hello()).empty()) return;
  port_.meet(dem);
  if (output_every_ <= 0) return;
  snapshots_ =
      std::make_unique<Snapshots>(out_, solver_.domain(), restarted_ ? solver_.time() : -1);
  written_ = snapshots_due();
}

// The end of an interval is a snapshot's time when the next multiple of `every` has been reached.
long CoupledGas::snapshots_due() const {
  constexpr double round_off = 1e-6;
  return static_cast<long>(std::floor(solver_.time() / output_every_ + round_off));
}

Report CoupledGas::advance() {
  try {
    done_ = port_.advance();
  } catch (const GasFault& fault) {
    port_.lend_anyway();
    return report_of_fault(fault);
  }
  return port_.report_of(done_);
}

void CoupledGas::end_interval() {
  if (const std::string text = note_.after(done_);
      !text.empty() && solver_.domain().comm().is_root()) {
    fmt::print("{}\n", text);
    std::fflush(stdout);
  }
  if (!snapshots_ || snapshots_due() <= written_) return;
  const Stopwatch watch(solver_.costs(), cost_output_);
  snapshots_->write(solver_);
  written_ = snapshots_due();
}

void CoupledGas::write_checkpoint(long dem_step) {
  const Stopwatch watch(solver_.costs(), cost_output_);
  solver_.write_checkpoint(fmt::format("{}/checkpoint/gas.{}.h5", out_, dem_step));
}

Report CoupledGas::write_autopsy(long dem_step) {
  try {
    solver_.write_checkpoint(fmt::format("{}/checkpoint/autopsy.gas.{}.h5", out_, dem_step));
  } catch (const Error& fault) {
    return report_of_fault(fault);
  }
  return {};
}

std::string CoupledGas::finish() {
  port_.finish_sends();
  return told_costs(solver_.costs(), solver_.domain().comm());
}

void CoupledGas::tell(MPI_Comm dem, const Report& report) {
  const Stopwatch watch(solver_.costs(), port_.cost_transport());
  send_report(solver_.domain().comm(), dem, report);
}

void CoupledGas::serve(MPI_Comm dem) {
  const Communicator& local = solver_.domain().comm();
  meet(greet_dem(local, dem, port_.hello()));
  while (true) {
    Command command;
    {
      const Stopwatch watch(solver_.costs(), port_.cost_wait());
      command = receive_command(local, dem);
    }
    switch (command.kind) {
      case CommandKind::couple:
        port_.begin(command);
        if (command.fresh != 0) port_.route(swap_boxes(dem, solver_.own()), dem, Sends::finished);
        port_.take_solids();
        if (const Report report = advance(); report.fault == 0) {
          tell(dem, report);
          end_interval();
        } else {
          tell(dem, report);
        }
        break;
      case CommandKind::checkpoint:
        write_checkpoint(command.step);
        send_report(local, dem, Report{});
        break;
      case CommandKind::autopsy:
        send_report(local, dem, write_autopsy(command.step));
        break;
      case CommandKind::finish:
        return send_text(local, dem, finish());
    }
  }
}

}  // namespace gasgrain
