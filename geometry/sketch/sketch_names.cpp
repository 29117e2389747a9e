// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_names.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace abut::geometry {

bool matches_glob(std::string_view name, std::string_view pattern) {
    const auto fold = [](std::string_view text) {
        std::string folded;
        for (const char c : text) folded += static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
        return folded;
    };
    const std::string n = fold(name), p = fold(pattern);
    std::size_t i = 0, k = 0, star = std::string::npos, mark = 0;
    while (i < n.size()) {
        if (k < p.size() && p[k] == '*') {
            star = k++;
            mark = i;
        } else if (k < p.size() && (p[k] == '?' || p[k] == n[i])) {
            ++i;
            ++k;
        } else if (star != std::string::npos) {
            k = star + 1;
            i = ++mark;
        } else {
            return false;
        }
    }
    while (k < p.size() && p[k] == '*') ++k;
    return k == p.size();
}

std::string block_hint(const SketchPiece& entity) {
    if (entity.insertion < 0) return {};
    const std::string block = entity.block.substr(entity.block.rfind('/') + 1);
    return ", or take the outline around block " + block + " for one part: --block-outline " + block +
           " (in a scene \"block_outline\": [\"" + block + "\"])";
}

std::string most_frequent_layer(const std::vector<const SketchPiece*>& outline) {
    std::map<std::string, int> n_edges;
    for (const SketchPiece* piece : outline) ++n_edges[piece->layer];
    const SketchPiece* best = outline.front();
    for (const SketchPiece* piece : outline)
        if (n_edges[piece->layer] > n_edges[best->layer]) best = piece;
    return best->layer;
}

std::string part_name(const std::vector<const SketchPiece*>& outline, const std::string& group) {
    const std::string name = group.empty() ? most_frequent_layer(outline) : group;
    const std::string& instance = outline.front()->instance;
    return instance.empty() || instance == name ? name : instance + ":" + name;
}

void name_edges(Part& part, const std::vector<const SketchPiece*>& entity) {
    if (part.edges.empty()) return;
    const std::string& own_instance = entity.front()->instance;
    std::map<std::string, std::vector<std::size_t>> by_source;
    for (std::size_t i = 0; i < part.edges.size(); ++i) {
        Edge& edge = part.edges[i];
        const std::string& instance = entity[i]->instance;
        if (!instance.empty() && instance != own_instance) edge.source = instance + ":" + edge.source;
        edge.name = edge.source;
        by_source[edge.source].push_back(i);
    }
    for (auto& [source, edges] : by_source) {
        if (edges.size() == 1) continue;
        std::stable_sort(edges.begin(), edges.end(),
                         [&](std::size_t a, std::size_t b) { return part.edges[a].source_begin < part.edges[b].source_begin; });
        for (std::size_t k = 0; k < edges.size(); ++k) part.edges[edges[k]].name = source + "#" + std::to_string(k);
    }
}

void number_parts(std::vector<Part>& parts) {
    std::map<std::string, int> n_of, next;
    for (const Part& part : parts) ++n_of[part.name];
    std::set<std::string> taken;
    for (const auto& [name, n] : n_of)
        if (n == 1) taken.insert(name);
    for (Part& part : parts) {
        const std::string name = part.name;
        if (n_of[name] == 1) continue;
        do part.name = name + "#" + std::to_string(next[name]++);
        while (!taken.insert(part.name).second);  // a layer may itself be called PLATE#0
    }
}

}  // namespace abut::geometry
