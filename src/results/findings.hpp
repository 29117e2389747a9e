// SPDX-License-Identifier: GPL-3.0-or-later
// What is found wrong with one part or contact after the other is said once.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "src/results/result.hpp"

namespace abut {

/// Something found of one part or contact.
struct Finding {
    double measure;        ///< how bad it is: the worst is told in full, the others by name
    std::string subject;   ///< its name: "strap", "contact 2"
    std::string warning;   ///< a whole sentence
    std::string reason{};  ///< the warning as a clause of the verdict; empty: it says nothing against the answer
};

/// Says findings of one kind: one warning and, where any has a reason, one reason, however many findings there are; nothing for
/// none. The worst is that of those with a reason, where any has one. The schema of result.json says what each kind means.
void tell(std::vector<Finding> findings, const std::string& kind, Result& result);

/// Says findings that are never reasons against an answer: one warning, however many there are.
void remark(std::vector<Finding> findings, Result& result);

/// The findings of a map that holds each subject once.
std::vector<Finding> values_of(const std::map<std::string, Finding>& findings);

/// The first few names: "a, b, c, d and 7 more".
std::string first_few(const std::vector<std::string>& names);

}  // namespace abut
