// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/step/step_records.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace abut::geometry {

namespace {

constexpr char unit_record = 'u', plane_record = 'c', body_record = 's', missed_record = 'm', repair_record = 'r',
               ignored_record = 'i', problem_record = 'p', segment_record = 'l', arc_record = 'a', ellipse_record = 'e',
               nurbs_record = 'n';

static_assert(sizeof(Vec2) == 2 * sizeof(double));

template <std::size_t n>
void write_numbers(RecordWriter& records, char kind, const std::array<double, n>& numbers) {
    records.kind(kind);
    records.numbers(numbers.data(), n);
}

void write(RecordWriter& records, const Segment& line) {
    write_numbers<4>(records, segment_record, {line.from.x(), line.from.y(), line.to.x(), line.to.y()});
}

void write(RecordWriter& records, const Arc& arc) {
    write_numbers<5>(records, arc_record, {arc.center.x(), arc.center.y(), arc.radius, arc.start, arc.sweep});
}

void write(RecordWriter& records, const EllipticArc& arc) {
    write_numbers<8>(records, ellipse_record,
                     {arc.center.x(), arc.center.y(), arc.a.x(), arc.a.y(), arc.b.x(), arc.b.y(), arc.start, arc.sweep});
}

void write_list(RecordWriter& records, const std::vector<double>& values) {
    records.count(values.size());
    records.numbers(values.data(), values.size());
}

void write(RecordWriter& records, const Nurbs& nurbs) {
    records.kind(nurbs_record);
    records.count(static_cast<std::size_t>(nurbs.degree));
    write_list(records, nurbs.knots);
    records.count(nurbs.points.size());
    if (!nurbs.points.empty()) records.numbers(nurbs.points.front().data(), 2 * nurbs.points.size());
    write_list(records, nurbs.weights);
}

template <std::size_t n>
std::array<double, n> read_numbers(RecordReader& records) {
    std::array<double, n> numbers{};
    records.numbers(numbers.data(), n);
    for (double number : numbers)
        if (!std::isfinite(number)) records.refuse();
    return numbers;
}

bool is_angle_range(double start, double sweep) {
    constexpr double full = 2 * std::numbers::pi;
    return std::isfinite(start) && std::abs(sweep) > 0 && std::abs(sweep) <= full;
}

Curve read_arc(RecordReader& records) {
    const auto n = read_numbers<5>(records);
    if (!(n[2] > 0) || !is_angle_range(n[3], n[4])) records.refuse();
    return Arc{{n[0], n[1]}, n[2], n[3], n[4]};
}

Curve read_ellipse(RecordReader& records) {
    const auto n = read_numbers<8>(records);
    const EllipticArc arc{{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}, n[6], n[7]};
    if (!(arc.a.norm() > 0 && arc.b.norm() > 0) || !is_angle_range(arc.start, arc.sweep)) records.refuse();
    return arc;
}

std::vector<double> read_list(RecordReader& records) {
    std::vector<double> values(records.count(2 * most_spline_points));
    records.numbers(values.data(), values.size());
    return values;
}

Nurbs read_nurbs(RecordReader& records) {
    Nurbs nurbs;
    nurbs.degree = static_cast<int>(records.count(1000));  // what is above our own largest is a fault with words
    nurbs.knots = read_list(records);
    nurbs.points.resize(records.count(most_spline_points));
    if (!nurbs.points.empty()) records.numbers(nurbs.points.front().data(), 2 * nurbs.points.size());
    nurbs.weights = read_list(records);
    return nurbs;
}

/// Reads all records of one file.
class SectionReader {
public:
    SectionReader(RecordReader& records, Drawing& drawing) : records_(records), drawing_(drawing) {}

