// Values of the formulas that DEM scripts have in `variable NAME equal FORMULA` and in `if`.
#pragma once

#include <string>

namespace gasgrain {

// Numbers, + - * / ^, comparisons (1 or 0), && || !, and the functions of the scripts: round, ceil,
// floor, sqrt, exp, ln, log (base 10), sin, cos, tan, asin, acos, atan, abs; PI. Everything else,
// what only a running host knows included, is an Error that says what of the formula is unknown.
double formula_value(const std::string& formula);

}  // namespace gasgrain
