// The pressure systems of gas_pressure_cases.h on 4 ranks.
#include "tests/unit/gas_pressure_cases.h"
#include "tests/unit/gas_pressure_multigrid_cases.h"
