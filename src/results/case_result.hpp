// SPDX-License-Identifier: GPL-3.0-or-later
// The answers of several load cases, and what is largest in any of them.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/results/result.hpp"
#include "src/results/verdict.hpp"

namespace abut {

/// The answer of one load case.
struct CaseResult {
    std::string name;
    std::map<std::string, double> factors;  ///< of its loads, by name
    Result result;
    bool is_step = false;  ///< it begins where the one before ends
};

/// A largest value, where it is, and in which case (index).
struct CaseValue {
    double value = 0;
    Vec2 at{0, 0};
    std::size_t in_case = 0;
};

/// The largest values of one contact, in the cases that have an answer. Contacts of two cases are the same where their edges
/// are; of several on the same edges the first is the first.
struct ContactEnvelope {
    std::array<std::string, 2> parts;
    std::array<std::vector<std::string>, 2> edges;
    CaseValue max_pressure, force, contact_length;  ///< force: its magnitude; where it and the length are is not told
    std::vector<std::size_t> open_in;               ///< cases in which it carries nothing
};

/// The largest values of one part.
struct PartEnvelope {
    std::string name;
    CaseValue max_von_mises, max_displacement;
    std::optional<CaseValue> utilisation;
};

/// The largest values of all cases that have an answer, empty where none has; those of equal size are of the first.
struct Envelope {
    std::vector<ContactEnvelope> contacts;  ///< in the order in which they first appear
    std::vector<PartEnvelope> parts;        ///< in the scene's order
};
Envelope envelope_of(const std::vector<CaseResult>& cases);

/// The envelope line by line, for tables: every largest value with what it is of.
struct EnvelopeLine {
    std::string of, quantity, unit;  ///< "block/top - base/top", "max pressure", "MPa"
    CaseValue largest;
    bool has_place;
};
std::vector<EnvelopeLine> envelope_lines(const std::vector<CaseResult>& cases);

/// The worst verdict of the cases.
Verdict verdict_of(const std::vector<CaseResult>& cases);
/// The folder of a case's files: "case_1", from 1.
std::string case_folder(std::size_t k);

/// The folders that a cases.json lists, of names that case_folder gives; none where the text is no such file.
std::vector<std::string> folders_of_cases(const std::string& text);

/// The text of cases.json (data/schema/cases.schema.json); deterministic.
std::string cases_json(const std::vector<CaseResult>& cases);
/// The text of envelope.csv.
std::string envelope_csv(const std::vector<CaseResult>& cases);
/// The table that `analyze` prints.
std::string cases_table(const std::vector<CaseResult>& cases);

}  // namespace abut
