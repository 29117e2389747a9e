// SPDX-License-Identifier: GPL-3.0-or-later
// Weight functions out of the edges and points that hold a component, and blends of what is prescribed there.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/implicit/implicit.hpp"
#include "geometry/implicit/jet.hpp"
#include "geometry/implicit/node_fields.hpp"
#include "solver/terms/solution_structure.hpp"

namespace abut {

/// A function of the plane with its derivatives; only first ones are meant.
using JetField = std::function<geometry::Jet(const geometry::Vec2&)>;

/// A function that vanishes on edges or points, dimensionless: 1 stands for the part's size.
struct WeightField {
    JetField field;
    bool is_linear = false;
};

/// How the weights of edges are made.
enum class EdgeWeights {
    /// All collinear edges whose line leaves the part on one side, and touches it nowhere else, as one linear field; each other
    /// one as geometry::edge_field, which is trimmed to it. Cost of making it O(edges^2).
    joined,
    /// R-functions of the tree's nodes that the edges bound the part by (geometry::held_nodes); of the others the whole lines,
    /// circles and ellipses that they lie on, each once [Grishin10, eqs 3.3-3.7, 4.12-4.13]: nothing is trimmed.
    r_function,
    /// One blended distance to all of them [Grishin10, eqs 3.18-3.19].
    blended
};
EdgeWeights edge_weights(const std::string& word);

/// The weights of whole edges. `tree`: what the part is the value of, at the same place; only r_function asks for it.
std::vector<WeightField> edge_fields(const geometry::Part& part, const std::vector<int>& edges, double size, EdgeWeights how,
                                     const geometry::CsgNode& tree);

/// The first of the edges whose whole line, circle or ellipse is needed and passes through the part where no edge of them is:
/// as an r_function it would hold the part there, too. Looked at: `geometry::held_samples` points of every edge.
std::optional<int> edge_that_holds_more(const geometry::Part& part, const std::vector<int>& edges, double size,
                                        const geometry::CsgNode& tree);

/// The weight of held points: zero at each of them.
WeightField point_weight(const std::vector<geometry::Vec2>& points, double size);

/// The R-conjunction (alpha = 0) of fields, neighbours first; linear only if it is one field.
WeightField conjoined(const std::vector<WeightField>& fields);

/// What one support prescribes for a component, and the function that vanishes where it does.
struct PrescribedField {
    WeightField distance;
    JetField value;
};
/// The transfinite interpolation of prescribed fields: sum of g_k / d_k^2 over sum of 1 / d_k^2 [Grishin10, eq 3.8; Rvachev et
/// al. 2001].
JetField blended(const std::vector<PrescribedField>& fields);

/// A field as the solver takes it. Where the derivatives do not exist (corners) it takes those a little farther towards
/// `inside`: inward_step of the way.
solver::ScalarField scalar_field(const JetField& field, const geometry::Vec2& inside);
inline constexpr double inward_step = 1e-7;

}  // namespace abut
