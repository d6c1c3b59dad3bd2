// The LIST of our laws of rolling friction, as that of the cohesion laws:
// ROLLING_LAW(Class, name, id).
#include "fix_cfd_coupling/dem_physics/contact/rolling_limited.h"
#include "fix_cfd_coupling/dem_physics/contact/rolling_viscous.h"
