// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/implicit/node_fields.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace abut::geometry {

namespace {

/// Looks for nodes from the root on, and goes on below where one does not do.
class Search {
public:
    Search(const Part& part, const std::vector<int>& edges)
        : part_(part), merge_(merge_length(part)), is_held_(part.edges.size(), false), result_{{}, edges} {
        for (const int e : edges) is_held_[static_cast<std::size_t>(e)] = true;
        std::vector<int> all(part.edges.size());
        for (std::size_t e = 0; e < all.size(); ++e) all[e] = static_cast<int>(e);
        distance_ = edge_field(part, all, leaf_join_order);
    }

    void look_at(const NodeField& node, bool is_taken_away) {
        if (result_.rest.empty()) return;
        const ImplicitField field = is_taken_away ? negation(node.field) : node.field;
        const std::vector<int> held = held_alone(field);
        const bool is_new = std::any_of(held.begin(), held.end(), [&](int e) { return is_left(e); });
        if (is_new && !vanishes_inside(node, field)) {
            result_.fields.push_back(field);
            std::erase_if(result_.rest, [&](int e) { return std::find(held.begin(), held.end(), e) != held.end(); });
            return;
        }
        for (const NodeField& child : node.of) look_at(child, is_taken_away != child.is_taken_away);
    }

    HeldNodes result() && { return std::move(result_); }

private:
    bool is_left(int edge) const { return std::find(result_.rest.begin(), result_.rest.end(), edge) != result_.rest.end(); }

    /// The held edges that the field vanishes along; none where it is not positive on the others, as far as it is theirs to be.
    std::vector<int> held_alone(const ImplicitField& field) const {
        std::vector<int> along;
        for (std::size_t e = 0; e < part_.edges.size(); ++e) {
            bool vanishes = true;
            for (int k = 0; k <= held_samples; ++k) {
                const double w = value(field, point(part_.edges[e].curve, static_cast<double>(k) / held_samples));
                const bool is_end = k == 0 || k == held_samples;
                if (w < -merge_ || (!is_held_[e] && !is_end && w < merge_)) return {};
                vanishes = vanishes && w < merge_;
            }
            if (vanishes) along.push_back(static_cast<int>(e));
        }
        return along;
    }

    /// Signs do not tell where bodies abut.
    bool vanishes_inside(const NodeField& node, const ImplicitField& field) const {
        for (const Curve& curve : node.curves)
            for (int k = 0; k <= held_samples; ++k) {
                const Vec2 p = point(curve, static_cast<double>(k) / held_samples);
                if (std::abs(value(field, p)) < merge_ && value(distance_, p) > merge_ && contains(part_, p)) return true;
            }
        return std::any_of(node.of.begin(), node.of.end(),
                           [&](const NodeField& child) { return vanishes_inside(child, field); });
    }

    const Part& part_;
    double merge_;
    std::vector<bool> is_held_;
    ImplicitField distance_;
    HeldNodes result_;
};

}  // namespace

HeldNodes held_nodes(const CsgNode& tree, const Part& part, const std::vector<int>& edges) {
    Search search(part, edges);
    search.look_at(node_fields(tree), false);
    return std::move(search).result();
}

}  // namespace abut::geometry
