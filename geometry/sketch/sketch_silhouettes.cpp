// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sketch/sketch_silhouettes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "geometry/sketch/sketch_names.hpp"
#include "geometry/sketch/sketch_outlines.hpp"
#include "geometry/sketch/sketch_region.hpp"
#include "src/base/index.hpp"

namespace abut::geometry {

namespace {

/// What became of all insertions of one block.
struct BlockCount {
    int n_insertions = 0, n_outlines = 0;
    std::size_t n_inside = 0, n_outside = 0;
    Vec2 at{0, 0}, outside_at{0, 0};
    std::string entity;
    int line = 0;
};

struct SilhouetteSearch {
    const Drawing& drawing;
    const SketchOptions& options;
    Precision precision;
    Silhouettes found{};
    std::map<std::string, BlockCount> counts{};  ///< by block

    bool is_asked(const std::string& block) const {
        return std::any_of(options.block_outline.begin(), options.block_outline.end(),
                           [&](const std::string& pattern) { return matches_glob(block, pattern); });
    }

    /// The outermost insertion of a block that is asked for around the entity; -1: none.
    int asked_insertion(const SketchEntity& entity) const {
        int outermost = -1;
        for (int k = entity.insertion; k >= 0; k = drawing.insertions[at(k)].around)
            if (is_asked(drawing.insertions[at(k)].block)) outermost = k;
        return outermost;
    }

    std::string path_to(int insertion) const {
        std::string path = drawing.insertions[at(insertion)].block;
        for (int k = drawing.insertions[at(insertion)].around; k >= 0; k = drawing.insertions[at(k)].around)
            path = drawing.insertions[at(k)].block + "/" + path;
        return path;
    }

    /// "PIN#1" where the block is inserted more than once, as entities are told apart.
    std::string instance_of(int insertion) const {
        const std::string& block = drawing.insertions[at(insertion)].block;
        const auto is_same = [&](const Insertion& other) { return other.block == block; };
        const auto begin = drawing.insertions.begin();
        if (std::count_if(begin, drawing.insertions.end(), is_same) == 1) return {};
        return block + "#" + std::to_string(std::count_if(begin, begin + insertion, is_same));
    }

    // ---- one insertion ----

    static bool lies_in(const std::vector<Region>& outlines, const Vec2& p) {
        return std::any_of(outlines.begin(), outlines.end(),
                           [&](const Region& outline) { return contains(finder_of(outline).pieces, p); });
    }

    /// Outlines that lie in no other; none crosses another, or shares a line with it.
    static std::vector<Region> outer_outlines(const Outlines& outlines) {
        std::vector<Region> all, outer;
        for (const EntityChain& chain : outlines.closed) all.push_back(region_of(outlines.entities, chain));
        for (const DividedOutline& divided : outlines.divided) all.push_back(region_of(outlines.entities, divided.contour));
        std::stable_sort(all.begin(), all.end(), [](const Region& a, const Region& b) { return a.area > b.area; });
        for (Region& region : all)
            if (!lies_in(outer, point(region.outline.edges.front().curve, 0.5))) outer.push_back(std::move(region));
        return outer;
    }

    void add_outlines(const std::vector<Region>& outer, const Outlines& outlines, int insertion, std::set<int>& used) {
        std::vector<const SketchPiece*> pieces;
        for (const Region& region : outer)
            for (const int e : region.entity) pieces.push_back(&outlines.entities[at(e)]);
        const std::string layer = most_frequent_layer(pieces);
        for (const SketchPiece* piece : pieces) {
            SketchEntity entity = static_cast<const SketchEntity&>(*piece);
            entity.layer = layer;
            entity.color = pieces.front()->color;
            entity.block = path_to(insertion);
            entity.instance = instance_of(insertion);
            entity.insertion = insertion;
            found.entities.push_back(std::move(entity));
            used.insert(piece->of.begin(), piece->of.end());
        }
    }

    void count_outside(const std::vector<Region>& outer, const ClosedOutlines& closed, BlockCount& count) const {
        std::set<int> outside;
        for (const LooseEntities& loose : closed.loose)
            for (const int e : loose.entities) {
                const SketchPiece& piece = closed.outlines.entities[at(e)];
                const Vec2 middle = point(piece.curve, 0.5);
                if (lies_in(outer, middle)) continue;
                if (count.n_outside == 0 && outside.empty()) count.outside_at = middle;
                outside.insert(piece.of.begin(), piece.of.end());
            }
        count.n_outside += outside.size();
    }

