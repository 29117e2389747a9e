// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/contact/detect.hpp"
#include "src/results/result.hpp"
#include "src/scene/scene.hpp"

namespace abut {

inline constexpr double thumbnail_width = 132, thumbnail_height = 88;  ///< pixels, at most

/// The parts of a job as a small picture (SVG), and where they meet: contacts of an answer that carry are red, the others
/// orange.
std::string thumbnail(const Scene& scene, const Result& result);
/// The parts of a job as a small picture (SVG) with the detected pairs: red where they touch, orange where there is a gap,
/// violet where they overlap.
std::string thumbnail(const Scene& scene, const Detection& detection);

}  // namespace abut
