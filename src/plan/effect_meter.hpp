// SPDX-License-Identifier: GPL-3.0-or-later
// What the code of each effect cost in a run: a stopwatch and counters, by the effect's name in the plan.
#pragma once
#include <chrono>
#include <map>
#include <string>

namespace abut {

/// What an effect's code took. Where parts are made side by side their seconds add up.
struct EffectUse {
    double seconds = 0;
    long items = 0;  ///< points, rows or unknowns that it worked on
};

/// The uses of effects by name; an effect whose code was not entered has no entry.
using EffectUses = std::map<std::string, EffectUse>;

inline void add_uses(EffectUses& to, const EffectUses& from) {
    for (const auto& [name, use] : from) {
        EffectUse& sum = to[name];
        sum.seconds += use.seconds;
        sum.items += use.items;
    }
}

/// One call of an effect's code, timed until the end of the block.
class MeteredCall {
public:
    MeteredCall(EffectUses& uses, const std::string& effect) : use_(uses[effect]) {}
    MeteredCall(const MeteredCall&) = delete;
    MeteredCall& operator=(const MeteredCall&) = delete;
    ~MeteredCall() { use_.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }
    void count(std::size_t items) { use_.items += static_cast<long>(items); }

private:
    EffectUse& use_;  // references into a map stay valid
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace abut
