#include "Analysis/Soundboard.h"

#include "Analysis/Monopole.h"

#include <cmath>

namespace idiophone {

void addBoard(RadiationTable& table,
              const Eigen::VectorXd& eigenvalues,
              const Eigen::RowVectorXd& upwardForces,
              const Eigen::Vector3d& placeMetres,
              double boardKgPerM2) {
    const std::array<double, 3> place{placeMetres.x(), placeMetres.y(), placeMetres.z()};
    const std::size_t ratios = table.frequencyRatios.size();
    auto weight = table.weights.begin();
    for (std::size_t row = 0; row < table.directions.size() * ratios; ++row)
        for (Eigen::Index mode = 0; mode < eigenvalues.size(); ++mode) {
            const double omega = table.frequencyRatios[row % ratios] * std::sqrt(eigenvalues(mode));
            // At another frequency the force follows λ, so the flow per velocity stays.
            const double flow = 2 * upwardForces(mode) / (eigenvalues(mode) * boardKgPerM2);
            *weight++ +=
                std::complex<float>(flow * monopole(omega, table.directions[row / ratios], place));
        }
}

} // namespace idiophone
