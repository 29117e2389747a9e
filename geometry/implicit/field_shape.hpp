// SPDX-License-Identifier: GPL-3.0-or-later
// What is behind an ImplicitField: a formula, evaluated over doubles or over jets.
#pragma once
#include <utility>

#include "geometry/implicit/implicit.hpp"
#include "geometry/implicit/jet.hpp"

namespace abut::geometry {

/// A formula behind a field: values from doubles, derivatives from jets.
class FieldShape {
public:
    FieldShape() = default;
    FieldShape(const FieldShape&) = delete;
    FieldShape& operator=(const FieldShape&) = delete;
    virtual ~FieldShape() = default;
    virtual double at(const PointOf<double>& p) const = 0;
    virtual Jet at(const PointOf<Jet>& p) const = 0;
};

/// The field of a formula: a callable over PointOf<T> that gives a T, for T = double and T = Jet.
template <class Formula>
class FormulaShape final : public FieldShape {
public:
    explicit FormulaShape(Formula formula) : formula_(std::move(formula)) {}
    double at(const PointOf<double>& p) const override { return formula_(p); }
    Jet at(const PointOf<Jet>& p) const override { return formula_(p); }

private:
    Formula formula_;
};

template <class Formula>
ImplicitField make_field(Formula formula) {
    return {std::make_shared<const FormulaShape<Formula>>(std::move(formula))};
}

/// The plane's coordinates as jets.
inline PointOf<Jet> jets_at(const Vec2& p) {
    return {Jet(p.x(), 1, 0, 0, 0, 0), Jet(p.y(), 0, 1, 0, 0, 0)};
}

}  // namespace abut::geometry
