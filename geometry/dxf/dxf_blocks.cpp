// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/dxf/dxf_blocks.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "geometry/brep/message_text.hpp"
#include "geometry/dxf/doubtful_layers.hpp"
#include "geometry/dxf/drafting_layers.hpp"
#include "geometry/dxf/dxf_entities.hpp"
#include "geometry/dxf/dxf_hatches.hpp"
#include "geometry/dxf/dxf_ignored.hpp"
#include "geometry/dxf/dxf_inserts.hpp"
#include "geometry/dxf/dxf_lists.hpp"
#include "geometry/dxf/dxf_names.hpp"
#include "geometry/dxf/dxf_numbers.hpp"
#include "geometry/sketch/sketch_names.hpp"

namespace abut::geometry::dxf {

namespace {

constexpr const char* mend_in_cad = "mend or delete it in CAD";

std::string most_entities_text() {
    return std::to_string(most_entities);
}

/// An instance of a block; the model space is one of no block.
struct Instance {
    const Block* block = nullptr;
    std::size_t number = 0;  ///< among those of its block
    std::string path;        ///< names of the blocks around it and its own: "CLAMP/PIN"
    Look look;               ///< of the insert
    Placement placement;     ///< into the model space
    double height = 0;       ///< of its plane above that
    double n_copies = 1;     ///< that the arrays around it make of it; whole, but larger than any int
    const Instance* around = nullptr;
    mutable int insertion = -1;  ///< among the drawing's, once something of it is drawn
};

/// An outline of a block, read once for all instances.
struct NamedOutline {
    Outline outline;
    std::string name;
    Heights heights;
};

class ModelSpace {
public:
    ModelSpace(const Structure& structure, const LayerFilter& layers, Drawing& drawing)
        : structure_(structure),
          layers_(layers),
          drawing_(drawing),
          ignored_(drawing.ignored),
          names_(structure.groups.is_binary) {}

    void add() {
        takes_paper_space_ = !has_model_space();
        for (const std::span<const Record> records : structure_.entities) add_records(records, {});
        name_instances();
        if (takes_paper_space_ && !drawing_.entities.empty())
            drawing_.warnings.push_back({"the model space is empty: paper space is read in its place",
                                         point(drawing_.entities.front().curve, 0), drawing_.entities.front().name,
                                         drawing_.entities.front().line, "draw parts in the model space"});
        if (drawing_.entities.empty() && layers_.only.empty()) take_named_layers();
        if (drawing_.entities.empty()) take_hatches();
        leave_doubtful_layers();
        left_out_.tell(drawing_.warnings);
        for (const Doubt& doubt : {tilted_, wide_})
            if (doubt.n > 0) drawing_.warnings.push_back(doubt.first);
        tell_heights();
    }

private:
    /// Is any line, arc or insertion of a block drawn there?
    bool has_model_space() const {
        for (const std::span<const Record> records : structure_.entities)
            for (const Record& record : records)
                if (!is_in_paper_space(record) && (is_curve(record) || record.type == "HATCH")) return true;
        return false;
    }

    /// Layers whose names are those of drafting, where nothing is drawn on others.
    void take_named_layers() {
        LayerFilter all;
        all.only = {"*"};
        all.ignore = layers_.ignore;
        Drawing again;
        again.file = drawing_.file;
        ModelSpace(structure_, all, again).add();
        if (again.entities.empty()) return;
        again.format = drawing_.format;
        again.unit = drawing_.unit;
        again.warnings.insert(again.warnings.begin(), drawing_.warnings.begin(), drawing_.warnings.end());
        again.warnings.push_back({"all that is drawn is on layers, or in line types, of drafting, the first on layer " +
                                      again.entities.front().layer + ": it is read nevertheless",
                                  point(again.entities.front().curve, 0), again.entities.front().name,
                                  again.entities.front().line, "draw outlines on a layer of their own"});
        left_out_ = {};
        drawing_ = std::move(again);
    }

