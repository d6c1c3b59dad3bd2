// Gas fields over time for ParaView: <folder>/gas.h5 holds a group /NNNNNN a snapshot (datasets
// void_fraction, pressure, velocity in (z, y, x) order, attribute `time`), <folder>/gas.xdmf names
// them. Both are whole after every snapshot, so that a killed run can be looked at.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gas_solver/gas_step.h"

namespace gasgrain {

class ParallelFile;

class Snapshots {
 public:
  // A new file; with `restart_time` (>= 0) one that is there is gone on with, snapshots after that
  // time being dropped. Throws Error when it holds another grid.
  Snapshots(const std::string& folder, const Domain& domain, double restart_time = -1);
  ~Snapshots();

  // Whether the last one is of this time: a run that goes on in its folder has that it begins with.
  [[nodiscard]] bool end_at(double time) const;
  // Collective.
  void write(const GasSolver& gas);

 private:
  void write_xdmf() const;

  std::string folder_;
  const Domain& domain_;
  std::unique_ptr<ParallelFile> file_;
  struct Snapshot {
    double time;
    std::vector<std::string> scalars;  // its fields, but the velocity
  };
  std::vector<Snapshot> snapshots_;
};

}  // namespace gasgrain
