// What was measured after a run: quantities with their uncertainty, and the curve behind them.
#pragma once

#include <string>
#include <vector>

namespace gasgrain {

struct Quantity {
  std::string name;
  double value = 0.0;
  std::string unit;
  double uncertainty = 0.0;  // standard error, in the same unit; 0 where there is one reading
};

// Columns of numbers for the picture, the first along its axis; NaN is written as an empty field.
struct Curve {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
};

struct Measurement {
  std::vector<Quantity> quantities;
  Curve curve;
  std::vector<std::string> notes;  // what was left out or cut, a sentence each
};

}  // namespace gasgrain