    /// Boundaries of hatches as outlines, where there is nothing else.
    void take_hatches() {
        for (const Hatch& hatch : drawing_.hatches) {
            int k = 0;
            for (const std::vector<Curve>& loop : hatch.loops)
                for (const Curve& curve : loop)
                    drawing_.entities.push_back(
                        {curve, "HATCH", hatch.look.layer, hatch.name + "." + std::to_string(k++), hatch.line, {}, {}, 7});
        }
        if (!drawing_.entities.empty())
            drawing_.warnings.push_back({"the file holds hatches only: their boundaries are taken as outlines",
                                         point(drawing_.entities.front().curve, 0), drawing_.hatches.front().name,
                                         drawing_.hatches.front().line, "export the outlines, too"});
    }

    /// Leaves out the lines of layers whose names may mean a part or lines of drafting, where they hold the latter.
    void leave_doubtful_layers() {
        const std::set<std::string> layers = layers_of_loose_lines(drawing_.entities);
        std::erase_if(drawing_.entities, [&](const SketchEntity& entity) {
            if (!layers.contains(entity.layer) || is_asked(entity.layer)) return false;
            note_layer(entity.layer);
            Record record;
            record.type = entity.kind;
            record.line = entity.line;
            Look look;
            look.layer = entity.layer;
            left_out_.add(record, entity.name, look,
                          "layer of " + drafting_layer(entity.layer)->kind + " by its name, and no two of its lines are joined",
                          point(entity.curve, 0.5));
            return true;
        });
    }

    bool is_asked(const std::string& layer) const {
        return std::any_of(layers_.only.begin(), layers_.only.end(),
                           [&](const std::string& pattern) { return matches_glob(layer, pattern); });
    }

    void add_records(std::span<const Record> records, const Instance& in) {
        for (std::size_t i = 0; i < records.size() && !is_too_large_; ++i) {
            if (records[i].type == "VERTEX" || records[i].type == "SEQEND") continue;
            check_size(records[i]);
            add_record(records, i, in);
        }
    }

    void add_record(std::span<const Record> records, std::size_t i, const Instance& in) {
        const Record& record = records[i];
        const Look look = look_of(record, in.look, structure_);
        const bool is_counted = in.block == nullptr && !is_subentity(record) && is_in_paper_space(record) == takes_paper_space_;
        EntityCount* count = is_counted ? &drawing_.counts[record.type] : nullptr;
        if (count) ++count->read;
        std::string why = why_ignored(record, look, layers_);
        const bool is_elsewhere = is_in_paper_space(record) != takes_paper_space_ && in.block == nullptr;
        if (is_elsewhere) why = takes_paper_space_ ? "in the model space" : "in paper space";
        if (!is_elsewhere && !look.frozen && !look.off) note(record, look, in);
        if (!why.empty()) {
            ignored_.add(record, look, in.path, why);
            const bool is_asked_for = why == "layer is to be ignored" || why == "layer is not asked for";
            if (!is_elsewhere && is_curve(record) && why.starts_with("layer of ")) note_layer(look.layer);
            if (!is_elsewhere && is_curve(record) && !is_subentity(record) && !is_asked_for)
                left_out_.add(record, names_.of(record), look, why, in.placement(first_point(record)));
        }
        const bool is_used =
            why.empty() && (record.type == "INSERT" ? add_insert(record, look, in) : add_outline(records, i, look, in));
        if (count) ++(is_used ? count->used : count->ignored);
    }

    // ---- what tells the sheet from the parts ----

