// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/results/findings.hpp"

#include <algorithm>
#include <utility>

namespace abut {

std::string first_few(const std::vector<std::string>& names) {
    constexpr std::size_t named = 4;
    std::string text;
    for (std::size_t k = 0; k < std::min(named, names.size()); ++k) text += (k == 0 ? "" : ", ") + names[k];
    return names.size() > named ? text + " and " + std::to_string(names.size() - named) + " more" : text;
}

std::vector<Finding> values_of(const std::map<std::string, Finding>& findings) {
    std::vector<Finding> list;
    for (const auto& [subject, finding] : findings) list.push_back(finding);
    return list;
}

void remark(std::vector<Finding> findings, Result& result) {
    for (Finding& f : findings) f.reason.clear();
    tell(std::move(findings), "", result);
}

void tell(std::vector<Finding> findings, const std::string& kind, Result& result) {
    if (findings.empty()) return;
    const auto speaks_against = [](const Finding& f) { return !f.reason.empty(); };
    std::stable_sort(findings.begin(), findings.end(), [&](const Finding& a, const Finding& b) {
        return speaks_against(a) != speaks_against(b) ? speaks_against(a) : a.measure > b.measure;
    });
    const Finding& worst = findings.front();
    std::vector<std::string> others;
    for (std::size_t k = 1; k < findings.size(); ++k) others.push_back(findings[k].subject);
    const auto count_text = [](std::size_t n) { return n == 1 ? "1 other" : std::to_string(n) + " others"; };
    result.warnings.push_back(worst.warning +
                              (others.empty() ? "" : "; the same of " + count_text(others.size()) + ": " + first_few(others)));
    const auto n = static_cast<std::size_t>(std::count_if(findings.begin(), findings.end(), speaks_against));
    if (n > 0) result.reasons.push_back({kind, worst.reason + (n == 1 ? "" : " (and " + count_text(n - 1) + ")")});
}

}  // namespace abut
