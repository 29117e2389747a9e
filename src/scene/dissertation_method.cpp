// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/scene/dissertation_method.hpp"

namespace abut {

void take_dissertation_method(Scene& scene) {
    Accuracy& accuracy = scene.accuracy;
    accuracy.method = "dissertation";
    accuracy.basis = "normalized";
    accuracy.dirichlet = "solution_structure";
    if (accuracy.weights == "auto") accuracy.weights = "r_function";
    accuracy.target.reset();
    accuracy.refine.clear();
    accuracy.adapt = false;
    PenaltyOptions penalty = scene.contacts.penalty.value_or(PenaltyOptions{});
    penalty.pairing = Pairing::master;
    penalty.split_by_second = false;
    scene.contacts.penalty = penalty;
}

}  // namespace abut
