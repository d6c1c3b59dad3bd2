// The LIST of drag laws. A new one is a header beside the others and a line here; the property
// tests then cover it. A law is a struct with `name`, `source`, `range`, `eps_switches` (void
// fractions at which its published branches do not meet), `stokes_limit` and
//   static double coefficient(const GasProperties&, double eps, double slip_speed, double diameter)
// which returns K [kg/s] of F = K (u - v), model A, interstitial slip; positive and finite for eps
// from `least_drag_void_fraction` to 1 and any slip from 0.
#pragma once

#include <variant>

#include "coupling/base/choice_list.h"
#include "coupling/exchange/drag/beetstra.h"
#include "coupling/exchange/drag/di_felice.h"
#include "coupling/exchange/drag/ergun_wen_yu.h"
#include "coupling/exchange/drag/gidaspow.h"
#include "coupling/exchange/drag/gidaspow_blend.h"
#include "coupling/exchange/drag/hill_koch_ladd.h"
#include "coupling/exchange/drag/koch_hill.h"
#include "coupling/exchange/drag/schiller_naumann.h"
#include "coupling/exchange/drag/tang.h"
#include "coupling/exchange/drag/tenneti.h"

namespace gasgrain {

// A build may list fewer (coupling/base/listed.h).
#ifndef GASGRAIN_DRAG_MODELS
#define GASGRAIN_DRAG_MODELS                                                                     \
  DragErgunWenYu, DragKochHill, DragDiFelice, DragGidaspow, DragGidaspowBlend, DragHillKochLadd, \
      DragBeetstra, DragTenneti, DragTang, DragSchillerNaumann
#endif
using DragModel = std::variant<GASGRAIN_DRAG_MODELS>;

// No packing of spheres is denser than 0.26; a method that puts a whole particle into one cell can
// report less, and no law means anything there.
inline constexpr double least_drag_void_fraction = 0.2;

}  // namespace gasgrain
