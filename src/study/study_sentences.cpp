// SPDX-License-Identifier: GPL-3.0-or-later
// The study in words.
#include <algorithm>
#include <cmath>

#include "src/io/number_text.hpp"
#include "src/results/result_units.hpp"
#include "src/study/study_prices.hpp"

namespace abut {

namespace {

using Status = StudyRun::Status;

constexpr double largest_of_interest = 0.1;  ///< errors above are for the tables

std::string factor_text(double factor) {
    return "x " + number_text(factor, 2);
}

/// "20 % costs 8.1 ms (draft), 1 % 12 ms (standard)": one entry for each run, with the least error that it is cheapest for.
std::string cost_list(const Study& study, const std::vector<CheapestSetting>& list,
                      std::optional<std::size_t> CheapestSetting::*which) {
    std::vector<std::string> items;
    for (std::size_t k = 0; k < list.size(); ++k) {
        const std::optional<std::size_t> run = list[k].*which;
        if (!run || list[k].error > largest_of_interest || (k + 1 < list.size() && list[k + 1].*which == run)) continue;
        items.push_back(percent_text(list[k].error) + (items.empty() ? " costs " : " ") +
                        duration_text(study.runs[*run].solver_seconds) + " (" + setting_text(study.runs[*run].setting) + ")");
    }
    return joined(items, ", ");
}

std::string level_sentence(const Study& study, const std::vector<CheapestSetting>& list) {
    const std::string costs = cost_list(study, list, &CheapestSetting::level);
    return costs.empty() ? "" : costs + ", contact and grids still to be found.";
}

std::string grid_sentence(const Study& study, const std::vector<CheapestSetting>& list) {
    const std::string costs = cost_list(study, list, &CheapestSetting::grid);
    return costs.empty() ? "" : "On one grid that is given, " + costs + ".";
}

/// Of the levels, and of the degrees on given grids; the page has the others.
std::string halving_sentence(const Study& study, std::size_t measure) {
    std::vector<std::string> items;
    for (const PriceOfHalving& p : prices_of_halving(study, measure))
        if (p.like.kind != StudySetting::Kind::uniform && p.like.basis == "web")
            items.push_back(factor_text(p.factor) + (items.empty() ? " time" : "") + " with " + p.family);
    return items.empty() ? "" : "Halving the error costs " + joined(items, ", ") + ".";
}

std::string share_sentence(const Study& study) {
    const auto run =
        std::find_if(study.runs.begin(), study.runs.end(), [](const StudyRun& r) { return r.status == Status::ok; });
    if (run == study.runs.end() || !(run->seconds > 0)) return "";
    std::array<std::size_t, study_stages.size()> order{};
    for (std::size_t s = 0; s < order.size(); ++s) order[s] = s;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return run->stage[a] > run->stage[b]; });
    std::vector<std::string> items;
    for (std::size_t k = 0; k < 3; ++k)
        items.push_back(std::string(study_stages[order[k]]) + " " + number_text(100 * run->stage[order[k]] / run->seconds, 2) +
                        " %");
    return "Of the whole run at " + setting_text(run->setting) + ", " + duration_text(run->seconds) + ", most is " +
           joined(items, ", ") + ".";
}

std::string growth_sentence(const Study& study) {
    for (const StudyFamily& family : families_of(study)) {
        if (family.name != "degree 2") continue;
        if (const auto exponent = time_exponent(study, family))
            return "Solver time of degree 2 grows with the unknowns to the power " + number_text(*exponent, 3) + ".";
    }
    return "";
}

/// "7 of degree 4, normalized; 2 of equal cells": how many runs ended so, by family.
std::string count_by_family(const Study& study, Status status) {
    std::vector<std::pair<std::string, int>> counts;
    for (const StudyRun& run : study.runs) {
        if (run.status != status) continue;
        const std::string name = family_name(run.setting);
        auto found = std::find_if(counts.begin(), counts.end(), [&](const auto& c) { return c.first == name; });
        if (found == counts.end()) found = counts.insert(found, {name, 0});
        ++found->second;
    }
    std::vector<std::string> items;
    for (const auto& [name, n] : counts) items.push_back(std::to_string(n) + " of " + name);
    return joined(items, "; ");
}

std::string failed_sentence(const Study& study) {
    const std::string counts = count_by_family(study, Status::failed);
    return counts.empty() ? "" : "Failed: " + counts + "; the list of runs says why.";
}

std::string skipped_sentence(const Study& study) {
    const std::string counts = count_by_family(study, Status::skipped);
    return counts.empty() ? "" : "Left out for the budget of " + duration_text(study.budget) + ": " + counts + ".";
}

}  // namespace

std::vector<std::string> study_sentences(const Study& study, std::size_t measure) {
    const std::vector<CheapestSetting> list = cheapest_settings(study, measure);
    std::vector<std::string> sentences{
        level_sentence(study, list), grid_sentence(study, list), halving_sentence(study, measure), share_sentence(study),
        growth_sentence(study),      failed_sentence(study),     skipped_sentence(study)};
    std::erase(sentences, "");
    return sentences;
}

}  // namespace abut
