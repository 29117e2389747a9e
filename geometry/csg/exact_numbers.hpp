// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's numbers, points and curves of outlines made of lines and circle arcs. For the two files that are compiled with CGAL
// alone: exact_regions.cpp and exact_outline.cpp.
#pragma once
#include <CGAL/Arr_circle_segment_traits_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/variant.hpp>
#include <cmath>
#include <type_traits>
#include <variant>

#include "geometry/curves/curve.hpp"

namespace abut::geometry {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using PlaneTraits = CGAL::Arr_circle_segment_traits_2<Kernel>;
using PlaneCurve = PlaneTraits::X_monotone_curve_2;
using Rational = Kernel::Point_2;      ///< a point with rational coordinates
using OneRoot = PlaneTraits::Point_2;  ///< a point whose coordinates are a + b sqrt(c)
using Coordinate = OneRoot::CoordNT;

inline Rational exact_point(const Vec2& p) {
    return {Number(p.x()), Number(p.y())};
}

/// Rounded to within a few units in the last place: a + b sqrt(c) is rewritten where it cancels.
inline double rounded(const Coordinate& v) {
    const auto a = CGAL::exact(v.a0());
    if (!v.is_extended()) return CGAL::to_double(a);
    const auto b = CGAL::exact(v.a1()), c = CGAL::exact(v.root());
    const double da = CGAL::to_double(a), db = CGAL::to_double(b) * std::sqrt(CGAL::to_double(c));
    if (da * db >= 0) return da + db;
    return CGAL::to_double(decltype(a)(a * a - b * b * c)) / (da - db);
}

inline Vec2 rounded(const OneRoot& p) {
    return {rounded(p.x()), rounded(p.y())};
}

/// The curve in what CGAL hands over, a point or a curve: by itself, in boost's variant (CGAL 5) or in the standard's (CGAL 6).
template <class Curve, class Made>
const Curve* curve_in(const Made& made) {
    if constexpr (std::is_same_v<Made, Curve>)
        return &made;
    else if constexpr (std::is_same_v<Made, std::variant<OneRoot, Curve>>)
        return std::get_if<Curve>(&made);
    else
        return boost::get<Curve>(&made);
}

}  // namespace abut::geometry
