// The LIST of cohesion laws, one header each, for every host. A header is read in two ways: where
// COHESION_LAW is defined it emits its line COHESION_LAW(Class, name, id), else its class. A new
// law is one line here: the builds of the hosts read it. A name is what scripts write; an id is
// written to restarts. Ids: 20 to 39, from 40 for laws that are built elsewhere (below 64).
#include "fix_cfd_coupling/dem_physics/contact/cohesion_bridge.h"
#include "fix_cfd_coupling/dem_physics/contact/cohesion_electrostatic.h"
#include "fix_cfd_coupling/dem_physics/contact/cohesion_jkr.h"
#include "fix_cfd_coupling/dem_physics/contact/cohesion_sintered_neck.h"
#include "fix_cfd_coupling/dem_physics/contact/cohesion_van_der_waals.h"
