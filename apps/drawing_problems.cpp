// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/drawing_problems.hpp"

#include <utility>

#include "apps/drawing_options.hpp"
#include "geometry/brep/input_error.hpp"
#include "src/scene/read_sketch.hpp"

namespace abut {

namespace {

Problem as_problem(const std::string& file, const geometry::SketchProblem& problem) {
    std::string where = file;
    if (problem.line > 0) where += ":" + std::to_string(problem.line);
    if (!problem.entity.empty()) where += ": " + problem.entity;
    return {where, problem.what, problem.hint};
}

}  // namespace

void throw_if_any(const std::string& file, const std::vector<geometry::SketchProblem>& problems) {
    std::vector<Problem> lines;
    lines.reserve(problems.size());
    for (const geometry::SketchProblem& problem : problems) lines.push_back(as_problem(file, problem));
    if (!lines.empty()) throw InputError(std::move(lines));
}

void refuse_guesses(const Scene& scene, const Arguments& arguments) {
    if (!has(arguments, "--strict")) return;
    for (const ImportRecord& record : scene.imports) throw_if_any(record.file, record.warnings);
}

SketchReading read_whole_sketch(const Arguments& arguments) {
    return read_whole_sketch(arguments.operand, drawing_options(arguments));
}

SketchReading read_whole_sketch(const std::string& file, const ImportOptions& options) {
    SketchReading reading = read_sketch(file, options);
    std::vector<geometry::SketchProblem> problems = reading.drawing.problems;
    problems.insert(problems.end(), reading.sketch.problems.begin(), reading.sketch.problems.end());
    throw_if_any(file, problems);
    return reading;
}

}  // namespace abut
