// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_names.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

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

namespace {

/// Keeps, of the layers, those that most of the first n pieces are drawn on, to a share of the most.
void keep_most_frequent(const std::vector<const SketchPiece*>& pieces, std::size_t n, double share,
                        std::vector<std::string>& layers) {
    std::map<std::string, int> n_edges;
    for (std::size_t k = 0; k < n; ++k) {
        ++n_edges[pieces[k]->layer];
        for (const std::string& layer : pieces[k]->also_on) ++n_edges[layer];
    }
    int most = 0;
    for (const std::string& layer : layers) most = std::max(most, n_edges[layer]);
    std::erase_if(layers, [&](const std::string& layer) { return n_edges[layer] < share * most; });
}

}  // namespace

std::vector<std::string> layers_of_parts(const std::vector<std::vector<const SketchPiece*>>& entities,
                                         const std::vector<std::size_t>& n_outer) {
    std::vector<std::vector<std::string>> possible(entities.size());
    std::set<std::string> taken;
    for (std::size_t k = 0; k < entities.size(); ++k) {
        for (std::size_t i = 0; i < n_outer[k]; ++i) {
            const SketchPiece& piece = *entities[k][i];
            possible[k].push_back(piece.layer);
            possible[k].insert(possible[k].end(), piece.also_on.begin(), piece.also_on.end());
        }
        const bool is_shared = std::any_of(entities[k].begin(), entities[k].begin() + static_cast<std::ptrdiff_t>(n_outer[k]),
                                           [](const SketchPiece* piece) { return !piece->also_on.empty(); });
        constexpr double nearly_all = 0.7;  // of what was drawn twice pieces that others share may be missing
        keep_most_frequent(entities[k], n_outer[k], is_shared ? nearly_all : 1, possible[k]);
        if (is_shared)
            keep_most_frequent(entities[k], entities[k].size(), nearly_all, possible[k]);
        else
            possible[k].resize(1);
        std::set<std::string> seen;
        std::erase_if(possible[k], [&](const std::string& layer) { return !seen.insert(layer).second; });
        if (possible[k].size() == 1) taken.insert(possible[k].front());
    }
    std::map<std::string, int> n_parts;
    for (const std::vector<std::string>& own : possible)
        for (const std::string& layer : own) ++n_parts[layer];
    const auto is_better = [&](const std::string& a, const std::string& b) {
        return std::pair(taken.contains(a), n_parts[a]) < std::pair(taken.contains(b), n_parts[b]);
    };
    std::vector<std::string> layers;
    for (const std::vector<std::string>& own : possible) layers.push_back(*std::min_element(own.begin(), own.end(), is_better));
    return layers;
}

std::string part_name(const SketchPiece& first, const std::string& group_or_layer) {
    return first.instance.empty() || first.instance == group_or_layer ? group_or_layer : first.instance + ":" + group_or_layer;
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
