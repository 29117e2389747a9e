// SPDX-License-Identifier: GPL-3.0-or-later
// One run of a study: the scene solved at one setting a few times, and what is kept of it.
#pragma once
#include <string>
#include <vector>

#include "geometry/brep/input_error.hpp"
#include "src/scene/scene.hpp"
#include "src/study/study.hpp"
#include "src/verification/verify_problem.hpp"

namespace abut {

/// The numbers that runs are compared by where no closed form is known.
struct StudyAnswer {
    struct Contact {
        std::string between;  ///< both edges
        Vec2 force{0, 0};
        double peak = 0;
        std::vector<double> x, y, pressure;  ///< along the first part's edge
    };
    std::vector<Contact> contacts;
    std::vector<Vec2> probes;       ///< their displacements
    double energy = 0, stress = 0;  ///< strain energy; largest von Mises stress
};

/// A grid that a part was solved on.
struct StudyGrid {
    std::string part;
    double angle = 0;
    std::vector<double> x, y;
    std::vector<PartResult::Halved> halved{};
    int n_cells = 0;
};

/// A measured run with what later runs are compared with or made from.
struct StudyMeasured {
    StudyRun run;
    std::vector<Problem> problems;    ///< not empty: the scene's own fault, nothing else is filled in
    std::vector<double> known_error;  ///< by quantity of the problem
    StudyAnswer answer;
    std::vector<StudyGrid> grids;
};

/// The makings of one run of the study.
struct StudyTask {
    std::string scene_path;
    StudySetting setting;
    const std::vector<StudyGrid>* grids = nullptr;  ///< those of "standard"; not of Kind::level
    double equal_size = 0;                          ///< of Kind::uniform: size of cells at setting.size = 1
    const VerifyProblem* known = nullptr;           ///< closed forms, may be none
    double repeated_seconds = 0;
};

/// Solves a run in a child process, as often as short runs allow.
StudyMeasured measure(const StudyTask& task, double limit_seconds);

/// The scene with the setting in place of its accuracy.
Scene scene_at(Scene scene, const StudyTask& task);

/// Grid lines with cells `size` times as large: the first and the last line stay, the others follow the grid's own grading.
std::vector<double> resized_lines(const std::vector<double>& lines, double size);

/// A measured run as text, between processes, and back.
std::string measured_text(const StudyMeasured& measured);
StudyMeasured measured_from(const std::string& text);

}  // namespace abut
