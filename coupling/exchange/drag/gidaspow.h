// Gidaspow's drag law: `ergun_wen_yu` under the name that the literature of fluidized beds uses.
//
//   eps < 0.8:   Ergun's beta
//   eps >= 0.8:  Wen and Yu's beta with eps^-2.65 and C_d = 24 / Re (1 + 0.15 Re^0.687), 0.44 from
//                Re = 1000;  Re = eps rho |u - v| d / mu
//
// Source: J. Ding, D. Gidaspow, AIChE J. 36 (1990) 523; D. Gidaspow, Multiphase Flow and
//   Fluidization, Academic Press (1994).
// Inputs, output, assumptions, range: as ergun_wen_yu.h.
// Deviations: none. Switch, C_d and exponent are those that Hoomans et al. (2001) print as eqs
//   27-30, term by term; only the point eps = 0.8 itself, given to Ergun by some, is Wen and Yu's
//   here. For a law without the jump see gidaspow_blend.h.
#pragma once

#include "coupling/exchange/drag/ergun_wen_yu.h"

namespace gasgrain {

struct DragGidaspow : DragErgunWenYu {
  static constexpr std::string_view name = "gidaspow";
  static constexpr std::string_view source = "Gidaspow (1994)";
};

}  // namespace gasgrain
