// history.csv: the numbers of a run over time, a line an interval. Written by the root.
#pragma once

#include <fstream>
#include <string>

#include "gas_solver/gas_step.h"

namespace gasgrain {

class History {
 public:
  // With `restart_time` (>= 0) a file that is there is gone on with, lines after that time dropped.
  History(const std::string& folder, const GasInput& input, double restart_time = -1);
  void add(const GasReport& report);

 private:
  void flush();

  std::string name_;
  std::ofstream out_;
};

}  // namespace gasgrain
