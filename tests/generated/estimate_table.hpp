// SPDX-License-Identifier: GPL-3.0-or-later
// Stated errors over true ones, for every quantity that an answer states, over many scenes and the three levels of accuracy.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "src/scene/scene.hpp"

namespace abut::test {

class EstimateTable {
public:
    /// Runs the scene at draft, standard and fine; true is what a run at a fifth of fine's target has.
    void add(const std::string& name, const Scene& scene);
    /// The same against values from elsewhere: {"name", "scene", "doubt", "energy", "contacts": [{"parts", "force", "peak",
    /// "length"}], "parts": [{"part", "displacement", "von_mises"}]}, as JSON text; doubt: how far they are off, relative.
    void add_against(const std::string& json);

    /// One line for each scene, level and quantity.
    std::string rows() const;
    /// By quantity and level: how many, 5 %, 50 % and 95 % of estimate over truth, how many are too low by more than 2.
    std::string summary() const;

private:
    struct Row {
        std::string scene, level, quantity;
        std::optional<double> estimate;
        double truth = 0;
    };
    void compare(const std::string& name, const std::string& level, const struct Values& now, const struct Values& truth);
    std::vector<Row> rows_;
    int refused_ = 0;
};

}  // namespace abut::test
