// SPDX-License-Identifier: GPL-3.0-or-later
// abut sweep: a scene at all combinations of values of its parameters, as a batch; what comes out as curves over the first of
// them.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "src/batch/batch_file.hpp"
#include "src/batch/batch_source.hpp"

namespace abut {

/// A parameter of the scene and its values, ascending as given.
struct SweptParameter {
    std::string name;
    std::vector<double> values;
};

/// The most jobs of a sweep; more are a slip of the colons.
inline constexpr std::size_t most_sweep_jobs = 100'000;

/// Reads "F=2000:20000:10" (ten values from 2000 to 20000, evenly spaced) or "clearance=0.01,0.02,0.05". Throws InputError.
SweptParameter parse_swept(const std::string& text);

/// All combinations, the first parameter's values in turn for each of the others'; names are the places of the values, from 1:
/// "003_01". Throws InputError where a parameter is there twice or the jobs are too many.
BatchSource sweep_jobs(const std::vector<SweptParameter>& parameters);

/// A number of the answer and its estimated error, absolute; unset: not known.
struct SweepValue {
    double value = 0;
    std::optional<double> error{};
};

/// A quantity that is followed: "bracket - pin", "max pressure", "MPa".
struct SweepQuantity {
    std::string of, quantity, unit;
};

/// One job of a sweep.
struct SweepPoint {
    std::string job, status, message;
    bool has_report = false;
    std::map<std::string, double> parameters;
    std::vector<std::optional<SweepValue>> values;  ///< by quantity; unset where the job has no such answer
};

struct Sweep {
    std::string scene, title;
    std::vector<SweptParameter> parameters;
    std::vector<SweepQuantity> quantities;  ///< of contacts, then of parts, as they first appear
    std::vector<SweepPoint> points;         ///< in the order of sweep_jobs
};

/// Reads what is finished of a sweep's jobs below OUT/jobs: largest pressure, force and length of every contact, largest stress
/// of every part. batch: of OUT; jobs that are there from another one are missing. Jobs without result.json have no values.
/// Contacts of two jobs are the same where their edges are.
Sweep read_sweep(const BatchFile& batch, const std::vector<SweptParameter>& parameters, const std::string& out);

/// The text of sweep.csv: a row each job, a column each parameter and quantity with one for its error.
std::string sweep_csv(const Sweep& sweep);
/// The text of sweep.html: a curve over the first parameter for each quantity, a line for each combination of the others.
std::string sweep_html(const Sweep& sweep);

}  // namespace abut
