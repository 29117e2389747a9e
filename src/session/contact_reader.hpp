// SPDX-License-Identifier: GPL-3.0-or-later
// A contact's coefficients as what is told of it; all that does not depend on them is found once.
#pragma once
#include "solver/contact/load_answers.hpp"
#include "src/session/answer.hpp"
#include "src/solution/solved_assembly.hpp"

namespace abut {

/// What is told of one contact, and what doubts rest on.
struct ReadContact {
    ContactAnswer answer;
    double end_error = 0, norm = 0;  ///< of its pressure: L2 error beside the free ends; L2 norm
    bool leaves_search = false;      ///< contact reaches an end of the zone that only the search distance made
};

/// Reads one contact of a solved assembly, which it looks at as long as it lives.
class ContactReader {
public:
    /// told: of the same contact, for its names.
    ContactReader(const Scene& scene, const SolvedAssembly& solved, std::size_t contact, const ContactResult& told);
    /// load_scale: the largest single load.
    ReadContact read(const solver::LoadAnswer& answer, double load_scale) const;

private:
    struct Sample {
        int first;  // coefficient
        solver::LocalValues value;
        double weight;  // of its neighbourhood along the middle curve
    };
    double value_of(const Sample& sample, const Eigen::VectorXd& coefficients) const;
    void add_sample(const Scene& scene, double s, double weight, ContactPlaces& places);

    const SolvedAssembly& solved_;
    std::size_t contact_;
    ContactAnswer told_;
    std::vector<Sample> samples_;
    Eigen::Matrix3Xd forces_, shear_forces_;  // by coefficient
};

}  // namespace abut
