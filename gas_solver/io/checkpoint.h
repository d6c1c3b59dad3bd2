// The file a run goes on from. A writer and a reader with the same calls, so that one list of
// fields serves both. The file is written beside its name and renamed when whole: a run that is
// killed while it writes, or whose disk is full, leaves the checkpoint before.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "gas_solver/grid/domain.h"

namespace gasgrain {

class ParallelFile;

// Names of gas.toml with what they were, as numbers.
using CheckpointChoices = std::vector<std::pair<std::string, double>>;

// What the two have in common: the share of a field in the file.
class CheckpointFile {
 public:
  CheckpointFile(const std::string& file, const Domain& domain);
  ~CheckpointFile();

 protected:
  // Cells (component -1), or faces with those on the far side of the domain.
  [[nodiscard]] Int3 whole(int component) const;
  [[nodiscard]] IndexBox share(int component) const;

  std::string name_;
  const Domain& domain_;
  std::unique_ptr<ParallelFile> file_;
};

class CheckpointWriter : public CheckpointFile {
 public:
  CheckpointWriter(const std::string& file, const Domain& domain);
  ~CheckpointWriter();
  CheckpointWriter(const CheckpointWriter&) = delete;
  CheckpointWriter& operator=(const CheckpointWriter&) = delete;
  void choices(const CheckpointChoices& made);
  void number(const std::string& name, double value);
  void flag(const std::string& name, bool value) { number(name, value ? 1.0 : 0.0); }
  void field(const std::string& name, int component, const Array3<double>& values);
  // Renames the file when it is whole on all ranks and on the disk. Without it nothing is left.
  void finish();
};

class CheckpointReader : public CheckpointFile {
 public:
  // Throws Error when the file is of another format version or another grid.
  CheckpointReader(const std::string& file, const Domain& domain);
  // Throws Error, which names them, when the file was written with other choices.
  void require_choices(const CheckpointChoices& made);
  void number(const std::string& name, double& value);
  void flag(const std::string& name, bool& value);
  void field(const std::string& name, int component, Array3<double>& values);
};

}  // namespace gasgrain
