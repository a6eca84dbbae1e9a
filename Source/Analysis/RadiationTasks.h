// The tasks that Radiation solves, and the table of their results. Internal to Analysis.
#pragma once

#include "Object/RadiationTable.h"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace idiophone {

/// Some modes that are solved together at one frequency.
struct RadiationTask {
    double frequencyHz = 0;
    std::vector<Eigen::Index> modes;
    Eigen::MatrixXcd weights = {};       ///< [D×modes]
    Eigen::MatrixXcd nearPressures = {}; ///< [P×modes]
};

/// Clamps to 20 Hz to 22 kHz.
double audibleHz(double frequencyHz);

/// Returns tasks for modes at their own frequencies in Hz, ascending. Modes that differ by less
/// than the share `sameFrequency` become one task.
std::vector<RadiationTask> ownTasks(const Eigen::VectorXd& frequenciesHz, double sameFrequency);

/// Returns tasks for all modes at half octaves, over the range that the ratios need.
std::vector<RadiationTask> gridTasks(const Eigen::VectorXd& frequenciesHz,
                                     const std::vector<double>& ratios);

/// Returns the table from both kinds of solved tasks, without its directions.
RadiationTable tableOf(std::span<const RadiationTask> own,
                       std::span<const RadiationTask> grid,
                       const Eigen::VectorXd& frequenciesHz,
                       const std::vector<double>& frequencyRatios);

} // namespace idiophone
