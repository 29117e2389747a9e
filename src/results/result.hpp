// SPDX-License-Identifier: GPL-3.0-or-later
// The answer of one analysis, in the scene's units and assembly coordinates: what result.json, the CSVs and the report show.
#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/brep/part.hpp"
#include "geometry/interfaces/functional_interface.hpp"

namespace abut {

using geometry::FunctionalInterface;
using geometry::Screw;
using geometry::Vec2;

/// A largest value and where it is.
struct ValueAt {
    double value = 0;
    Vec2 at{0, 0};
};

/// The stress at a point; xy is the shear.
struct Stress {
    double xx = 0, yy = 0, xy = 0, zz = 0;
};
double von_mises(const Stress& stress);

/// An effect of the plan; after the run with what its code took.
struct Effect {
    std::string name;
    bool on = false;
    std::string why;
    double seconds = 0;
    double share = 0;                                 ///< of the run's seconds
    long items = 0;                                   ///< points, rows or unknowns that its code worked on
    std::vector<std::string> parts{};                 ///< that it concerns
    std::vector<std::array<std::string, 2>> pairs{};  ///< of parts; before the run those that are searched
};

/// What the grid makes of a part, and whether its quadrature knows the part.
struct CutQuality {
    double smallest_fraction = 1;  ///< filled fraction of the cell that holds least of the part
    int split_cells = 0;           ///< pieces of material beyond one in a cell: arms beside a slot
    int extended = 0;              ///< B-splines that hold too little of the part, continued from inner cells
    int taken_apart = 0;           ///< functions more than B-splines, since arms are not tied together
    struct {
        double area = 0;        ///< relative error
        double centroid = 0;    ///< distance from the part's, in diagonals
        double divergence = 0;  ///< largest difference between integrals of div F and of F.n, over the area
        std::size_t points = 0, negative_weights = 0, outside_cell = 0;
    } self_check;
};

/// What is known of one part.
struct PartResult {
    std::string name, material;
    std::vector<int> level{};  ///< those on which it lies; none: all
    double area = 0;
    int unknowns = 0;
    bool solved = true;  ///< false: carries nothing and was not analysed
    bool rigid = false;  ///< moves as one body: no unknowns, no stress
    /// How it went from where it was drawn to where it was analysed.
    struct Moved {
        Vec2 translation{0, 0};  ///< of its centroid
        double rotation = 0;     ///< radians
    };
    std::optional<Moved> placement{};  ///< unset: it was analysed where it was drawn
    ValueAt max_displacement, max_von_mises;
    std::optional<double> max_displacement_error;  ///< estimated, relative; unset where there is none
    std::optional<double> max_von_mises_error;     ///< estimated, relative; unset where there is none
    bool max_von_mises_at_corner =
        false;  ///< it stands where stress has no limit (src/analysis/largest_stress.hpp): no maximum at all
    std::optional<double> utilisation{};  ///< largest von Mises stress over the material's yield; unset: the yield is not known
    double grid_angle = 0;                ///< radians
    std::vector<double> grid_x, grid_y;   ///< grid lines in the grid's frame (assembly coordinates turned by -grid_angle)
    /// A box whose cells are halved so many times, in the grid's frame as the lines are.
    struct Halved {
        Vec2 low, high;
        int levels;
    };
    std::vector<Halved> halved{};  ///< the smallest boxes that tell all halved cells; empty: a tensor grid
    int cells_inner = 0, cells_boundary = 0, cells_outer = 0;
    CutQuality quality;
};

/// Fields of one part for drawing. Patches of a cell: quadrilaterals by four sample points; those of boundary cells reach
/// beyond the part and are to be clipped by its (deformed) boundary. Between the corners components vary linearly, not norms.
struct FieldSample {
    Vec2 at;
    Vec2 displacement;
    Stress stress;
};
struct FieldPatch {
    std::array<int, 4> corner;
};  ///< counter-clockwise, indices into samples
struct PartField {
    std::vector<FieldSample> samples;
    std::vector<FieldPatch> patches;
    /// The boundary as polylines, loop by loop, closed (first point not repeated): undeformed points and their displacements.
    std::vector<std::vector<FieldSample>> boundary;
};

/// A contact's pressure and gap point by point along the first part's edges; lists are parallel. Arc lengths are on the model's
/// edges, in their own direction.
struct ContactProfile {
    std::vector<std::string> edge;  ///< "part/edge" on the first part
    std::vector<double> s, x, y, pressure, gap;
    /// Bonded, or with friction: tangential traction on the second part, along the first's normal turned left.
    std::vector<double> shear;
    std::vector<double> slip;        ///< with friction: how far the second part has moved along that direction since it was placed
    std::vector<std::string> state;  ///< with friction: open, stick, slip
    std::vector<std::string> edge2;  ///< "part/edge" of the facing points on the second part
    std::vector<double> s2, x2, y2;
};

/// Estimated errors, relative to the contact's own values (src/analysis/error_estimate.hpp).
struct ContactErrors {
    double pressure = 0;  ///< L2 over the contact
    double peak = 0, force = 0, length = 0;
    bool at_corner = false;  ///< the largest pressure stands at a sharp corner, where it may have no limit: no peak at all
};

/// A finer level, and the seconds that it would probably take.
struct NextLevel {
    std::string accuracy;  ///< as --accuracy takes it
    double target = 0, seconds = 0;
};

/// What friction does in a contact.
struct FrictionResult {
    double coefficient = 0;                    ///< infinite: rough
    double shear_force = 0;                    ///< integral of the tangential traction, total over the thickness
    double normal_force = 0;                   ///< integral of the pressure
    std::optional<double> utilisation;         ///< |shear force| / (coefficient normal force); unset where nothing presses
    double stick_length = 0, slip_length = 0;  ///< on the middle curve
    std::optional<double> stick_length_error;  ///< estimated, absolute; so much the other may be off by
    double dissipated = 0;                     ///< work against slip, of the step where there are steps
    double dissipated_error = 0;               ///< of it, by the size of the increments
};

/// What one contact does.
struct ContactResult {
    std::array<int, 2> part{0, 0};  ///< indices into Result::parts
    std::array<std::string, 2> parts, between;
    std::array<std::vector<std::string>, 2> edges;
    std::string kind = "contact", interface, status;  ///< status: closed, partial, open
    double gap_min = 0, gap_max = 0;                  ///< initial
    Vec2 force{0, 0};                                 ///< on the first part, total over the thickness
    double moment = 0;
    double contact_length = 0;
    std::vector<Vec2> ends;
    ValueAt max_pressure;
    double max_penetration = 0;
    std::optional<double> error_estimate;  ///< of the pressure
    std::optional<ContactErrors> errors;
    std::optional<FunctionalInterface> functional;
    std::optional<FrictionResult> friction;  ///< unset: none
    ContactProfile profile;
};

/// What supports and contacts leave the parts to do as rigid bodies; screws about the origin of assembly coordinates.
struct PartMobility {
    std::string part;
    std::vector<Screw> wrenches, twists;  ///< of its supports alone: what they can exert, what they leave free
    std::vector<std::string> alone;       ///< the twists in words
    std::vector<Screw> free;              ///< with the contacts, in all motions of the assembly
    std::vector<std::string> motions;     ///< the free twists in words
};
struct MobilityResult {
    int degrees_of_freedom = 0, gruebler = 0;
    int redundant = 0;  ///< by how many conditions the assembly is over-constrained
    std::vector<PartMobility> parts;
};

/// The force of a support on the assembly, total over the thickness, and its moment about the origin.
struct Reaction {
    int support = 0;     ///< index into Scene::supports
    std::string label;   ///< "fix x, y on base/bottom"
    std::string method;  ///< "aligned", "nitsche", "structure", "rigid", "spring"
    Vec2 force{0, 0};
    double moment = 0;
    std::string why{};                        ///< the method, in words
    std::optional<Vec2> force_from_stress{};  ///< "structure": the force from the stresses along the edges, a second opinion
    std::optional<double> energy{};           ///< "spring": stored in it
};

/// Displacement and stress at a point that the scene asks for.
struct ProbeResult {
    std::string part;
    Vec2 at;
    Vec2 displacement;
    Stress stress;
};

struct SupportMark {
    Vec2 at;
    Vec2 normal;
    bool x, y;
};  ///< for the picture: a point of a supported edge, outward normal
struct LoadMark {
    Vec2 at;
    Vec2 direction;
};  ///< for the picture: a point and the unit direction of the load there

/// A part that was tightened across a cut before the other loads acted.
struct PreloadResult {
    std::string part;
    std::array<Vec2, 2> across;   ///< the ends of the cut
    double force = 0;             ///< that it was tightened to
    double shortening = 0;        ///< how far the two sides of the cut were drawn together for that
    double force_under_load = 0;  ///< across the cut under all loads, tension positive
};

/// One solution on the way to the last: grids follow the contacts.
struct PassSummary {
    int unknowns = 0, multipliers = 0;
    double seconds = 0;  ///< from the first grid to this solution: grids, assembly, factorisation, contact; without stresses
    std::optional<double> estimated_error;  ///< of what accuracy.target steers; nothing to compare with on the first grids
};

/// Why a solved answer is less than what was asked for. One is enough for the verdict "solved, but" (src/results/verdict.hpp).
struct Reason {
    std::string kind;  ///< a word for programs: "accuracy", "yield", ... (data/schema/result.schema.json has them all)
    std::string text;  ///< a clause of the verdict: "strap at 2.75 times its yield"
};

/// A motion of a part: a twist about the origin of assembly coordinates, of no particular size.
struct PartTwist {
    int part = -1;  ///< of the scene
    Screw twist{0, 0, 0};
};

/// The answer. With status "failed" it holds what is known, and `message` says why.
struct Result {
    std::string title, status = "ok", message;  ///< status: ok, failed
    std::string length_unit, force_unit;
    int unknowns = 0, degree = 2, multipliers = 0;
    std::array<int, 3> cells{0, 0, 0};  ///< inner, boundary, outer
    struct {
        int grids = 0, factorizations = 0, contact_iterations = 0;
        double condition_estimate = 0;
        bool converged = true;
        int groups = 0, contact_problems = 0;         ///< of parts that do not interact; those that have contact
        std::optional<double> assembled_condition{};  ///< by the dissertation's method: as its table 5.2 has it
        std::optional<int> increments{};              ///< of the loads' way; with friction or steps
        /// Violation of the conditions of contact by the answer, of its largest pressure and closing; where there is contact.
        std::optional<double> contact_residual{};
    } solver;
    std::vector<std::pair<std::string, double>>
        timing;  ///< import, geometry, assembly, solve, recovery, output, total (seconds)
    /// The timing split finer, without reading and writing: geometry, assembly, factorisation, contact, recovery (seconds).
    std::vector<std::pair<std::string, double>> stages;
    std::vector<Effect> effects;
    double strain_energy = 0;
    double energy_rounding = 0;  ///< what rounding may make of it; not part of result.json
    struct {
        Vec2 applied{0, 0}, reaction{0, 0};
        double relative_residual = 0, relative_moment_residual = 0;
    } equilibrium;
    struct {
        std::optional<double> energy, contact_pressure, stress;
        std::string method;
    } error_estimate;
    struct {
        std::string of;  ///< "contact pressure", or "stress" where there is no contact
        double target = 0;
        std::optional<double> estimate;
        bool reached = false;
        std::string why;  ///< where it was not
    } accuracy;
    std::optional<NextLevel> next_level;
    std::vector<PartResult> parts;
    std::vector<ContactResult> contacts;
    MobilityResult as_drawn;                   ///< with every contact that could close
    std::optional<MobilityResult> under_load;  ///< with the contacts that carry force
    std::vector<Reaction> reactions;
    std::vector<PreloadResult> preloads;
    std::vector<ProbeResult> probes;
    std::vector<std::string> warnings;
    std::vector<std::string> notes{};  ///< Scene::notes
    std::vector<Reason> reasons;
    std::vector<PassSummary> passes;  ///< in their order; the last one is the answer's

    // For the pictures; not part of result.json.
    std::vector<geometry::Part> geometry;  ///< parallel to parts
    std::vector<PartField> fields;         ///< parallel to parts; empty where not analysed
    std::vector<SupportMark> support_marks;
    std::vector<LoadMark> load_marks;
    std::vector<PartTwist> driven{};  ///< failed: the motions in which the loads move what nothing holds
};

/// The text of result.json (data/schema/result.schema.json); deterministic but for timing.
std::string result_json(const Result& result);
/// The text of contact_<k>.csv.
std::string contact_csv(const ContactResult& contact);
/// The table that `analyze` prints.
std::string result_table(const Result& result);

}  // namespace abut
