// How bright an object sounds where it is struck: a map over its surface (van den Doel, Kry & Pai
// 2001, Figure 7). Colours and files are others' business.
#pragma once

#include "Object/ModalObject.h"

#include <vector>

namespace idiophone {

/// The band whose modes count.
inline constexpr double lowestToneHz = 20, highestToneHz = 20000;

/// [V] the spectral centroid in Hz of what an impulse along the normal sounds like at each vertex
/// that carries shapes, heard there:
///
///     f(v) = Σ_i f_i E_i(v) / Σ_i E_i(v),    E_i = ½ Σ_j a_i a_j α_ij / (α_ij² + Δ_ij²)
///
/// with a_i = (φ_i(v) · n)², α_ij = α_i + α_j and Δ_ij = 2π(f_i − f_j): the energy of the sum of
/// all a_i e^{−α_i t} cos 2πf_i t over the decay, which is a_i²/4α_i of a mode apart from others,
/// and does not depend on the basis of equal ones. Modes sound at their damped frequencies at the
/// reference material; those that do not oscillate, and an undamped one as if its T60 were ten
/// minutes. 0 where nothing sounds. `normals` [N,3] are those of the mesh's vertices
/// (vertexNormals).
std::vector<double> brightnessHz(const ModalObject& object, const std::vector<float>& normals);

} // namespace idiophone
