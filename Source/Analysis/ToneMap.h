// The brightness of an object's sound for each struck vertex, a map over its surface (van den Doel,
// Kry & Pai 2001, Figure 7). Other code handles colours and files.
#pragma once

#include "Object/ModalObject.h"

#include <vector>

namespace idiophone {

/// The band of the modes that count.
inline constexpr double lowestToneHz = 20, highestToneHz = 20000;

/// Returns [V] the spectral centroid in Hz of the response to an impulse along the normal, struck
/// and heard at each shape vertex:
///
///     f(v) = Σ_i f_i E_i(v) / Σ_i E_i(v),    E_i = ½ Σ_j a_i a_j α_ij / (α_ij² + Δ_ij²)
///
/// with a_i = (φ_i(v) · n)², α_ij = α_i + α_j and Δ_ij = 2π(f_i − f_j). Σ E_i is the energy of the
/// sum of all a_i e^{−α_i t} cos 2πf_i t over the decay. E_i is a_i²/4α_i for a mode apart from
/// others, and does not depend on the basis of equal modes.
///
/// Modes have their damped frequencies at the reference material. Modes that do not oscillate are
/// left out. An undamped mode counts as if its T60 were ten minutes. Silent vertices have 0.
/// `normals` [N,3] are those of the mesh's vertices (vertexNormals).
std::vector<double> brightnessHz(const ModalObject& object, const std::vector<float>& normals);

} // namespace idiophone
