// The LIST of our models of rolling friction, as that of the cohesion models:
// ROLLING_MODEL(CONSTANT, name, id). Ids are below 64; the host has 1 to 4 and 6.
#include "fix_cfd_coupling/liggghts/rolling_model_limited.h"
#include "fix_cfd_coupling/liggghts/rolling_model_viscous.h"