    /// Texts, tips of arrows and hatches are no outlines, but say something about these.
    void note(const Record& record, const Look& look, const Instance& in) {
        constexpr std::array texts{"TEXT", "MTEXT", "ATTRIB", "ATTDEF"};
        if (std::find(texts.begin(), texts.end(), record.type) != texts.end()) {
            drawing_.texts.push_back(
                {record.text(1), in.placement(first_point(record)), record.number(40, 0) * in.placement.y_axis.norm()});
        } else if (record.type == "SOLID" || record.type == "TRACE") {
            for (const int code : {10, 11, 12})
                if (record.find(code))
                    drawing_.arrows.push_back(in.placement(Vec2(record.number(code, 0), record.number(code + 10, 0))));
        } else if (record.type == "HATCH") {
            add_hatch(record, look, in);
        }
        if (tilt(record) > 0 && tilt(record) <= most_tilt) note_tilt(record, in);
    }

    void note_layer(const std::string& layer) {
        std::vector<std::string>& known = drawing_.drafting_layers;
        if (std::find(known.begin(), known.end(), layer) == known.end()) known.push_back(layer);
    }

    void add_hatch(const Record& record, const Look& look, const Instance& in) {
        Hatch hatch = read_hatch(record, look);
        if (hatch.loops.empty()) return;
        if (in.block) place_hatch(hatch, in.placement);
        drawing_.hatches.push_back(std::move(hatch));
    }

    /// What is said once of all entities that it is true of.
    struct Doubt {
        SketchProblem first;
        int n = 0;
    };
    static void count(const Record& record, const std::string& name, const Vec2& at, const std::string& what,
                      const std::string& hint, Doubt& doubt) {
        if (doubt.n++ == 0) doubt.first = {"", at, name, record.line, hint};
        doubt.first.what = (doubt.n == 1 ? record.type + " is " : std::to_string(doubt.n) + " entities are ") + what;
    }

    void note_tilt(const Record& record, const Instance& in) {
        count(record, record.text(5).empty() ? "" : "h" + upper_case(record.text(5)), in.placement(first_point(record)),
              "tilted out of the drawing's plane by less than " + number_text(most_tilt) + " degrees, and projected onto it",
              "set its plane to the drawing's in CAD", tilted_);
    }

    /// Lines that are drawn wide to be seen are lines; filled discs and bars are drawn so, too.
    void note_width(const Record& record, const NamedOutline& named, const Instance& in) {
        constexpr double filling = 0.05;  // of the outline's size
        if (record.type != "LWPOLYLINE" && record.type != "POLYLINE") return;
        const double width = std::max({record.number(43, 0), record.number(40, 0), record.number(41, 0)});
        if (width <= 0) return;
        Box2 box;
        for (const Curve& curve : named.outline.curves) box.extend(bounding_box(curve));
        if (!box.empty() && width > filling * box.diagonal())
            count(record, named.name, in.placement(first_point(record)),
                  "drawn wide, as a filled area: the middle of the line is read as the outline",
                  "draw the outline of what is filled", wide_);
    }

    void note_heights(const Record& record, const NamedOutline& named, const Instance& in) {
        const Heights own{named.heights.least + in.height, named.heights.largest + in.height};
        if (own.largest > heights_.largest)
            highest_ = {"", in.placement(first_point(record)), named.name, record.line,
                        "draw what belongs together in one plane"};
        heights_ = {std::min(own.least, heights_.least), std::max(own.largest, heights_.largest)};
    }

    /// Heights that differ by less than a small part of the drawing are those of careless clicks.
    void tell_heights() {
        constexpr double flat = 1e-3;
        if (!(heights_.largest > heights_.least)) return;
        Box2 box;
        for (const SketchEntity& entity : drawing_.entities) box.extend(bounding_box(entity.curve));
        if (box.empty() || heights_.largest - heights_.least <= flat * box.diagonal()) return;
        highest_.what = "curves are drawn at heights (z) from " + number_text(heights_.least) + " to " +
                        number_text(heights_.largest) + ": all are read as in one plane, whatever lies above the other";
        drawing_.warnings.push_back(highest_);
    }

    // ---- outlines ----

