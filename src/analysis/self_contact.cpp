// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/analysis/self_contact.hpp"

#include <algorithm>

#include "src/results/findings.hpp"
#include "src/results/result_units.hpp"

namespace abut {

namespace {

using geometry::cross;

struct Side {
    const FieldSample *from, *to;
    std::size_t index;  ///< along all loops
    double left, right, bottom, top;
};

Vec2 displaced(const FieldSample& s) {
    return s.at + s.displacement;
}

std::vector<Side> sides_of(const PartField& field) {
    std::vector<Side> sides;
    for (const std::vector<FieldSample>& loop : field.boundary)
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const FieldSample &a = loop[k], &b = loop[(k + 1) % loop.size()];
            const Vec2 p = displaced(a), q = displaced(b);
            sides.push_back({&a, &b, sides.size(), std::min(p.x(), q.x()), std::max(p.x(), q.x()), std::min(p.y(), q.y()),
                             std::max(p.y(), q.y())});
        }
    std::sort(sides.begin(), sides.end(),
              [](const Side& a, const Side& b) { return a.left != b.left ? a.left < b.left : a.index < b.index; });
    return sides;
}

/// Strictly: sides that share an end do not cross.
bool cross_each_other(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    return cross(b - a, c - a) * cross(b - a, d - a) < 0 && cross(d - c, a - c) * cross(d - c, b - c) < 0;
}

bool overlap_when_displaced(const Side& s, const Side& t) {
    if (s.bottom > t.top || t.bottom > s.top || s.from == t.to || s.to == t.from) return false;
    return cross_each_other(displaced(*s.from), displaced(*s.to), displaced(*t.from), displaced(*t.to)) &&
           !cross_each_other(s.from->at, s.to->at, t.from->at, t.to->at);
}

}  // namespace

std::optional<Vec2> self_overlap(const PartField& field) {
    const std::vector<Side> sides = sides_of(field);
    const Side* first = nullptr;
    for (std::size_t i = 0; i < sides.size(); ++i)
        for (std::size_t k = i + 1; k < sides.size() && sides[k].left <= sides[i].right; ++k) {
            if (!overlap_when_displaced(sides[i], sides[k])) continue;
            const Side& side = sides[i].index < sides[k].index ? sides[i] : sides[k];
            if (!first || side.index < first->index) first = &side;
        }
    return first ? std::optional<Vec2>(0.5 * (first->from->at + first->to->at)) : std::nullopt;
}

void warn_of_self_contact(Result& result) {
    std::vector<Finding> findings;
    for (std::size_t i = 0; i < result.parts.size(); ++i)
        if (const std::optional<Vec2> place = self_overlap(result.fields[i])) {
            const std::string& name = result.parts[i].name;
            findings.push_back({0, name,
                                "part " + name + " closes on itself near " + pair_text(*place, 4) +
                                    ": contact of a part with itself is not supported, this answer lets it overlap there; " +
                                    "draw it as two bonded parts",
                                name + " overlaps itself"});
        }
    tell(std::move(findings), "self-contact", result);
}

}  // namespace abut
