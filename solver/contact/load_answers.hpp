// SPDX-License-Identifier: GPL-3.0-or-later
// The answers of one assembly to its loads at any factors. What each load does to the parts by themselves, and how the rows
// give way under each other's forces, is found once by the parts' factors; what is left for an answer is the contact problem
// between them. Loads are dead: they do not follow the motions.
#pragma once
#include <memory>
#include <vector>

#include "solver/contact/assembly_rows.hpp"
#include "solver/linear_algebra/closed_factor.hpp"

namespace abut::solver {

/// One load of an assembly, at factor 1.
struct UnitLoad {
    std::vector<Eigen::VectorXd> on_part;  ///< (2n) by part; an empty vector: nothing acts on that part
    double scale = 0;                      ///< the largest load on any body
};

/// A number that is linear in the displacements: the sum over the parts of weight (2n) . u; an empty vector: that part has no
/// share in it.
using DisplacementMeasure = std::vector<Eigen::VectorXd>;

/// What an assembly answers to loads at given factors.
struct LoadAnswer {
    std::vector<Eigen::VectorXd> pressure;  ///< by interface
    std::vector<double> constraint_force;   ///< by constraint
    Eigen::VectorXd measured;               ///< by measure
    Eigen::VectorXd multipliers;            ///< by row
    Eigen::VectorXd amplitudes;             ///< of all free motions, neutral ones included
    std::vector<PartMotion> mechanism;      ///< not empty: the loads drive these motions, nothing else is filled in
    int iterations = 0;
    bool converged = false;
};

/// Answers an assembly, each time from the contact that it found last: that is speed, the answer is the same. With friction
/// every answer is one step from the state before that the problem has, and is searched anew.
class LoadAnswers {
public:
    /// Cost: rows and compliance as of solve_assembly, and a solution of the parts for each load and measure. The problem is
    /// looked at as long as this lives; its parts' own loads always act. Solves side by side on `threads` threads.
    LoadAnswers(const AssemblyProblem& problem, std::vector<UnitLoad> loads, const std::vector<DisplacementMeasure>& measures,
                int threads);
    LoadAnswers(const LoadAnswers&) = delete;
    LoadAnswers& operator=(const LoadAnswers&) = delete;

    /// Answers the loads times these factors. Cost: a few products with the compliance of the rows; one factorisation of it the
    /// first time, and as much of it again as closed rows change.
    LoadAnswer answer(const Eigen::VectorXd& factors);

    /// The displacements (2n) by part of such an answer. Cost: a solution of every part.
    std::vector<Eigen::VectorXd> displacements(const Eigen::VectorXd& factors, const LoadAnswer& answer, int threads) const;

private:
    struct Found {
        ContactQpResult result;
        Eigen::VectorXd amplitudes;  ///< of all free motions
    };
    Found search(const Eigen::VectorXd& mode_load, const Eigen::VectorXd& factors);
    Found search_anew(const Eigen::VectorXd& mode_load, const Eigen::VectorXd& factors) const;
    void respond_to_loads(int threads);
    void respond_to_measures(const std::vector<DisplacementMeasure>& measures, int threads);
    Eigen::VectorXd measured(const Eigen::VectorXd& factors, LoadAnswer& answer) const;

    const AssemblyProblem& problem_;
    std::vector<UnitLoad> loads_;
    AssemblyRows rows_;
    Resistance resistance_;
    ContactQp qp_;  ///< in the motions that something resists; gaps and loads on motions are those of the last answer
    Eigen::MatrixXd modes_, levers_;
    MotionSplit split_;
    double load_scale_;                     ///< of what always acts
    Eigen::VectorXd gap_, mode_load_;       ///< under what always acts
    Eigen::MatrixXd gaps_, mode_loads_;     ///< by load
    Eigen::VectorXd unheld_;                ///< amplitudes under what always acts, with friction (unheld_amplitudes)
    Eigen::MatrixXd unheld_of_loads_;       ///< what loads add to them, by load
    std::unique_ptr<ClosedFactor> factor_;  ///< of the rows that were closed last
    Eigen::VectorXd resisted_amplitudes_;   ///< of the last answer
    // The measures, and after them those of the neutral motions: of what always acts, by load, by multiplier, by amplitude.
    Eigen::VectorXd measure_;
    Eigen::MatrixXd measures_of_loads_, measures_of_rows_, measures_of_modes_, neutral_gram_;
};

}  // namespace abut::solver
