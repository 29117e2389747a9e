// SPDX-License-Identifier: GPL-3.0-or-later
// The section of a STEP file on its way from the program that reads it (apps/readers/).
#pragma once
#include <string>
#include <variant>

#include "geometry/curves/curve.hpp"
#include "geometry/curves/spline_shape.hpp"
#include "geometry/foreign/record_stream.hpp"
#include "geometry/sketch/sketch.hpp"

namespace abut::geometry {

/// A curve of a section.
using SectionCurve = std::variant<Segment, Arc, EllipticArc, Nurbs>;

/// The most curves of a section; a drawing of as many takes minutes.
inline constexpr std::size_t most_section_curves = 1'000'000;
/// The most points of a spline.
inline constexpr std::size_t most_spline_points = 1'000'000;

/// Writes what a file holds.
class StepRecords {
public:
    explicit StepRecords(RecordWriter& records) : records_(records) {}

    void unit(const std::string& unit);
    /// The plane of the section, as text_of gives it, in the file's unit.
    void plane(const std::string& plane);
    /// A solid of this name: the curves that follow are its section's.
    void body(const std::string& name);
    /// A solid that is not in the section.
    void missed_body(const std::string& name, const std::string& why);
    void curve(const SectionCurve& curve);
    void repair(const Repair& repair);
    void ignore(const std::string& what, const std::string& why);
    /// A problem of the solid of this name; it may be empty.
    void problem(const std::string& what, const std::string& body, const std::string& hint);

private:
    RecordWriter& records_;
};

/// Reads all that was written into the drawing. Throws InputError as RecordReader does, and for curves that are none.
void read_step_records(RecordReader& records, Drawing& drawing);

}  // namespace abut::geometry
