// The pressure systems of gas_pressure_cases.h on 1 rank.
#include "tests/unit/gas_pressure_cases.h"
#include "tests/unit/gas_pressure_multigrid_cases.h"
