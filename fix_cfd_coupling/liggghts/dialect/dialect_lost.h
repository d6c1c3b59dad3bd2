// What the script wants of grains that leave the box: `thermo_modify lost`.
#pragma once

#include "fix_cfd_coupling/liggghts/host_access.h"
