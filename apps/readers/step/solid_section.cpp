// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/readers/step/solid_section.hpp"

#include <BRepAlgoAPI_Section.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <gp_Pln.hxx>
#include <limits>
#include <map>
#include <optional>

#include "apps/readers/step/walls.hpp"

namespace abut::geometry {

namespace {

std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Face> faces;
    for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next()) faces.push_back(TopoDS::Face(at.Current()));
    return faces;
}

/// The faces of the upper end of a solid that is the same at all heights; none of another one.
std::vector<TopoDS_Face> end_of_prism(const TopoDS_Shape& shape, const SolidCut& cut) {
    std::vector<std::pair<double, TopoDS_Face>> caps;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const TopoDS_Face& face : faces_of(shape)) {
        if (const std::optional<double> height = cap_height(face, cut.plane.axis)) {
            caps.emplace_back(*height, face);
            low = std::min(low, *height);
            high = std::max(high, *height);
        } else if (!is_wall(face, cut.plane.axis)) {
            return {};
        }
    }
    if (!(low < cut.plane.at && cut.plane.at < high)) return {};
    std::vector<TopoDS_Face> end;
    for (const auto& [height, face] : caps) {
        if (height > low + cut.rounding && height < high - cut.rounding) return {};  // a step
        if (height >= high - cut.rounding) end.push_back(face);
    }
    return end;
}

/// Writes edges as curves, and what had to be approximated.
class Outline {
public:
    Outline(const StepSolid& solid, const SolidCut& cut, StepRecords& records) : solid_(solid), cut_(cut), records_(records) {}
    ~Outline() {
        if (approximated_ > 0) records_.repair({"curves of " + solid_.name + " are approximated", at_, approximated_});
    }
    Outline(const Outline&) = delete;
    Outline& operator=(const Outline&) = delete;

    void add(const Handle(Geom_Curve) & curve, double from, double to, double tolerance) {
        double own = 0;
        records_.curve(plane_curve(curve, from, to, cut_.map, own));
        own = std::max(own, cut_.map.scale * tolerance);
        if (own <= approximated_) return;
        approximated_ = own;
        at_ = cut_.map(curve->Value(from).XYZ());
    }

private:
    const StepSolid& solid_;
    const SolidCut& cut_;
    StepRecords& records_;
    double approximated_ = 0;
    Vec2 at_{0, 0};
};

/// The edges of the faces but for those between two of them.
void write_boundary(const std::vector<TopoDS_Face>& faces, Outline& outline) {
    TopTools_IndexedMapOfShape edges;
    std::map<int, int> n_uses;
    for (const TopoDS_Face& face : faces)
        for (TopExp_Explorer at(face, TopAbs_EDGE); at.More(); at.Next()) ++n_uses[edges.Add(at.Current())];
    for (const auto& [k, n] : n_uses) {
        const TopoDS_Edge edge = TopoDS::Edge(edges(k));
        double from = 0, to = 0;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, from, to);
        if (n == 1 && !curve.IsNull() && !BRep_Tool::Degenerated(edge)) outline.add(curve, from, to, 0);
    }
}

/// The portion of a wall's own curve from the beginning to the end of a curve in the wall; false where it is not found.
bool add_profile(const TopoDS_Face& face, const Handle(Geom_Curve) & found, double from, double to, const SolidCut& cut,
                 Outline& outline) {
    bool is_along_u = true;
    const Handle(Geom_Curve) profile = profile_of(face, cut.plane.axis, is_along_u);
    if (profile.IsNull() || profile->IsPeriodic()) return false;
    gp_Vec up(0, 0, 0);
    up.SetCoord(cut.plane.axis + 1, 1);
    // The profile at the height of the section, where ends are looked for.
    const Handle(Geom_Curve) level = Handle(Geom_Curve)::DownCast(profile->Copy());
    level->Translate(up * (cut.plane.at - profile->Value(profile->FirstParameter()).Coord(cut.plane.axis + 1)));
    const double first = level->FirstParameter(), last = level->LastParameter();
    if (Precision::IsInfinite(first) || Precision::IsInfinite(last)) return false;
    double ends[2];
    for (int k : {0, 1}) {
        const gp_Pnt end = found->Value(k == 0 ? from : to);
        GeomAPI_ProjectPointOnCurve nearest(end, level, first, last);
        double at = first, distance = end.Distance(level->Value(first));
        if (end.Distance(level->Value(last)) < distance) at = last, distance = end.Distance(level->Value(last));
        if (distance > Precision::Confusion() && nearest.NbPoints() > 0 && nearest.LowerDistance() < distance)
            at = nearest.LowerDistanceParameter();
        ends[k] = at;
    }
    const auto [low, high] = std::minmax(ends[0], ends[1]);
    if (high - low <= Precision::PConfusion()) return false;
    outline.add(level, low, high, 0);
    return true;
}

void write_cut(const StepSolid& solid, const SolidCut& cut, Outline& outline, StepRecords& records) {
    gp_Pnt point(0, 0, 0);
    point.SetCoord(cut.plane.axis + 1, cut.plane.at);
    gp_Vec normal(0, 0, 0);
    normal.SetCoord(cut.plane.axis + 1, 1);
    BRepAlgoAPI_Section section(solid.shape, gp_Pln(point, gp_Dir(normal)), Standard_False);
    section.ComputePCurveOn1(Standard_False);
    section.Approximation(Standard_True);
    section.Build();
    if (!section.IsDone())
        return records.problem("OpenCASCADE cannot cut the solid " + solid.name, solid.name,
                               "cut it at another place (section), or mend it");
    for (TopExp_Explorer at(section.Shape(), TopAbs_EDGE); at.More(); at.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(at.Current());
        double from = 0, to = 0;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, from, to);
        if (curve.IsNull()) continue;
        TopoDS_Shape face;
        const bool is_spline = curve->IsKind(STANDARD_TYPE(Geom_BSplineCurve)) != 0;
        if (is_spline && section.HasAncestorFaceOn1(edge, face) &&
            add_profile(TopoDS::Face(face), curve, from, to, cut, outline))
            continue;
        outline.add(curve, from, to, is_spline ? BRep_Tool::Tolerance(edge) : 0);
    }
}

}  // namespace

void write_outline(const StepSolid& solid, const SolidCut& cut, StepRecords& records) {
    records.body(solid.name);
    Outline outline(solid, cut, records);
    const std::vector<TopoDS_Face> end = end_of_prism(solid.shape, cut);
    if (end.empty())
        write_cut(solid, cut, outline, records);
    else
        write_boundary(end, outline);
}

}  // namespace abut::geometry
