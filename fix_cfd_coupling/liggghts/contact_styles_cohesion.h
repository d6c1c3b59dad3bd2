// The LIST of our cohesion models, one header each. A header is written as the host's own are:
// where COHESION_MODEL is defined it emits its line COHESION_MODEL(CONSTANT, name, id), else its
// class. A new model is one line here; the build compiles its combinations
// (contact_styles_compiled.h). Ids are below 64; the host has 1, 2, 7 and 8.
#include "fix_cfd_coupling/liggghts/cohesion_model_bridge.h"
#include "fix_cfd_coupling/liggghts/cohesion_model_electrostatic.h"
#include "fix_cfd_coupling/liggghts/cohesion_model_jkr.h"
#include "fix_cfd_coupling/liggghts/cohesion_model_sintered_neck.h"
#include "fix_cfd_coupling/liggghts/cohesion_model_van_der_waals.h"
