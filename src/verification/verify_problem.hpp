// SPDX-License-Identifier: GPL-3.0-or-later
// What a verification problem is: scenes to run, and quantities of their answers with references.
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/results/result.hpp"
#include "src/scene/scene.hpp"

namespace abut {

/// One analysis of a problem.
struct VerifyRun {
    std::string scene;                           ///< relative to the data folder
    std::map<std::string, double> parameters{};  ///< in place of the scene's
    std::optional<Analysis> analysis{};          ///< in place of the scene's
    std::optional<PenaltyOptions> penalty{};     ///< in place of the scene's formulation
    bool by_dissertation = false;                ///< by its method (dissertation_method.hpp), with that penalty
};

/// The answers of a problem's runs, in their order; of a scene with cases or steps one of each.
using Answers = std::vector<Result>;

/// A number of a problem's answers, with its reference.
struct Quantity {
    std::string what;
    std::function<double(const Answers&)> value;
    double reference = 0;
    std::optional<double> tolerance;  ///< on the relative error; unset: the quantity is recorded, not judged
    double scale = 0;                 ///< what the error is relative to; 0: the reference's size
};

/// A problem: its runs and what is compared of them.
struct VerifyProblem {
    std::string name;             ///< "E4-quarter"; the group is what stands before the first '-'
    std::string about;            ///< one line
    std::vector<VerifyRun> runs;  ///< empty: the quantities need no scene
    std::vector<Quantity> quantities;
    bool expects_failure = false;  ///< the analysis is to fail, and its message is what is looked at
};

/// The problems of each kind, in order of their names.
std::vector<VerifyProblem> patch_problems();         ///< E1, E6: fields that the splines hold exactly
std::vector<VerifyProblem> beam_problems();          ///< E2
std::vector<VerifyProblem> plate_problems();         ///< E3
std::vector<VerifyProblem> ring_problems();          ///< E4, E10, and the disc of E5
std::vector<VerifyProblem> membrane_problems();      ///< E8
std::vector<VerifyProblem> corner_problems();        ///< E9
std::vector<VerifyProblem> half_plane_problems();    ///< E13
std::vector<VerifyProblem> spline_beam_problems();   ///< E14
std::vector<VerifyProblem> hertz_problems();         ///< C1, C2, C4 with fillets, C5, S-B, S-C
std::vector<VerifyProblem> block_problems();         ///< C3, C4, C9, S-A, S-E
std::vector<VerifyProblem> pin_problems();           ///< C6, C7, S-D
std::vector<VerifyProblem> support_problems();       ///< what holds a part and what does not
std::vector<VerifyProblem> preload_problems();       ///< H2: tightened bolts
std::vector<VerifyProblem> spin_problems();          ///< E5
std::vector<VerifyProblem> thermal_problems();       ///< E7, and interference by temperature
std::vector<VerifyProblem> friction_problems();      ///< F: friction, at the limit of rest and between
std::vector<VerifyProblem> load_path_problems();     ///< F14 on: friction where the way of the loads counts
std::vector<VerifyProblem> motion_problems();        ///< L: parts that go far before they rest
std::vector<VerifyProblem> axisymmetric_problems();  ///< R: cylinders, spheres, discs, press fits and Hertz around an axis

}  // namespace abut
