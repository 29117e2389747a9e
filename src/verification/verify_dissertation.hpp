// SPDX-License-Identifier: GPL-3.0-or-later
// The dissertation's tables 4.1-4.5, 5.1 and 5.2 [Grishin10] with our answers to the same problems beside the printed ones.
#pragma once
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "src/verification/verify.hpp"

namespace abut {

/// Our columns. On the dissertation's grids: its method as it was written (accuracy.method), our own with its penalty
/// formulation (50 E of the stiffer part over a length of 1) and with mortar; and what abut does by itself.
enum class Ours { written, penalty, mortar, automatic };
inline constexpr std::size_t n_ours = 4;
inline constexpr std::array<const char*, n_ours> ours_name{"written", "penalty", "mortar", "default"};

/// The line that table 5.2 is made of.
inline constexpr const char* whole_condition = "condition number, all parts, not scaled";

/// A tolerance that a value of one of our columns must keep to.
struct Judged {
    Ours column;
    double tolerance;            ///< on the error relative to the reference
    bool below_printed = false;  ///< instead: it must stay below this fraction of the printed mesh-free value
};

/// One line of a dissertation's table, with what our answers to it are judged by.
struct DissertationLine {
    std::string what, unit;                                     ///< unit: powers of F (force) and L (length); empty: a number
    std::function<std::optional<double>(const Result&)> value;  ///< unset: the answer does not tell
    std::optional<double> ansys{}, mesh_free{};                 ///< as printed
    std::optional<double> reference{};                          ///< converged number or closed form, for the scene as it stands
    std::vector<Judged> judged{};                               ///< all others are recorded
    std::string mark{};                                         ///< of a footnote: a misprint
};

/// One of the dissertation's tables: our runs, its lines, and notes on them.
struct DissertationTable {
    std::string name, title;  ///< "B"; "Case B: convex cylinders (tables 4.2, 5.1, 5.2, Figure 5.4)"
    std::array<std::optional<VerifyRun>, n_ours> runs;
    std::vector<DissertationLine> lines;
    std::vector<std::string> notes{};
    /// What the figure of the pressure has it beside: over x up to the half width, in the words given; unset: no such figure.
    struct Curve {
        std::string name;
        double half_width;
        std::function<double(double)> pressure;
    };
    std::optional<Curve> pressure{};
    std::string figures{};  ///< those of the dissertation that ours correspond to: "5.3, 5.4"
};

/// The dissertation's tables, in its order.
std::vector<DissertationTable> dissertation_tables();

/// A dissertation's table with our answers.
struct SolvedTable {
    DissertationTable table;
    /// The cells by line and column; unset where the column has no run or its answer does not tell.
    std::vector<std::array<std::optional<VerifyRow>, n_ours>> cells;
    std::array<std::optional<Result>, n_ours> answers;  ///< by column, for the figures
};

/// Solves a table's runs. Throws InputError where a scene cannot be read.
SolvedTable solve_table(const DissertationTable& table, const std::string& data_folder);

/// The cells as rows of `abut verify --json`: names "dissertation-B-mortar", the reference our own or else the printed
/// mesh-free value (NaN without either).
std::vector<VerifyRow> rows_of(const SolvedTable& solved);

/// The tables as text, one block each, then table 5.2, and how to read them.
std::string dissertation_text(const std::vector<SolvedTable>& solved);
/// The tables' line in `abut verify --list`.
std::string dissertation_list();

}  // namespace abut
