// A place on a key's strip.
#pragma once

namespace idiophone {

struct StrikePlace {
    double along = 0;  ///< 0 to 1 on the strip
    double across = 0; ///< −1 to 1
};

} // namespace idiophone
