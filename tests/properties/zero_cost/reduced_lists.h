// The LISTs of a build that knows one scene's effects and no others; included before everything
// else of it. The scene: drag of Koch and Hill, pressure gradient, trilinear weighting, and a
// laminar, incompressible gas. A std::variant holds at least one type: of the turbulence models one
// is left, which the scene does not use.
#pragma once

#define GASGRAIN_FORCES ForcePressureGradient
#define GASGRAIN_DRAG_MODELS DragKochHill
#define GASGRAIN_VOID_FRACTION_METHODS VoidFractionTrilinear
#define GASGRAIN_MOMENTUM_SHARINGS SharingScheme3
#define GASGRAIN_CONVECTION_SCHEMES ConvectionTvd
#define GASGRAIN_QUANTITIES ConstantQuantity
#define GASGRAIN_TURBULENCE_MODELS Smagorinsky
