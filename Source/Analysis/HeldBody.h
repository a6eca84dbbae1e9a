// A body whose clamped points do not move: fewer rows, and the forces that hold it.
#pragma once

#include "Analysis/BodyModel.h"
#include "Analysis/Eigensolver.h"

#include <Eigen/Core>
#include <vector>

namespace idiophone {

/// Gives the body its support. `mesh`, in metres, is the one whose faces and vertices the support
/// names. Error, one sentence: one of them does not exist.
Result<void> holdBody(BodyModel& body, const Mesh& mesh, const Support& support);

/// Returns, for each row of the body's model, whether the body's clamps hold it; empty if it has
/// none. A shell is held in both of its layers. Errors, each one sentence: the clamps hold no
/// point, or all.
Result<std::vector<bool>> heldRows(const BodyModel& body);

/// As `solveModes`, for a model whose held rows [n] do not move. Their shapes are 0. Without held
/// rows the model is free.
Result<Modes> solveHeldModes(const VibrationModel& model,
                             const std::vector<bool>& held,
                             const FrequencyBand& band,
                             const WorkControl& control = {});

/// Returns the force of the support on the body in each mode, in N for a modal amplitude of
/// 1 m √kg: F = Σ (K − λM) φ over the held rows. The three rows of each point follow each other.
Eigen::Matrix3Xd
supportForces(const VibrationModel& model, const std::vector<bool>& held, const Modes& modes);

/// Returns the resistance with which α of the four lowest modes is at most ω/(2Q). It is 0 if none
/// of them pulls at the support.
double
resistanceOf(double quality, const Eigen::Matrix3Xd& forces, const Eigen::VectorXd& eigenvalues);

/// Returns the decay rates [M] that a resistance R of the support adds: α = |F|²/(2 R ω²). The
/// power that reaches a support much heavier than the body is |F|²/(2R).
std::vector<double> supportDecays(const Eigen::Matrix3Xd& forces,
                                  const Eigen::VectorXd& eigenvalues,
                                  double resistanceNsPerM);

} // namespace idiophone