    void replace(int insertion, const std::vector<SketchEntity>& entities) {
        SketchOptions plain = options;
        plain.recognise_arcs = false;  // done with the parts
        ClosedOutlines closed = close_outlines(mended_lines(entities, plain, precision, Mending::cut_at_crossings), plain);
        found.repairs.insert(found.repairs.end(), closed.repairs.begin(), closed.repairs.end());
        const std::vector<Region> outer = outer_outlines(closed.outlines);
        for (const SketchProblem& problem : closed.problems)
            if (!lies_in(outer, problem.at)) found.problems.push_back(problem);
        const std::string& block = drawing.insertions[at(insertion)].block;
        if (outer.empty()) {
            found.problems.push_back({"block " + block + " holds no closed outline to take for a part",
                                      point(entities.front().curve, 0), entities.front().name, entities.front().line,
                                      "complete its outline in CAD, or do not ask for it"});
            return;
        }
        std::set<int> used;
        add_outlines(outer, closed.outlines, insertion, used);
        BlockCount& count = counts[block];
        if (count.n_insertions++ == 0) {
            count.at = outer.front().box.center();
            count.entity = entities.front().name;
            count.line = entities.front().line;
        }
        count.n_outlines += static_cast<int>(outer.size());
        count.n_inside += entities.size() - used.size();
        count_outside(outer, closed, count);
    }

    // ---- what was done ----

    void tell() {
        for (const auto& [block, count] : counts) {
            found.warnings.push_back(
                {"of block " + block +
                     " the outline around everything is taken for a part: " + std::to_string(count.n_outlines) + " in " +
                     std::to_string(count.n_insertions) + (count.n_insertions == 1 ? " insertion" : " insertions") + "; " +
                     std::to_string(count.n_inside) + " of its lines and arcs are left out",
                 count.at, count.entity, count.line, "without block_outline (--block-outline) they are lines like others"});
            if (count.n_outside > 0)
                found.warnings.push_back(
                    {std::to_string(count.n_outside) + (count.n_outside == 1 ? " line or arc" : " lines and arcs") +
                         " of block " + block + " stand out of its outline, and are cut off there",
                     count.outside_at, count.entity, count.line, "complete the outline in CAD where they belong to it"});
        }
    }

    void refuse_unknown_names() {
        std::set<std::string> known;
        for (const Insertion& insertion : drawing.insertions) known.insert(insertion.block);
        std::string list;
        constexpr std::size_t most = 8;
        std::size_t n = 0;
        for (const std::string& block : known)
            if (n++ < most) list += (n == 1 ? "" : ", ") + block;
        for (const std::string& pattern : options.block_outline)
            if (std::none_of(known.begin(), known.end(), [&](const std::string& b) { return matches_glob(b, pattern); }))
                found.problems.push_back(
                    {"no block that is inserted is called '" + pattern + "'",
                     {0, 0},
                     {},
                     0,
                     known.empty() ? "the drawing inserts no blocks" : "it inserts " + list + (n > most ? ", ..." : "")});
    }

    void run() {
        std::map<int, std::vector<SketchEntity>> asked;  // by insertion
        for (const SketchEntity& entity : drawing.entities) {
            const int insertion = asked_insertion(entity);
            (insertion < 0 ? found.entities : asked[insertion]).push_back(entity);
        }
        for (const auto& [insertion, entities] : asked) replace(insertion, entities);
        refuse_unknown_names();
        tell();
    }
};

}  // namespace

Silhouettes block_silhouettes(const Drawing& drawing, const SketchOptions& options) {
    Box2 box;
    for (const SketchEntity& entity : drawing.entities) box.extend(bounding_box(entity.curve));
    const double size =
        box.empty() ? 0 : std::max(box.diagonal(), std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff()));
    SilhouetteSearch search{drawing, options, precision_of(drawing, size)};
    search.run();
    return std::move(search.found);
}

}  // namespace abut::geometry
