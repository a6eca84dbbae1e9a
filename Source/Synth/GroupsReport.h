// SPDX-License-Identifier: Apache-2.0
// Copies the groups of a resonator for display.
#pragma once

#include "Synth/ActiveModes.h"
#include "Synth/SoundingGroups.h"

#include <cstdint>

namespace idiophone {

/// Reports the groups as heard in a cell.
void reportGroups(const ModeGroups& groups,
                  const ActiveModes& active,
                  std::int64_t cell,
                  SoundingGroups& report) noexcept;

} // namespace idiophone
