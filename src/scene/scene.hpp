// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as the file gives it, checked but not yet interpreted: names are not resolved to edges here.
#pragma once
#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "geometry/brep/input_error.hpp"
#include "geometry/csg/csg.hpp"
#include "geometry/sketch/sketch.hpp"
#include "src/scene/budget.hpp"
#include "src/scene/expression.hpp"

namespace abut {

using geometry::Vec2;

enum class Analysis { plane_stress, plane_strain, axisymmetric };

/// A material: E in force per area, density in mass per volume, in the scene's consistent units.
struct Material {
    std::string name;
    double E = 0, nu = 0;
    double density = 0;  ///< 0: not given
    bool has_density = false;
    std::optional<double> expansion{};  ///< strain per temperature
    std::optional<double> yield;
    bool rigid = false;  ///< the built-in "rigid"
};

/// Around an axis forces are totals over the full circle: 2 pi is the thickness.
inline constexpr double full_circle = 6.283185307179586;

/// Numbers of levels on which a part lies, ascending, each once; none: on all.
using Levels = std::vector<int>;

/// Where a part came from, and what it is made of.
struct ScenePart {
    std::string name;
    geometry::Part part;                      ///< in assembly coordinates and the scene's length unit, named
    int material = -1;                        ///< index into Scene::materials
    double thickness = 1;                     ///< axisymmetric: the full circle
    std::string where;                        ///< JSON pointer
    std::vector<geometry::Repair> repairs{};  ///< what its geometry was mended by; those of imports are in Scene::imports
    Levels level{};                           ///< parts without a common one have nothing to do with each other
    /// What the part is the value of, at its place; none: an import's part, which is known by its edges.
    std::shared_ptr<const geometry::CsgNode> tree{};
    double rounding = 0;  ///< how far the digits that it is written with may have moved its boundary (written_digits.hpp)
};

/// Rotates a part about the origin by the angle of cosine c and sine s, then moves it by d.
inline void turn_and_shift(ScenePart& part, double c, double s, const Vec2& d) {
    part.part = geometry::transformed(part.part, c, s, d);
    if (part.tree) part.tree = std::make_shared<const geometry::CsgNode>(geometry::transformed(*part.tree, c, s, d));
}

/// One item of an "on": exactly one of the four ways is set.
struct Selector {
    std::string pattern;  ///< "jaw/left", "jaw/left#1", "jaw/*"; empty for the object forms
    std::string part;     ///< of the object forms
    std::optional<Vec2> near;
    std::optional<std::array<Vec2, 2>> box;  ///< min, max
    std::optional<Vec2> facing;
    double within = 5;  ///< degrees
    std::string where;  ///< JSON pointer
};
using Selection = std::vector<Selector>;

/// A support: edges, points or a part that are held, or rest on springs; which members are read depends on the kind.
struct Support {
    enum class Kind { fix, displacement, symmetry, rigid, points, spring };
    Kind kind = Kind::fix;
    Selection on;                                            ///< empty for rigid and points
    bool x = false, y = false;                               ///< components that are prescribed (fix, displacement, points)
    std::array<Expression, 2> value;                         ///< displacement
    std::string part;                                        ///< rigid, points
    std::vector<Vec2> at;                                    ///< points, assembly coordinates
    double spring_normal = 0, spring_tangential = 0;         ///< spring: traction per displacement
    std::optional<double> rigid_x, rigid_y, rigid_rotation;  ///< rotation in radians; unset: free
    std::string where;
};

/// A load; which members are read depends on the kind.
struct Load {
    enum class Kind {
        pressure,
        traction,
        edge_force,
        edge_moment,
        bearing,
        part_force,
        part_moment,
        body_force,
        gravity,
        spin,
        temperature,
        preload
    };
    Kind kind = Kind::pressure;
    Selection on;
    std::string part;                 ///< part_force, part_moment, spin, temperature, preload; body_force ("*": all)
    std::array<Expression, 2> value;  ///< pressure, moments, temperature (rise), preload (force): value[0]; the others x and y
    std::optional<Vec2> at;           ///< edge_force: a point of its line of action, if not through the middle of the edges
    Vec2 about{0, 0};                 ///< spin: the axis' place
    double omega = 0;                 ///< spin: angle per time
    std::array<Vec2, 2> across{};     ///< preload: ends of the cut through the part
    std::string name{};               ///< load cases call it by that; may be empty, and the name of several
    std::string where;
};

/// A load case: the loads of a name times its factor. Those of other names do not act, those without a name act in every case.
struct LoadCase {
    std::string name;
    std::map<std::string, double> factors;  ///< by name of loads
    std::string where;
};

/// A portion of a part's boundary.
struct EdgePortion {
    int part;       ///< index into Scene::parts
    int edge;       ///< index into Part::edges
    double t0, t1;  ///< parameters of the edge's curve, t0 < t1
};

/// A rule for what may touch: two selections and how they meet.
struct PairRule {
    std::array<Selection, 2> between;
    /// What these select in the drawing, sorted: it stays with the parts where these move and bend.
    std::array<std::vector<EdgePortion>, 2> on{};
    enum class Kind { contact, bonded, ignore } kind = Kind::contact;
    double interference = 0;
    std::optional<double> friction{};  ///< coefficient, infinite: rough; unset: that of all contacts
    std::string where;
};

/// Which point of the second body faces a point of the first, and along which normal their gap and pressure act.
enum class Pairing {
    middle,  ///< on the normal of the middle curve: no body preferred, no couple left over (geometry/proximity/facing.hpp)
    master   ///< along the first body's own normal n1 [Grishin10, eqs 4.28 and 4.34]; x2 is where that line meets the second
             ///< body, not the point of the same x or y as in eq 4.34: no couple left over, no axis preferred
};

/// The penalty formulation [Grishin10, section 4.5]: pressure = factor * E of the stiffer part / length * penetration.
struct PenaltyOptions {
    double factor = 50;
    std::optional<double> length;  ///< unset: the first part's cell along its edge
    Pairing pairing = Pairing::master;
    /// Points in the pieces between both parts' grid lines: uniform pressure is exact. false: in the first part's cells alone,
    /// as in the dissertation, where it is not (17 % off on grids turned against each other, five cells along the face).
    bool split_by_second = true;
};

/// How contact is searched and formulated.
struct ContactOptions {
    bool detect = true;
    std::optional<double> search_distance;
    std::string overlap = "report";         ///< "report", "press_fit", "ignore"
    std::optional<PenaltyOptions> penalty;  ///< unset: mortar
    double friction = 0;                    ///< coefficient, infinite: rough
    std::vector<PairRule> pairs;
    /// Parts whose own faces may touch each other: not given, but found where an answer without has them overlap.
    std::set<int> of_one_part{};
};

/// The grid of one part as the scene gives it.
struct GridOptions {
    /// Cells that overlap a box, in the grid's own frame, are halved so many times, and those around it as neighbours need.
    struct Halved {
        Vec2 low, high;
        int levels;
    };
    std::vector<double> x, y;        ///< knots (grid lines), assembly coordinates turned by -angle; empty: cells
    std::array<int, 2> cells{0, 0};  ///< over the part's bounding box (in the grid's own frame)
    Vec2 offset{0, 0};               ///< moves the grid of `cells`, in the grid's own frame
    double angle = 0;                ///< radians
    std::optional<std::array<int, 2>> degree;
    std::vector<Halved> refine;
    std::string where;
};

/// A place that is to have cells no larger than this.
struct Refinement {
    Vec2 near;
    double radius, cell_size;
};

/// How accurate the answer is to be, or by which grids and splines.
struct Accuracy {
    std::string level = "standard";  ///< "draft", "standard", "fine"
    std::optional<double> target;    ///< instead of a level: estimated relative error wanted
    int degree = 2;
    std::optional<double> cell_size;
    std::vector<Refinement> refine;
    std::string basis = "auto";                ///< "auto", "plain", "normalized", "web"
    std::string dirichlet = "auto";            ///< "auto", "aligned", "nitsche", "solution_structure"
    std::string method = "auto";               ///< "auto", "dissertation": dissertation_method.hpp has taken it
    std::string weights = "auto";              ///< of solution structures: "auto", "joined", "r_function", "blended"
    std::map<std::string, GridOptions> grids;  ///< by part
    std::optional<bool> adapt;
    bool by_cholmod = false;  ///< "solver": "cholmod"
    Budget budget;
};

/// A point of a part at which displacement and stress are asked for.
struct Probe {
    std::string part;
    Vec2 at;
    std::string where;
};

/// What the answer is to hold besides, and the files to write.
struct Output {
    std::vector<Probe> probes;
    std::vector<std::string> formats{"json", "csv", "html"};
};

/// A number of the answer that is known: a benchmark.
struct Expectation {
    std::string quantity;  ///< path into result.json: "contacts[0].max_pressure.value", or a JSON pointer
    double value = 0;      ///< in the scene's units
    double tolerance = 0;  ///< on the error relative to the value, or on the error itself where the value is 0
    std::string source;    ///< where the value comes from; may be empty
    std::string in_case;   ///< name of the load case; empty: the scene has none
    std::string where;     ///< JSON pointer
};

/// What the import of a drawing found, repaired and left out (for the report and for `inspect`).
struct ImportRecord {
    std::string file, format, unit;
    double factor = 1;  ///< from the file's unit to the scene's
    std::map<std::string, geometry::EntityCount> counts;
    std::vector<geometry::Ignored> ignored;
    std::vector<geometry::Repair> repairs;
    std::vector<geometry::SketchProblem> warnings;  ///< what was left out, merged, projected or guessed
};

/// All that a scene file says, its geometry evaluated.
struct Scene {
    std::string file;  ///< as given
    std::string title;
    std::string length_unit, force_unit;  ///< labels, may be empty
    Analysis analysis = Analysis::plane_stress;
    std::vector<Material> materials;
    std::vector<ScenePart> parts;  ///< in the scene's order, the assembly's parts after "parts"
    std::vector<Support> supports;
    std::vector<Load> loads;
    std::vector<LoadCase> cases;  ///< empty: all loads act
    bool in_steps = false;        ///< the cases follow each other, and friction remembers
    bool follows_motion = true;   ///< parts are analysed where the loads take them
    /// The loads of all cases, where the scene is one of them, since what is made of a part has to do for every case.
    std::vector<Load> loads_of_all_cases{};
    ContactOptions contacts;
    Accuracy accuracy;
    Output output;
    std::vector<Expectation> expect;
    std::vector<ImportRecord> imports;
    std::vector<std::string> warnings;
    std::vector<std::string> notes{};  ///< what was taken from elsewhere: materials of the library
};

/// The part that a rule is for by itself; -1 where it is for several.
int own_part(const PairRule& rule);
/// The parts that may touch themselves: of_one_part, and those that a rule bonds to themselves or presses together.
std::set<int> parts_with_themselves(const ContactOptions& contacts);

/// Is there anything that could touch, and is it looked for?
inline bool searches_contacts(const Scene& scene) {
    const ContactOptions& c = scene.contacts;
    return (c.detect || !c.pairs.empty()) && (scene.parts.size() > 1 || !parts_with_themselves(c).empty());
}

/// Is there a support of this kind?
inline bool has_support(const Scene& scene, Support::Kind kind) {
    return std::any_of(scene.supports.begin(), scene.supports.end(), [&](const Support& s) { return s.kind == kind; });
}

/// A part by its number, and its shape.
inline const ScenePart& scene_part(const Scene& scene, int part) {
    return scene.parts[static_cast<std::size_t>(part)];
}
inline const geometry::Part& part_of(const Scene& scene, int part) {
    return scene.parts[static_cast<std::size_t>(part)].part;
}

}  // namespace abut
