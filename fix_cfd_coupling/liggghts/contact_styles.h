// Our contact sub-models among the host's: what `pair_style gran ... cohesion NAME rolling_friction
// NAME` and `fix wall/gran` may name.
//
// The host makes a pair style or a wall from the hash of its sub-models. The combinations that
// users need are compiled here as the host compiles its own; every other one that holds a model of
// ours is put together at run time (contact_styles_runtime.h), with the same numbers.
#pragma once

namespace gasgrain {

// Once per process; further calls do nothing. The environment's GASGRAIN_CONTACT_STYLES=runtime
// leaves the compiled combinations out, for comparisons.
void register_contact_styles();

}  // namespace gasgrain
