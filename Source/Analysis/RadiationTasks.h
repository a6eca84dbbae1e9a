// What Radiation solves, and the table that comes of it. Internal to Analysis.
#pragma once

#include "Object/RadiationTable.h"

#include <Eigen/Core>
#include <vector>

namespace idiophone {

/// What is solved at once: some modes at one frequency.
struct RadiationTask {
    double frequencyHz = 0;
    std::vector<Eigen::Index> modes;
    Eigen::MatrixXcd weights = {};       ///< [D×modes]
    Eigen::MatrixXcd nearPressures = {}; ///< [P×modes]
};

/// Within 20 Hz to 22 kHz.
double audibleHz(double frequencyHz);

/// Modes at their own frequencies, in Hz and ascending; those that differ by less than a share at
/// one.
std::vector<RadiationTask> ownTasks(const Eigen::VectorXd& frequenciesHz, double sameFrequency);

/// All modes at half octaves, as far as any ratio asks for.
std::vector<RadiationTask> gridTasks(const Eigen::VectorXd& frequenciesHz,
                                     const std::vector<double>& ratios);

/// Without its directions, from both when they are solved.
RadiationTable tableOf(const std::vector<RadiationTask>& own,
                       const std::vector<RadiationTask>& grid,
                       const Eigen::VectorXd& frequenciesHz,
                       const std::vector<double>& frequencyRatios);

} // namespace idiophone