    bool add_outline(std::span<const Record> records, std::size_t i, const Look& look, const Instance& in) {
        if (in.block) {
            const auto [found, is_new] = block_outlines_.try_emplace(&records[i]);
            if (is_new) found->second = read(records, i);
            return add_curves(records[i], found->second, look, in);
        }
        return add_curves(records[i], read(records, i), look, in);
    }

    NamedOutline read(std::span<const Record> records, std::size_t i) {
        NamedOutline named{read_outline(records, i), names_.of(records[i]), heights_of(records, i)};
        if (is_seen_from_below(records[i]))
            for (Curve& curve : named.outline.curves) curve = placed(curve, seen_from_below());
        return named;
    }

    bool add_curves(const Record& record, const NamedOutline& named, const Look& look, const Instance& in) {
        if (!named.outline.wrong.empty()) {
            report(record, named.name, record.type + " cannot be read: " + named.outline.wrong, in);
            return false;
        }
        note_heights(record, named, in);
        note_width(record, named, in);
        const std::vector<Curve>& curves = named.outline.curves;
        for (std::size_t k = 0; k < curves.size() && !is_too_large_; ++k) {
            check_size(record);
            const std::string suffix = named.outline.is_in_pieces ? "." + std::to_string(k) : "";
            drawing_.entities.push_back({in.block ? placed(curves[k], in.placement) : curves[k],
                                         record.type,
                                         look.layer,
                                         named.name + suffix,
                                         record.line,
                                         in.path,
                                         {},
                                         look.color,
                                         insertion_of(in)});
            if (in.block) instance_of_.push_back({drawing_.entities.size() - 1, in.block, in.number});
        }
        return true;
    }

    // ---- blocks ----

    bool add_insert(const Record& record, const Look& look, const Instance& in) {
        const std::string name = record.text(2);
        const auto found = structure_.blocks.find(upper_case(name));
        if (found == structure_.blocks.end())
            return refuse_insert(record, "INSERT names block '" + name.substr(0, 40) + "', which the file does not hold", in);
        const Block& block = found->second;
        if (block.is_external) {
            ignored_.add(record, look, in.path, "block " + block.name + " is in another file: bind it in CAD");
            return false;
        }
        if (std::find(open_blocks_.begin(), open_blocks_.end(), &block) != open_blocks_.end())
            return refuse_insert(record, "block " + block.name + " contains itself", in);
        if (open_blocks_.size() >= deepest_nesting)
            return refuse_insert(record, "blocks are nested deeper than " + std::to_string(deepest_nesting) + " levels", in);
        return add_instances(record, block, look, in);
    }

    bool add_instances(const Record& record, const Block& block, const Look& look, const Instance& in) {
        Numbers numbers(block.head);
        const Vec2 base(numbers(10, 0), numbers(20, 0));
        Insert insert = read_insert(record, base);
        if (insert.wrong.empty()) insert.wrong = numbers.wrong();
        if (!insert.wrong.empty()) return refuse_insert(record, "INSERT cannot be read: " + insert.wrong, in);
        draw_once_in_one_place(record, insert, in);
        const double n_copies = in.n_copies * insert.n_rows * insert.n_columns;
        if (n_copies > static_cast<double>(most_entities))
            return refuse_insert(record, "INSERT repeats block " + block.name + " more than " + most_entities_text() + " times",
                                 in);
        open_blocks_.push_back(&block);
        bool is_good = true;
        for (int row = 0; row < insert.n_rows && is_good; ++row)
            for (int column = 0; column < insert.n_columns && is_good; ++column)
                is_good = add_instance(record, block, placement_of(insert, row, column), look, in, n_copies);
        open_blocks_.pop_back();
        return is_good;
    }

