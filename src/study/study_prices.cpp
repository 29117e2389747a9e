// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/study_prices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "src/results/result_units.hpp"

namespace abut {

namespace {

using Kind = StudySetting::Kind;

constexpr double least_fall = 2;  ///< of the error along a family, for its price to mean something
constexpr std::size_t least_runs = 3;

bool is_like(const StudySetting& a, const StudySetting& b) {
    return a.kind == b.kind && a.degree == b.degree && a.basis == b.basis && a.threads == b.threads;
}

/// Slope of a straight line through points, by least squares.
double slope(const std::vector<double>& x, const std::vector<double>& y) {
    const auto n = static_cast<double>(x.size());
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        sx += x[i];
        sy += y[i];
        sxx += x[i] * x[i];
        sxy += x[i] * y[i];
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

std::optional<PriceOfHalving> price_of(const Study& study, const StudyFamily& family, std::size_t measure) {
    std::vector<double> errors, seconds, log_error, log_seconds;
    for (std::size_t i : family.runs)
        if (const double e = study.runs[i].error[measure]; e > 0) {
            errors.push_back(e);
            seconds.push_back(study.runs[i].solver_seconds);
            log_error.push_back(std::log2(e));
            log_seconds.push_back(std::log2(seconds.back()));
        }
    if (errors.size() < least_runs || !(errors.front() >= least_fall * errors.back())) return std::nullopt;
    const double exponent = slope(log_error, log_seconds);
    return PriceOfHalving{family.like,   family.name,     std::exp2(-exponent), errors.front(),
                          errors.back(), seconds.front(), seconds.back()};
}

/// 0.2, 0.1, 0.05, 0.02, ... down to the least error that is there.
std::vector<double> error_levels(double least) {
    std::vector<double> levels;
    for (double decade = 0.1; decade > 0.1 * least && levels.size() < 30; decade /= 10)
        for (double step : {2.0, 1.0, 0.5})
            if (step * decade >= least) levels.push_back(step * decade);
    return levels;
}

void keep_cheapest(const Study& study, std::size_t i, std::optional<std::size_t>& best) {
    if (!best || study.runs[i].solver_seconds < study.runs[*best].solver_seconds) best = i;
}

/// Levels, then degrees by basis, then equal cells.
bool comes_before(const StudyFamily& a, const StudyFamily& b) {
    const auto rank = [](const StudySetting& s) { return std::tuple(s.kind, s.threads, s.basis != "web", s.degree); };
    return rank(a.like) < rank(b.like);
}

}  // namespace

std::string family_name(const StudySetting& s) {
    if (s.kind == Kind::level)
        return "levels" + (s.threads > 1 ? ", " + std::to_string(s.threads) + " threads" : std::string());
    if (s.kind == Kind::uniform) return "equal cells";
    return "degree " + std::to_string(s.degree) + (s.basis == "web" ? "" : ", " + s.basis);
}

std::vector<StudyFamily> families_of(const Study& study) {
    std::vector<StudyFamily> families;
    for (std::size_t i = 0; i < study.runs.size(); ++i) {
        const StudyRun& run = study.runs[i];
        if (run.status != StudyRun::Status::ok) continue;
        auto family =
            std::find_if(families.begin(), families.end(), [&](const StudyFamily& f) { return is_like(f.like, run.setting); });
        if (family == families.end()) family = families.insert(family, {run.setting, family_name(run.setting), {}});
        family->runs.push_back(i);
    }
    std::stable_sort(families.begin(), families.end(), comes_before);
    for (StudyFamily& family : families)
        std::stable_sort(family.runs.begin(), family.runs.end(),
                         [&](std::size_t a, std::size_t b) { return study.runs[a].unknowns < study.runs[b].unknowns; });
    return families;
}

std::vector<double> kept_errors(const Study& study, std::size_t measure) {
    std::vector<double> kept(study.runs.size(), std::numeric_limits<double>::quiet_NaN());
    for (const StudyFamily& family : families_of(study)) {
        double largest = 0;
        for (auto i = family.runs.rbegin(); i != family.runs.rend(); ++i) {
            const double error = study.runs[*i].error[measure];
            if (std::isnan(error)) continue;
            largest = std::max(largest, error);
            kept[*i] = largest;
        }
    }
    return kept;
}

std::vector<CheapestSetting> cheapest_settings(const Study& study, std::size_t measure) {
    const std::vector<double> kept = kept_errors(study, measure);
    double least = std::numeric_limits<double>::infinity();
    for (double error : kept)
        if (error > 0) least = std::min(least, error);
    std::vector<CheapestSetting> list;
    if (!std::isfinite(least)) return list;
    for (double error : error_levels(least)) {
        CheapestSetting cheapest{error, {}, {}};
        for (std::size_t i = 0; i < study.runs.size(); ++i)
            if (kept[i] <= error && study.runs[i].setting.threads == 1)
                keep_cheapest(study, i, study.runs[i].setting.kind == Kind::level ? cheapest.level : cheapest.grid);
        list.push_back(cheapest);
    }
    return list;
}

std::vector<PriceOfHalving> prices_of_halving(const Study& study, std::size_t measure) {
    std::vector<PriceOfHalving> prices;
    for (const StudyFamily& family : families_of(study))
        if (const auto price = price_of(study, family, measure)) prices.push_back(*price);
    return prices;
}

std::optional<double> time_exponent(const Study& study, const StudyFamily& family) {
    if (family.runs.size() < least_runs) return std::nullopt;
    std::vector<double> unknowns, seconds;
    for (std::size_t i : family.runs) {
        unknowns.push_back(std::log2(study.runs[i].unknowns));
        seconds.push_back(std::log2(study.runs[i].solver_seconds));
    }
    return slope(unknowns, seconds);
}

std::optional<std::size_t> main_measure(const Study& study) {
    for (std::size_t k = 0; k < study.measures.size(); ++k)
        if (!study.measures[k].held) return k;
    return std::nullopt;
}

}  // namespace abut
