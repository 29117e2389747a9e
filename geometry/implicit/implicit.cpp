// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/implicit/implicit.hpp"

#include <cmath>

#include "geometry/implicit/field_shape.hpp"
#include "geometry/implicit/r_functions.hpp"
#include "src/base/ensure.hpp"

namespace abut::geometry {

namespace {

enum class Join { conjunction, disjunction };

ImplicitField joined(const ImplicitField& a, const ImplicitField& b, Join join, double alpha) {
    return make_field([a, b, join, alpha]<class T>(const PointOf<T>& p) -> T {
        const T x = a.shape->at(p), y = b.shape->at(p);
        return join == Join::conjunction ? conjunction(x, y, alpha) : disjunction(x, y, alpha);
    });
}

/// Balanced, so that n fields need log n roots one upon the other: a chain would dampen or amplify the first of them.
ImplicitField folded(std::vector<ImplicitField> fields, Join join, double alpha) {
    ENSURE(!fields.empty(), "an R-function is of some fields");
    ENSURE(alpha > -1 && alpha <= 1, "the alpha of R-functions is in (-1, 1]");
    while (fields.size() > 1) {
        std::vector<ImplicitField> half;
        for (std::size_t i = 0; i + 1 < fields.size(); i += 2) half.push_back(joined(fields[i], fields[i + 1], join, alpha));
        if (fields.size() % 2 == 1) half.push_back(fields.back());
        fields = std::move(half);
    }
    return fields.front();
}

}  // namespace

double value(const ImplicitField& field, const Vec2& p) {
    return field.shape->at(PointOf<double>{p.x(), p.y()});
}

FieldValue evaluate(const ImplicitField& field, const Vec2& p) {
    const Jet w = field.shape->at(jets_at(p));
    FieldValue result{w.v, {w.x, w.y}, {}};
    result.hessian << w.xx, w.xy, w.xy, w.yy;
    return result;
}

ImplicitField conjunction(const std::vector<ImplicitField>& fields, double alpha) {
    return folded(fields, Join::conjunction, alpha);
}

ImplicitField disjunction(const std::vector<ImplicitField>& fields, double alpha) {
    return folded(fields, Join::disjunction, alpha);
}

ImplicitField negation(const ImplicitField& field) {
    return make_field([field]<class T>(const PointOf<T>& p) -> T { return -field.shape->at(p); });
}

ImplicitField equivalence(const std::vector<ImplicitField>& fields, int m) {
    ENSURE(!fields.empty() && m >= 1, "a join is of some fields, and of order 1 at least");
    return make_field([fields, m]<class T>(const PointOf<T>& p) -> T {
        std::vector<T> w;
        w.reserve(fields.size());
        for (const ImplicitField& field : fields) {
            w.push_back(field.shape->at(p));
            if (w.back() < T(0)) w.back() = -w.back();
        }
        return equivalence(std::span<const T>(w), m);
    });
}

ImplicitField point_field(const std::vector<Vec2>& points, double alpha) {
    std::vector<ImplicitField> fields;
    for (const Vec2& q : points)
        fields.push_back(make_field([q]<class T>(const PointOf<T>& p) -> T {
            const T dx = p.x - q.x(), dy = p.y - q.y();
            return dx * dx + dy * dy;
        }));
    return conjunction(fields, alpha);
}

}  // namespace abut::geometry
