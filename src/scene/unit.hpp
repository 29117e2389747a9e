// SPDX-License-Identifier: GPL-3.0-or-later
// Units that a scene may write behind a number: "210 GPa", "7850 kg/m^3".
#pragma once
#include <string>

namespace abut {

/// The dimension of a quantity: exponents of length, force, time, temperature and angle. Mass is force time^2 per length.
struct Dimension {
    int length = 0, force = 0, time = 0, temperature = 0, angle = 0;
    bool operator==(const Dimension&) const = default;
};

/// The dimensions of the numbers in scenes.
namespace dimension {
inline constexpr Dimension none{};
inline constexpr Dimension length{1};
inline constexpr Dimension force{0, 1};
inline constexpr Dimension moment{1, 1};
inline constexpr Dimension stress{-2, 1};
inline constexpr Dimension foundation{-3, 1};  ///< stress per displacement
inline constexpr Dimension body_force{-3, 1};
inline constexpr Dimension density{-4, 1, 2};
inline constexpr Dimension acceleration{1, 0, -2};
inline constexpr Dimension temperature{0, 0, 0, 1};
inline constexpr Dimension expansion{0, 0, 0, -1};
inline constexpr Dimension angle{0, 0, 0, 0, 1};
inline constexpr Dimension angular_speed{0, 0, -1, 0, 1};
}  // namespace dimension

/// A unit: what it measures, and how many of the units made of m, N, s, K and rad it is. The factor is long, so that what is
/// a power of ten is one after a conversion, too.
struct Unit {
    Dimension dimension;
    long double size = 1;
};

/// Reads a unit: symbols with whole powers, multiplied by * or a space and divided by /, as in kg/m^3, N*s^2/mm^4, 1/K.
/// Throws InputError (where left empty) that names what is not known.
Unit parse_unit(const std::string& text);

/// The units that the numbers of a scene are in; texts are empty where it names none.
struct SceneUnits {
    std::string length, force;
};

/// What a number in the unit `text` is to be multiplied by to be in the scene's units: those of length and force, s, K,
/// degrees for angles and rad/s for angular speeds. Throws InputError (where left empty) where the unit is unknown, has
/// another dimension, or the scene does not name the units that it takes.
double unit_factor(const std::string& text, const Dimension& wanted, const SceneUnits& scene);

/// What unit_factor gives, for a quantity of whatever dimension, which is set.
double unit_factor_of_any(const std::string& text, const SceneUnits& scene, Dimension& dimension);

/// A dimension in words, with units that fit: "a length (mm, m, in)".
std::string dimension_text(const Dimension& dimension);

}  // namespace abut