    void read(char kind) {
        if (kind == unit_record) drawing_.unit = records_.text();
        if (kind == plane_record) drawing_.cut_at = records_.text();
        if (kind == body_record) begin_body();
        if (kind == missed_record) read_missed();
        if (kind == ignored_record) read_ignored();
        if (kind == repair_record) read_repair();
        if (kind == problem_record) read_problem();
        if (kind == segment_record) {
            const auto n = read_numbers<4>(records_);
            add("LINE", Segment{{n[0], n[1]}, {n[2], n[3]}});
        }
        if (kind == arc_record) add("ARC", read_arc(records_));
        if (kind == ellipse_record) add("ELLIPSE", read_ellipse(records_));
        if (kind == nurbs_record) add_spline(read_nurbs(records_));
        if (std::string("ucsmirplaen").find(kind) == std::string::npos) records_.refuse();
    }

private:
    void begin_body() {
        body_ = records_.text();
        n_curves_ = 0;
        ++drawing_.counts["solid"].read;
        ++drawing_.counts["solid"].used;
    }
    void read_missed() {
        const std::string name = records_.text(), why = records_.text();
        ++drawing_.counts["solid"].read;
        ++drawing_.counts["solid"].ignored;
        drawing_.ignored.push_back({"solid " + name, 1, why});
    }
    void read_ignored() {
        const std::string what = records_.text(), why = records_.text();
        drawing_.ignored.push_back({what, 1, why});
    }
    void read_repair() {
        const std::string what = records_.text();
        const auto n = read_numbers<3>(records_);
        drawing_.repairs.push_back({what, {n[0], n[1]}, n[2]});
    }
    void read_problem() {
        const std::string what = records_.text(), body = records_.text(), hint = records_.text();
        drawing_.problems.push_back({what, Vec2::Zero(), body, 0, hint});
    }

    void add(const char* kind, const Curve& curve) {
        if (drawing_.entities.size() >= most_section_curves) records_.refuse();
        SketchEntity entity;
        entity.curve = curve;
        entity.kind = kind;
        entity.layer = entity.block = body_;
        entity.name = "e" + std::to_string(n_curves_++);
        drawing_.entities.push_back(std::move(entity));
    }

    void add_spline(const Nurbs& nurbs) {
        const std::string fault = spline_fault(nurbs);
        if (!fault.empty()) {
            const bool has_point = !nurbs.points.empty() && nurbs.points.front().allFinite();
            drawing_.problems.push_back({"a spline of " + body_ + " cannot be used: " + fault,
                                         has_point ? nurbs.points.front() : Vec2::Zero(), body_, 0,
                                         "export it in another way"});
            return;
        }
        for (const Curve& curve : nurbs_curves(nurbs)) add("SPLINE", curve);
    }

    RecordReader& records_;
    Drawing& drawing_;
    std::string body_;
    int n_curves_ = 0;
};

}  // namespace

void StepRecords::unit(const std::string& unit) {
    records_.kind(unit_record);
    records_.text(unit);
}

void StepRecords::plane(const std::string& plane) {
    records_.kind(plane_record);
    records_.text(plane);
}

void StepRecords::body(const std::string& name) {
    records_.kind(body_record);
    records_.text(name);
}

void StepRecords::missed_body(const std::string& name, const std::string& why) {
    records_.kind(missed_record);
    records_.text(name);
    records_.text(why);
}

void StepRecords::curve(const SectionCurve& curve) {
    std::visit([this](const auto& kind) { write(records_, kind); }, curve);
}

void StepRecords::repair(const Repair& repair) {
    records_.kind(repair_record);
    records_.text(repair.what);
    for (double number : {repair.at.x(), repair.at.y(), repair.size}) records_.number(number);
}

void StepRecords::ignore(const std::string& what, const std::string& why) {
    records_.kind(ignored_record);
    records_.text(what);
    records_.text(why);
}

void StepRecords::problem(const std::string& what, const std::string& body, const std::string& hint) {
    records_.kind(problem_record);
    records_.text(what);
    records_.text(body);
    records_.text(hint);
}

void read_step_records(RecordReader& records, Drawing& drawing) {
    if (records.kind() != begin_record) records.refuse();
    SectionReader reader(records, drawing);
    for (char kind = records.kind(); kind != end_record; kind = records.kind()) reader.read(kind);
}

}  // namespace abut::geometry
