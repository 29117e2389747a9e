// SPDX-License-Identifier: GPL-3.0-or-later
// Tensor B-splines taken apart where their support inside the part is: the first half of make_space.
#pragma once
#include <map>
#include <vector>

#include "solver/splines/element_graph.hpp"

namespace abut::solver {

/// The branches of a grid's tensor functions: number k < n_tensor is the first branch of tensor function k; the others follow.
struct Branches {
    std::vector<int> tensor_of_extra;
    std::map<int, std::vector<int>> of_element;  ///< of elements that have other than first branches: all, x fastest
};

/// The elements of a branch's support that hold material, ascending by cell.
std::vector<int> support_elements(const SplineSpace& space, const ElementGraph& graph, int branch);

/// Takes the tensor functions apart into branches. Cost O(tensor functions x cells of a support).
Branches find_branches(const KnotVector& x, const KnotVector& y, const ElementGraph& graph);

}  // namespace abut::solver
