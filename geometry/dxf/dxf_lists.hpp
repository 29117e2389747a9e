// SPDX-License-Identifier: GPL-3.0-or-later
// What was left out of a drawing, summed up.
#pragma once
#include <string>
#include <unordered_map>
#include <vector>

#include "geometry/dxf/dxf_ignored.hpp"

namespace abut::geometry::dxf {

/// What is listed as ignored, summed up by kind and reason in the order of first appearance.
class IgnoredList {
public:
    explicit IgnoredList(std::vector<Ignored>& list) : list_(list) {}

    void add(const Record& record, const Look& look, const std::string& path, const std::string& why) {
        std::string what = record.type;
        if (why.starts_with("layer is")) what += " on layer " + look.layer;
        if (!path.empty()) what += " in block " + path;
        const auto [found, is_new] = places_.emplace(what + "\n" + why, list_.size());
        if (is_new) list_.push_back({what, 0, why});
        ++list_[found->second].count;
    }

private:
    std::vector<Ignored>& list_;
    std::unordered_map<std::string, std::size_t> places_;
};

/// Curves that were left out, summed up by layer and reason in the order of first appearance, as warnings.
class LeftOut {
public:
    void add(const Record& record, const std::string& name, const Look& look, const std::string& why, const Vec2& where) {
        const auto [found, is_new] = places_.emplace(look.layer + "\n" + why, list_.size());
        if (is_new) list_.push_back({record.type, look.layer, why, name, record.line, where, 0});
        ++list_[found->second].count;
    }

    void tell(std::vector<SketchProblem>& warnings) const {
        for (const Sum& sum : list_)
            warnings.push_back({(sum.count == 1 ? sum.type + " " + sum.name
                                                : std::to_string(sum.count) + " lines, arcs or other curves, first " +
                                                      sum.type + " " + sum.name + ",") +
                                    " on layer " + sum.layer + " left out: " + sum.why,
                                sum.at, sum.name, sum.line, "--only-layer names layers to be read whatever they are called"});
    }

private:
    struct Sum {
        std::string type, layer, why, name;
        int line;
        Vec2 at;
        int count;
    };
    std::vector<Sum> list_;
    std::unordered_map<std::string, std::size_t> places_;
};

}  // namespace abut::geometry::dxf
