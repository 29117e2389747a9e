// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/placed_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "src/analysis/face_motion.hpp"
#include "src/analysis/placement.hpp"
#include "src/base/index.hpp"
#include "src/motion/placement.hpp"
#include "src/solution/contact_measures.hpp"

namespace abut {

namespace {

PlacedFace placed_face(const Scene& scene, const SolvedAssembly& solved, std::size_t contact, std::size_t side) {
    const std::size_t part = at(solved.contacts[contact].face.part[side]);
    const PartOnGrid& grid = solved.grids[part];
    // a rigid part turns about its middle without becoming larger
    const solver::RigidMotion m = grid.is_rigid ? fitted_motion_of(solved, part).motion : face_motion(solved, contact, side);
    const Placement p = about_center(m.center, m.translation, m.rotation);
    const Vec2 turned = p.turned({1, 0});
    return {m, geometry::transformed(scene.parts[at(grid.part)].part, turned.x(), turned.y(), p.shift)};
}

/// The smallest of numbers at even steps: of the parabola through the least and its neighbours.
double smallest(const std::vector<double>& values) {
    const auto least = std::min_element(values.begin(), values.end());
    if (least == values.begin() || least + 1 == values.end()) return *least;
    const double slope = 0.5 * (least[1] - least[-1]), bend = least[1] - 2 * least[0] + least[-1];
    return bend > 0 ? *least - 0.5 * slope * slope / bend : *least;
}

bool is_curved(const geometry::FacingPair& pair) {
    return pair.found && std::isfinite(pair.on1.curvature) && std::isfinite(pair.on2.curvature) &&
           pair.on1.curvature + pair.on2.curvature != 0;
}

}  // namespace

PlacedFaces placed_faces(const Scene& scene, const SolvedAssembly& solved, std::size_t contact) {
    return {placed_face(scene, solved, contact, 0), placed_face(scene, solved, contact, 1)};
}

double opening(const PlacedFaces& faces, const geometry::FacingPair& drawn) {
    return (faces[1].motion.at(drawn.on2.x) - faces[0].motion.at(drawn.on1.x)).dot(drawn.normal);
}

geometry::FacingPair placed_pair(const ContactInterface& c, const PlacedFaces& faces, const geometry::FacingPair& drawn) {
    return std::abs(drawn.on1.curvature) >= std::abs(drawn.on2.curvature)
               ? geometry::pair_from_first(faces[0].there, faces[1].there, c.zone, drawn.s1, drawn.s2)
               : geometry::pair_from_second(faces[0].there, faces[1].there, c.zone, drawn.s2, drawn.s1);
}

std::vector<double> gaps_left_out(const Scene& scene, const SolvedAssembly& solved) {
    constexpr int samples = 41;
    std::vector<double> left_out(solved.contacts.size(), 0.0);
    for (std::size_t k = 0; k < solved.contacts.size(); ++k) {
        const ContactInterface& c = solved.contacts[k];
        if (c.face.bilateral || solved.stretches[k].size() != 1) continue;
        const PressedStretch& pressed = solved.stretches[k].front();
        const geometry::FacingPair middle = pair_at(scene, c, 0.5 * (pressed.begin + pressed.end));
        if (!is_curved(middle)) continue;
        const PlacedFaces faces = placed_faces(scene, solved, k);
        std::vector<double> gaps, by_normals;
        for (int i = 0; i < samples; ++i) {
            const geometry::FacingPair drawn =
                pair_at(scene, c, c.s.front() + i / (samples - 1.0) * (c.s.back() - c.s.front()));
            const geometry::FacingPair there = drawn.found ? placed_pair(c, faces, drawn) : drawn;
            if (!there.found) break;
            gaps.push_back(there.gap);
            by_normals.push_back(drawn.gap + opening(faces, drawn));
        }
        if (gaps.size() == static_cast<std::size_t>(samples)) left_out[k] = smallest(gaps) - smallest(by_normals);
    }
    return left_out;
}

}  // namespace abut
