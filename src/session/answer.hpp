// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "src/results/result.hpp"

namespace abut {

/// Where a contact's pressure is told: points along the first part's edges. Lists are parallel; arc lengths are on the model's
/// edges, in their own direction.
struct ContactPlaces {
    std::vector<std::string> edge;  ///< "part/edge"
    std::vector<double> s, x, y;
};

/// What a contact does under the loads of one answer.
struct ContactAnswer {
    std::array<std::string, 2> parts, between;
    std::string kind, status;  ///< contact, bonded; closed, partial, open
    Vec2 force{0, 0};          ///< on the first part, total over the thickness
    double moment = 0;         ///< about the origin
    double contact_length = 0;
    ValueAt max_pressure;
    std::vector<double> pressure;  ///< at `places`; positive in compression
    std::vector<double>
        shear;  ///< there, of bonds and friction where pressed: on the second part, along its normal turned left
    std::shared_ptr<const ContactPlaces> places;
    /// The estimated error of the pressure beside its free ends (L2), relative to the strongest contact's pressure.
    double error_at_ends = 0;
};

/// The displacement of a point that the scene's output asks for.
struct ProbeAnswer {
    std::string part;
    Vec2 at, displacement;
};

/// The answer to loads at given factors, in the scene's units and assembly coordinates.
struct Answer {
    std::string status = "ok", message;   ///< status: ok, failed; then the message says why, and what follows is empty
    std::vector<PartTwist> driven{};      ///< failed: as of the result
    std::vector<ContactAnswer> contacts;  ///< as in the result that was prepared
    std::vector<ProbeAnswer> probes;
    /// Why it may be less accurate than what was prepared: contact where the interfaces are coarse, or beyond them.
    std::vector<std::string> doubts;
};

}  // namespace abut
