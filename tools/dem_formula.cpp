#include "tools/dem_formula.h"

#include <muParser.h>

#include <cmath>

#include "coupling/base/error.h"
#include "coupling/exchange/sphere.h"

namespace gasgrain {
namespace {

double negated(double value) {
  return value == 0.0 ? 1.0 : 0.0;
}

mu::Parser make_parser() {
  mu::Parser parser;
  parser.ClearFun();  // its log is the natural one
  const auto define = [&](const char* name, mu::fun_type1 function) {
    parser.DefineFun(name, function);
  };
  define("round", [](double x) { return std::round(x); });
  define("ceil", [](double x) { return std::ceil(x); });
  define("floor", [](double x) { return std::floor(x); });
  define("sqrt", [](double x) { return std::sqrt(x); });
  define("exp", [](double x) { return std::exp(x); });
  define("ln", [](double x) { return std::log(x); });
  define("log", [](double x) { return std::log10(x); });
  define("sin", [](double x) { return std::sin(x); });
  define("cos", [](double x) { return std::cos(x); });
  define("tan", [](double x) { return std::tan(x); });
  define("asin", [](double x) { return std::asin(x); });
  define("acos", [](double x) { return std::acos(x); });
  define("atan", [](double x) { return std::atan(x); });
  define("abs", [](double x) { return std::abs(x); });
  parser.DefineInfixOprt("!", negated);
  parser.ClearConst();
  parser.DefineConst("PI", pi);
  return parser;
}

}  // namespace

double formula_value(const std::string& formula) {
  try {
    mu::Parser parser = make_parser();
    parser.SetExpr(formula);
    return parser.Eval();
  } catch (const mu::Parser::exception_type& e) {
    fail("\"{}\" has no value that can be known without a run: {}", formula, e.GetMsg());
  }
}

}  // namespace gasgrain
