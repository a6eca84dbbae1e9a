// Elimination orders. Internal to Analysis.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace idiophone {

/// Orders a symmetric pattern [n×n] by approximate minimum degree. Returns the unknown at each
/// place.
std::vector<int> minimumDegreeOrder(const Eigen::SparseMatrix<double>& symmetric);

/// Orders a symmetric pattern [n×n] by nested dissection (George 1973), and parts of a few hundred
/// unknowns by approximate minimum degree. Returns the unknown at each place. Large bodies need a
/// third of the work that minimum degree alone needs, and the two halves of each cut are
/// independent.
std::vector<int> nestedDissectionOrder(const Eigen::SparseMatrix<double>& symmetric);

} // namespace idiophone
