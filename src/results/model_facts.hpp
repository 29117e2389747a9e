// SPDX-License-Identifier: GPL-3.0-or-later
// What was analysed, as the scene gives it: for readers of an answer, who have no scene at hand. Nothing is computed from it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "src/io/content_hash.hpp"
#include "src/results/result.hpp"

namespace abut {

/// A material; numbers in the scene's units.
struct MaterialFacts {
    std::string name;
    double E = 0, nu = 0;
    std::optional<double> density, expansion, yield;
    bool rigid = false;  ///< E and nu mean nothing then
};

/// What a part is made of.
struct PartFacts {
    std::string name, material;
    double thickness = 1;
    bool default_thickness = false;  ///< neither the part nor the scene gives one
};

/// A load.
struct LoadFacts {
    std::string name, kind;       ///< kind: the scene's word: "force", "pressure", ...; name: may be empty
    std::vector<double> value;    ///< one number or two components; empty: it varies from point to point
    std::string unit;             ///< of the value, as far as the scene's units tell it
    std::vector<std::string> on;  ///< "part/edge" for each edge, or a part; empty: all parts
    std::vector<Vec2> at{};       ///< points where it acts, for pictures
};

/// A support.
struct SupportFacts {
    std::string label;            ///< "fix x, y on base/bottom"
    std::vector<std::string> on;  ///< "part/edge" for each edge, or a part
    std::vector<Vec2> at{};       ///< points where it holds, for pictures
};

/// The model.
struct ModelFacts {
    std::string begun{};                  ///< when the run began: "2026-01-31T12:00:00Z"; may be empty
    std::vector<HashedFile> files;        ///< the scene's file, and those that it imports; empty: made from no file
    std::string length_unit, force_unit;  ///< empty: not given
    std::string analysis;                 ///< "plane_stress", "plane_strain", "axisymmetric"; empty: nothing is known
    std::vector<MaterialFacts> materials;
    std::vector<PartFacts> parts;
    std::vector<LoadFacts> loads;
    std::vector<SupportFacts> supports;
};

/// The model as JSON text, for result.json and the report.
std::string model_json(const ModelFacts& model);

/// The text of result.json with the model in it.
std::string result_json(const Result& result, const ModelFacts& model);

/// A number as the scene has it: "210000".
std::string fact_number(double value);

/// A load's kind and value: "force (0, -20000) N".
std::string load_words(const LoadFacts& load);

/// "plane stress", ...; empty where nothing is known.
std::string analysis_words(const ModelFacts& model);

}  // namespace abut
