// Converts vectors and poses between Eigen and Bullet.
#pragma once

#include <Eigen/Geometry>
#include <btBulletDynamicsCommon.h>

namespace idiophone {

inline btVector3 toBullet(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

inline Eigen::Vector3d toEigen(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}

inline btTransform toBullet(const Eigen::Isometry3d& pose) {
    const Eigen::Quaterniond turn(pose.linear());
    return btTransform(btQuaternion(turn.x(), turn.y(), turn.z(), turn.w()),
                       toBullet(pose.translation()));
}

inline Eigen::Isometry3d toEigen(const btTransform& transform) {
    const btQuaternion turn = transform.getRotation();
    return Eigen::Translation3d(toEigen(transform.getOrigin())) *
           Eigen::Quaterniond(turn.w(), turn.x(), turn.y(), turn.z());
}

} // namespace idiophone
