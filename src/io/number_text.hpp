// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as people read them.
#pragma once
#include <string>

namespace abut {

/// The shortest sensible decimal text with the given number of significant digits: "0.0115", "1.2e+05".
std::string number_text(double value, int digits);
/// A share as per cent to two digits: "1.5 %".
std::string percent_text(double fraction);
/// A number with as many digits more as tell it from another: "1.03" beside "1".
std::string number_beside(double value, double other, int digits);
/// A share with as many digits more as tell it from another: "1.03 %" beside "1 %".
std::string percent_beside(double fraction, double other);
/// A coordinate in an SVG attribute, to a hundredth of a pixel: "12.3".
std::string coordinate_text(double pixels);

}  // namespace abut
