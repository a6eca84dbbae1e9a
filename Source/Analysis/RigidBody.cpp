#include "Analysis/RigidBody.h"

#include <Eigen/Geometry>

namespace idiophone {

MassProperties massPropertiesOf(const VibrationModel& model, const Eigen::MatrixXd& pointsMetres) {
    const Eigen::Index points = pointsMetres.rows();
    const auto mass = model.mass.selfadjointView<Eigen::Lower>();
    Eigen::MatrixXd shifts = Eigen::MatrixXd::Zero(3 * points, 3);
    for (Eigen::Index p = 0; p < points; ++p)
        shifts.middleRows<3>(3 * p).setIdentity();
    const Eigen::MatrixXd momenta = mass * shifts;
    MassProperties result;
    result.massKg = momenta.col(0).dot(shifts.col(0));
    // The momentum of a unit shift along x, weighted by position, is the mass times the centre.
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (Eigen::Index p = 0; p < points; ++p)
        centre += momenta(3 * p, 0) * pointsMetres.row(p).transpose() / result.massKg;
    Eigen::MatrixXd turns(3 * points, 3);
    for (Eigen::Index p = 0; p < points; ++p) {
        const Eigen::Vector3d arm = pointsMetres.row(p).transpose() - centre;
        for (int axis = 0; axis < 3; ++axis)
            turns.block<3, 1>(3 * p, axis) = Eigen::Vector3d::Unit(axis).cross(arm);
    }
    const Eigen::Matrix3d inertia = turns.transpose() * (mass * turns);
    Eigen::Map<Eigen::Vector3d>(result.centreMetres.data()) = centre;
    Eigen::Map<Eigen::Matrix3d>(result.inertiaKgM2.data()) = inertia; // symmetric: any order
    return result;
}

} // namespace idiophone
