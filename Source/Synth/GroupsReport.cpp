// SPDX-License-Identifier: Apache-2.0
#include "Synth/GroupsReport.h"

namespace idiophone {

namespace {

GroupStanding
standing(const ModeGroups& groups, const ActiveModes& active, std::size_t g) noexcept {
    if (active.modes().isMixed(g))
        return GroupStanding::sounding;
    if (!groups.inBand(g))
        return GroupStanding::outOfBand;
    if (groups.silenced(g))
        return GroupStanding::silenced;
    return active.modes().rings(g) ? GroupStanding::beyondBudget : GroupStanding::belowTau;
}

} // namespace

void reportGroups(const ModeGroups& groups,
                  const ActiveModes& active,
                  std::int64_t cell,
                  SoundingGroups& report) noexcept {
    const GroupConditions& conditions = groups.conditions();
    report.law = conditions.law;
    report.thicknessRatio = conditions.thicknessRatio;
    report.tauPascals = active.tau();
    report.compression = conditions.compression;
    report.groupsAreBehind = groups.areBehind();
    report.count = 0;
    report.starts[0] = 0;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const std::int32_t end = groups.starts()[g + 1];
        if (static_cast<std::size_t>(end) > report.amplitudes.size())
            break;
        report.starts[g + 1] = end;
        report.amplitudes[g] = active.blocks().amplitude(g, cell);
        report.standings[g] = standing(groups, active, g);
        report.count = g + 1;
    }
}

} // namespace idiophone
