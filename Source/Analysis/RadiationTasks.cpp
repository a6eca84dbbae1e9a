#include "Analysis/RadiationTasks.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

namespace idiophone {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr double lowestHz = 20, highestHz = 22000;
constexpr double samePole = 1e-9;

/// Interpolates the weights of the modes of one pole in one direction, 0 ≤ share ≤ 1. The common
/// magnitude is interpolated by its logarithm, the common phase along the shorter arc. The result
/// is linear in both arguments, so it does not depend on the basis of equal poles.
Eigen::RowVectorXcd
between(const Eigen::RowVectorXcd& from, const Eigen::RowVectorXcd& to, double share) {
    const double fromSize = from.norm(), toSize = to.norm();
    if (fromSize == 0 || toSize == 0)
        return (1 - share) * from + share * to;
    const double turn = std::arg(from.dot(to)); // Eigen's dot() conjugates the first vector
    const double size = std::pow(fromSize, 1 - share) * std::pow(toSize, share);
    return std::polar(size * (1 - share) / fromSize, share * turn) * from +
           std::polar(size * share / toSize, (share - 1) * turn) * to;
}

/// Returns the weights [D×count] of the modes of one pole at another frequency.
Eigen::MatrixXcd interpolated(std::span<const RadiationTask> grid,
                              double frequencyHz,
                              Index firstMode,
                              Index count) {
    const auto above = std::ranges::lower_bound(grid, frequencyHz, {}, &RadiationTask::frequencyHz);
    if (above == grid.begin())
        return grid.front().weights.middleCols(firstMode, count);
    if (above == grid.end())
        return grid.back().weights.middleCols(firstMode, count);
    const auto below = above - 1;
    const double share = std::log(frequencyHz / below->frequencyHz) /
                         std::log(above->frequencyHz / below->frequencyHz);
    Eigen::MatrixXcd result(below->weights.rows(), count);
    for (Index direction = 0; direction < result.rows(); ++direction)
        result.row(direction) =
            between(below->weights.row(direction).segment(firstMode, count),
                    above->weights.row(direction).segment(firstMode, count), share);
    return result;
}

} // namespace

double audibleHz(double frequencyHz) {
    return std::clamp(frequencyHz, lowestHz, highestHz);
}

std::vector<RadiationTask> ownTasks(const Eigen::VectorXd& frequenciesHz, double sameFrequency) {
    std::vector<RadiationTask> tasks;
    for (Index mode = 0, first = 0; mode < frequenciesHz.size(); ++mode) {
        if (tasks.empty() || frequenciesHz(mode) > frequenciesHz(first) * (1 + sameFrequency)) {
            tasks.emplace_back();
            first = mode;
        }
        tasks.back().modes.push_back(mode);
        tasks.back().frequencyHz = audibleHz(std::sqrt(frequenciesHz(first) * frequenciesHz(mode)));
    }
    return tasks;
}

std::vector<RadiationTask> gridTasks(const Eigen::VectorXd& frequenciesHz,
                                     const std::vector<double>& ratios) {
    const double first = audibleHz(frequenciesHz.minCoeff() * ratios.front()),
                 last = audibleHz(frequenciesHz.maxCoeff() * ratios.back());
    std::vector<Index> all(frequenciesHz.size());
    std::iota(all.begin(), all.end(), Index{0});
    std::vector<RadiationTask> tasks;
    for (int step = 0;; ++step) {
        const double frequencyHz = audibleHz(lowestHz * std::exp2(step / 2.0));
        if (frequencyHz * std::numbers::sqrt2 > first)
            tasks.push_back({frequencyHz, all});
        if (frequencyHz >= last)
            return tasks;
    }
}

RadiationTable tableOf(std::span<const RadiationTask> own,
                       std::span<const RadiationTask> grid,
                       const Eigen::VectorXd& frequenciesHz,
                       const std::vector<double>& frequencyRatios) {
    const Index modes = frequenciesHz.size(), directions = own.front().weights.rows();
    const auto ratios = static_cast<Index>(frequencyRatios.size());
    RadiationTable table{.directions = {}, .frequencyRatios = frequencyRatios, .weights = {}};
    table.weights.resize(directions * ratios * modes);
    const auto store = [&](Index ratio, Index mode, const Eigen::VectorXcd& weights) {
        for (Index direction = 0; direction < directions; ++direction)
            table.weights[(direction * ratios + ratio) * modes + mode] =
                std::complex<float>(weights(direction));
    };
    for (Index ratio = 0; ratio < ratios; ++ratio) {
        const double value = frequencyRatios[ratio];
        if (std::abs(value - 1) > 1e-9) {
            for (Index first = 0, next = 0; first < modes; first = next) {
                while (next < modes && frequenciesHz(next) <= frequenciesHz(first) * (1 + samePole))
                    ++next;
                const auto weights = interpolated(grid, audibleHz(value * frequenciesHz(first)),
                                                  first, next - first);
                for (Index mode = first; mode < next; ++mode)
                    store(ratio, mode, weights.col(mode - first));
            }
            continue;
        }
        for (const RadiationTask& task : own)
            for (std::size_t k = 0; k < task.modes.size(); ++k)
                store(ratio, task.modes[k], task.weights.col(k));
    }
    return table;
}

} // namespace idiophone
