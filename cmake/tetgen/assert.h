// Found instead of the system's header while TetGen is compiled, and only then: see TetGenWatch.
#pragma once
#include "Analysis/TetGenWatch.h"
#define assert(condition) idiophone::checkInTetGen(static_cast<bool>(condition))
