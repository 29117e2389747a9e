// SPDX-License-Identifier: GPL-3.0-or-later
// From a zone where two parts face each other to the interface that the solver couples: quadrature on the middle curve, split
// where either grid's lines cross it, and the knots of the pressure spline.
#pragma once
#include <array>
#include <mutex>
#include <utility>
#include <vector>

#include "geometry/proximity/facing.hpp"
#include "solver/contact/assembly_solve.hpp"
#include "src/contact/candidates.hpp"
#include "src/discretization/discretize.hpp"
#include "src/solution/shared_cells.hpp"

namespace abut {

/// The pressure's knot spacing in units of the local cell size, the mean of both bodies' weighted by their compliances 1/E
/// (what one body's cells do not follow, fine ones of the other resist as so much gap): stable for every grid angle, shift and
/// ratio of sizes (measured: smallest scaled eigenvalue of C at least 0.29), while knots at the grid's own crossings are not.
inline constexpr double multiplier_spacing = 1.25;
/// Likewise where a part has halved cells: where their size changes, by a factor of two, splines follow no better than on the
/// larger ones, and a pressure with closer knots oscillates (measured on rings with 1 to 40 contacts: 1 does, 1.5 does not).
inline constexpr double multiplier_spacing_of_halved = 1.5;
/// How far beyond an expected end of contact, in knot spacings, the pressure has its double knot, by which it may leave zero
/// with a slope. Measured on Hertz' problem (degree 2, cells h at the end of a half width a): relative L2 error 0.12 h / a
/// whatever the rest of the grid; 0.25 h / a with the knot at the end itself; with simple knots 0.2 to 1.2 h / a, by chance.
inline constexpr double end_overhang = 0.16;

/// How a candidate's drawn gap counts.
struct GapRule {
    double closing = 0;       ///< how much it is reduced (interference)
    bool no_overlap = false;  ///< negative ones count as zero

    double of(double gap) const { return (no_overlap && gap < 0 ? 0.0 : gap) - closing; }
};

/// A candidate as the solver's interface, with the way back from its arc length to the parts' chains.
struct ContactInterface {
    std::array<int, 2> part;  ///< indices into Scene::parts
    geometry::FacingZone zone;
    solver::Interface face;  ///< face.part: indices among the solver's parts
    std::vector<std::array<Vec2, 2>> own_normals;
    /// The table of arc length on chain 1 against that of the middle curve (penalty: on chain 1 from the zone's begin),
    /// ascending.
    std::vector<double> s1, s;
    std::vector<double> s2;  ///< partners on chain 2 of the table's entries
    double foundation = 0;
    GapRule drawn{};
    Pairing pairing = Pairing::middle;
};

/// A zone on the grids of its parts, measured without regard to where contact ends.
struct MeasuredZone {
    ContactInterface on_middle;  ///< without pressure and points
    std::vector<double> count;   ///< at the table's places the integral of ds over the wanted knot spacing
};

/// The interfaces of load cases on the same grids, for others whose contacts end at the same places: to tell such, ends are
/// rounded to a step that is small beside what an end has to move by to get another knot.
struct KnownInterfaces {
    struct Made {
        std::vector<double> doubled;  ///< counts at which its knots are double
        ContactInterface interface;
    };
    struct Zone {
        Candidate of;
        std::array<int, 2> solver_part;
        MeasuredZone measured;
        std::vector<Made> made{};
    };
    static constexpr double step = 1.0 / 16;  ///< of the knot spacing
    static constexpr std::size_t most = 16;   ///< that are kept of a zone
    const std::vector<FacesByCell> faces;     ///< that all of them are made with
    std::vector<Zone> zones{};
    std::mutex busy{};  ///< who reads or adds zones has it

    explicit KnownInterfaces(std::vector<FacesByCell> all) : faces(std::move(all)) {}
};

/// Makes the interface of a candidate: mortar's, or penalty's where the scene asks for it. faces: of all candidates, by solver
/// part. known: of cases on the same grids, or null.
ContactInterface make_interface(const Scene& scene, const Candidate& candidate, const PartOnGrid& first,
                                const PartOnGrid& second, std::array<int, 2> solver_part, const std::vector<FacesByCell>& faces,
                                KnownInterfaces* known = nullptr);

/// The next search under these interfaces begins at the pressures of a solution under them.
void expect_pressures_of(const solver::AssemblySolution& solution, std::vector<solver::Interface>& faces);

/// The pair at arc length s of the middle curve.
geometry::FacingPair pair_at(const Scene& scene, const ContactInterface& contact, double s);

/// The element of a part that holds a point of its boundary.
int element_of(const PartOnGrid& on_grid, const geometry::ChainPoint& p);

}  // namespace abut