    /// Rows (columns) without a distance between them lie on each other: one says it all. Files that leave the distance out,
    /// and damaged ones, ask for thousands.
    void draw_once_in_one_place(const Record& record, Insert& insert, const Instance& in) {
        const double n_drawn = 1.0 * insert.n_rows * insert.n_columns;
        if (insert.row == Vec2(0, 0)) insert.n_rows = 1;
        if (insert.column == Vec2(0, 0)) insert.n_columns = 1;
        if (1.0 * insert.n_rows * insert.n_columns == n_drawn || !drawn_once_.insert(&record).second) return;
        drawing_.repairs.push_back({"rows or columns of an INSERT of block " + insert.block.substr(0, 40) +
                                        " that lie on each other drawn once (line " + std::to_string(record.line) + ")",
                                    in.placement(first_point(record)), 0});
    }

    bool add_instance(const Record& record, const Block& block, const Placement& placement, const Look& look,
                      const Instance& in, double n_copies) {
        check_size(record);
        if (is_too_large_) return false;
        Instance instance{&block,
                          n_instances_[&block]++,
                          in.path.empty() ? block.name : in.path + "/" + block.name,
                          look,
                          composed(in.placement, placement),
                          in.height + record.number(30, 0) - block.head.number(30, 0),
                          n_copies,
                          &in};
        if (const std::string fault = placement_fault(instance.placement, largest_coordinate); !fault.empty())
            return refuse_insert(record, "INSERT cannot be read: " + fault, in);
        add_records(block.entities, instance);
        return true;
    }

    bool refuse_insert(const Record& record, const std::string& what, const Instance& in) {
        if (!reported_.contains(&record)) report(record, names_.of(record), what, in);
        return false;
    }

    int insertion_of(const Instance& in) {
        if (!in.block || in.insertion >= 0) return in.insertion;
        const int around = insertion_of(*in.around);
        in.insertion = static_cast<int>(drawing_.insertions.size());
        drawing_.insertions.push_back({in.block->name, around});
        return in.insertion;
    }

    void name_instances() {
        for (const InstanceOf& of : instance_of_)
            if (n_instances_.at(of.block) > 1)
                drawing_.entities[of.entity].instance = of.block->name + "#" + std::to_string(of.number);
    }

    // ---- problems ----

    /// Each record is reported once, however often its block is inserted.
    void report(const Record& record, const std::string& name, const std::string& what, const Instance& in) {
        if (!reported_.insert(&record).second) return;
        drawing_.problems.push_back({what, in.placement(first_point(record)), name, record.line, mend_in_cad});
    }

    /// Counts both what is looked at and what is drawn: blocks of nothing but blocks can blow up, too.
    void check_size(const Record& record) {
        if (is_too_large_ || (++n_steps_ <= 2 * most_entities && drawing_.entities.size() < most_entities)) return;
        is_too_large_ = true;
        drawing_.problems.push_back(
            {"the drawing holds more than " + most_entities_text() + " lines and arcs with its blocks inserted",
             first_point(record), "", record.line, "divide it, or delete what is no outline"});
    }

    struct InstanceOf {
        std::size_t entity;
        const Block* block;
        std::size_t number;
    };

    const Structure& structure_;
    const LayerFilter& layers_;
    Drawing& drawing_;
    LeftOut left_out_;
    Doubt tilted_, wide_;
    Heights heights_{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    SketchProblem highest_;
    bool takes_paper_space_ = false;
    IgnoredList ignored_;
    Names names_;
    std::vector<const Block*> open_blocks_;
    std::unordered_map<const Block*, std::size_t> n_instances_;
    std::unordered_map<const Record*, NamedOutline> block_outlines_;
    std::unordered_set<const Record*> reported_, drawn_once_;
    std::vector<InstanceOf> instance_of_;
    std::size_t n_steps_ = 0;
    bool is_too_large_ = false;
};

}  // namespace

void add_model_space(const Structure& structure, const LayerFilter& layers, Drawing& drawing) {
    ModelSpace(structure, layers, drawing).add();
}

}  // namespace abut::geometry::dxf
