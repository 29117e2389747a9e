// SPDX-License-Identifier: GPL-3.0-or-later
// Mirror symmetric assemblies solved on the half, by folding the full basis: unknowns are the amplitudes of its symmetric
// combinations, so the answer is that of the whole, not that of another discretisation.
//
// Legend: M the mirror's action on displacement coefficients (a permutation with signs), u = T y the symmetric displacements, T
// orthonormal. Of a part that is its own image, columns of T are e_i where M e_i = e_i, (e_i + M e_i) / sqrt(2) elsewhere, none
// where M e_i = -e_i. Of two parts that are each other's images the first, the leader, is solved: u_1 = y / sqrt(2),
// u_2 = M u_1. Pressures of mirrored rows are equal, or opposite for tangential ones.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "solver/parts/mirror.hpp"
#include "solver/parts/part_system.hpp"

namespace abut::solver {

enum class MirrorRole { own_image, leader, follower };

struct PartMirror {
    MirrorRole role;
    int image;         ///< among the assembly's parts
    PlaceImage place;  ///< in the image's frame
    /// (2n) coefficient of the image, and the sign that goes with it.
    std::vector<int> coefficient;
    std::vector<double> sign;
};
/// function: of the image, by function.
PartMirror part_mirror(MirrorRole role, int image, const PlaceImage& place, const std::vector<int>& function);

/// What a displacement of the part is on its image (2n).
Eigen::VectorXd mirrored(const PartMirror& mirror, const Eigen::VectorXd& displacement);

/// Is the part solved as the image of another?
bool is_follower(const PartInput& input);
/// Are its rows folded?
bool is_folded(const PartInput& input);

/// Motions that are symmetric: of a part that is its own image those along the mirror line, of a follower none.
void keep_symmetric_motions(PartSystem& system);

/// Numbers and shares of the rows; pinned: coefficients that are held besides those dropped.
void fold_unknowns(PartSystem& system, const std::vector<Eigen::Index>& pinned);

/// T'A T in the rows of number[], with their shares.
SparseSymmetric folded(const BlockMatrix& a, const std::vector<int>& number, const std::vector<double>& share, int n_kept);

/// T'f, and u += T y.
Eigen::VectorXd folded_load(const PartSystem& system, const Eigen::VectorXd& load);
void add_unfolded(const PartSystem& system, const Eigen::VectorXd& y, Eigen::VectorXd& u);

/// Of size 1, without any symmetry; the same at every call.
Eigen::VectorXd test_field(Eigen::Index n, std::uint64_t seed);

/// Entries of a matrix or a load that differ from their image by more than this fraction of the largest are not symmetric.
inline constexpr double asymmetry = 1e-8;

/// Why a part and its image do not answer mirrored displacements with mirrored forces, or are not loaded alike; empty: they do.
std::string asymmetry_of(const PartSystem& part, const PartSystem& image);

}  // namespace abut::solver
