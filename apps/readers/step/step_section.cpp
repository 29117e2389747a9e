// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/readers/step/step_section.hpp"

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "apps/readers/step/solid_section.hpp"
#include "apps/readers/step/walls.hpp"

namespace abut::geometry {

namespace {

Box3 box_of(const StepSolid& solid) {
    Bnd_Box bound;
    BRepBndLib::AddOptimal(solid.shape, bound, Standard_False, Standard_False);
    Box3 box;
    if (bound.IsVoid()) return box;
    bound.Get(box.low.x(), box.low.y(), box.low.z(), box.high.x(), box.high.y(), box.high.z());
    return box;
}

std::vector<HeightRange> flat_faces(const std::vector<StepSolid>& solids, int axis) {
    std::vector<HeightRange> faces;
    for (const StepSolid& solid : solids)
        for (TopExp_Explorer at(solid.shape, TopAbs_FACE); at.More(); at.Next())
            if (const auto height = cap_height(TopoDS::Face(at.Current()), axis)) faces.push_back({*height, *height});
    return faces;
}

WallAxes wall_axes(const std::vector<StepSolid>& solids) {
    WallAxes axes{true, true, true};
    for (const StepSolid& solid : solids)
        for (TopExp_Explorer at(solid.shape, TopAbs_FACE); at.More(); at.Next()) {
            const TopoDS_Face face = TopoDS::Face(at.Current());
            for (int axis = 0; axis < 3; ++axis) {
                bool& holds = axes[static_cast<std::size_t>(axis)];
                holds = holds && (cap_height(face, axis) || is_wall(face, axis));
            }
        }
    return axes;
}

SectionPlane scaled(SectionPlane plane, double factor) {
    plane.at *= factor;
    return plane;
}

}  // namespace

void write_section(const StepFile& file, const SectionChoice& choice, StepRecords& records) {
    const double scale = 1 / file.unit_size;
    Box3 all;
    std::vector<Box3> boxes;
    for (const StepSolid& solid : file.solids) {
        boxes.push_back(box_of(solid));
        all.add(boxes.back());
    }
    SectionChoice in_millimetres = choice;
    if (choice.at) *in_millimetres.at *= file.unit_size;
    const SectionPlane asked = plane_of(in_millimetres, all, choice.axis < 0 ? wall_axes(file.solids) : WallAxes{});
    std::vector<HeightRange> heights;
    for (const Box3& box : boxes) heights.push_back({box.low[asked.axis], box.high[asked.axis]});
    const double size = all.size().norm();
    const SectionPlane plane = off_faces(flat_faces(file.solids, asked.axis), heights, asked, size);
    records.unit(file.unit);
    records.plane(text_of(scaled(plane, scale)));
    if (plane.at != asked.at)
        records.repair(
            {"the plane " + text_of(scaled(asked, scale)) + " runs along faces: cut at " + text_of(scaled(plane, scale)),
             Vec2::Zero(), scale * std::abs(plane.at - asked.at)});
    int n_met = 0;
    for (std::size_t k = 0; k < file.solids.size(); ++k) {
        if (!(heights[k].low < plane.at && plane.at < heights[k].high)) {
            records.missed_body(file.solids[k].name, "the plane " + text_of(scaled(plane, scale)) + " does not meet it");
            continue;
        }
        ++n_met;
        write_outline(file.solids[k], {plane, {plane.axis, scale}, face_band_fraction * size}, records);
    }
    if (n_met == 0)
        records.problem("the plane " + text_of(scaled(plane, scale)) + " meets no body", "",
                        "choose a section; the bodies lie between " +
                            text_of(scaled({plane.axis, all.low[plane.axis]}, scale)) + " and " +
                            text_of(scaled({plane.axis, all.high[plane.axis]}, scale)));
}

}  // namespace abut::geometry
