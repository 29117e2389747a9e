// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/packed_field.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>

#include "geometry/brep/monotone.hpp"
#include "src/io/base64.hpp"

namespace abut::report {

namespace {

constexpr int full_scale = 32767;
constexpr double place_step = 1e-7;  ///< of the part's size: less than a pixel where the page shows a thousandth of it
constexpr double drawn_turn = 0.06;  ///< radians between points of an edge, as in drawn fields

using Values = std::array<int, n_components>;
using Bytes = std::vector<std::uint8_t>;

std::array<double, n_components> components(const FieldSample& s) {
    return {s.displacement.x(), s.displacement.y(), s.stress.xx, s.stress.yy, s.stress.xy, s.stress.zz};
}

/// Differences are longer than what they are differences of.
void append_signed(std::int64_t value, Bytes& bytes) {
    auto rest = static_cast<std::uint64_t>(value < 0 ? -2 * value - 1 : 2 * value);
    for (; rest > 127; rest >>= 7) bytes.push_back(static_cast<std::uint8_t>((rest & 127) | 128));
    bytes.push_back(static_cast<std::uint8_t>(rest));
}

using Place = std::array<std::int64_t, 2>;

class Packer {
public:
    explicit Packer(const PackedField& packed) : origin_(packed.origin), step_(packed.step), scale_(packed.scale) {}

    Place place(const Vec2& at) const {
        return {std::llround((at.x() - origin_.x()) / step_), std::llround((at.y() - origin_.y()) / step_)};
    }

    Values values(const FieldSample& s) const {
        Values packed{};
        const auto exact = components(s);
        for (std::size_t i = 0; i < n_components; ++i) {
            const double share = scale_[i] > 0 ? exact[i] / scale_[i] : exact[i];
            packed[i] = std::isfinite(share) ? static_cast<int>(std::lround(full_scale * std::clamp(share, -1.0, 1.0)))
                                             : -full_scale - 1;
        }
        return packed;
    }

    void add(const Vec2& at, const Values& values) {
        const Place here = place(at);
        for (std::size_t i = 0; i < 2; ++i) append_signed(here[i] - place_[i], bytes_);
        for (std::size_t i = 0; i < n_components; ++i) append_signed(values[i] - values_[i], bytes_);
        place_ = here;
        values_ = values;
    }

    std::string text() const { return base64(bytes_); }

private:
    Vec2 origin_;
    double step_;
    std::array<double, n_components> scale_;
    Place place_{};
    Values values_{};
    Bytes bytes_;
};

/// Samples of neighbouring cells at one place with one value: which stands for each. Beside a slot there are two values at one
/// place, which stay apart.
std::vector<int> shared(const PartField& field, const std::vector<Values>& values, const Packer& packer) {
    std::vector<Place> places;
    for (const FieldSample& s : field.samples) places.push_back(packer.place(s.at));
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return places[a] < places[b]; });
    std::vector<int> first(places.size());
    std::vector<std::size_t> known;  // that stand for themselves, at one place
    for (std::size_t i : order) {
        if (!known.empty() && places[known.front()] != places[i]) known.clear();
        const auto same = std::find_if(known.begin(), known.end(), [&](std::size_t k) {
            for (std::size_t c = 0; c < n_components; ++c)
                if (std::abs(values[i][c] - values[k][c]) > 1) return false;
            return true;
        });
        first[i] = static_cast<int>(same == known.end() ? i : *same);
        if (same == known.end()) known.push_back(i);
    }
    return first;
}

/// The largest values of the samples inside and on the boundary; those beyond, which are extrapolated, are cut off there.
std::array<double, n_components> scale_of(const PartField& field, const std::vector<bool>& inside) {
    std::array<double, n_components> scale{};
    const auto take = [&](const FieldSample& s) {
        const auto exact = components(s);
        for (std::size_t c = 0; c < n_components; ++c)
            if (std::isfinite(exact[c])) scale[c] = std::max(scale[c], std::abs(exact[c]));
    };
    for (std::size_t i = 0; i < field.samples.size(); ++i)
        if (inside[i]) take(field.samples[i]);
    for (const auto& loop : field.boundary)
        for (const FieldSample& s : loop) take(s);
    // A part that is thin in its cells: what is beyond its boundary is needed to draw what is inside.
    for (double& s : scale) s *= 2;
    return scale;
}

std::vector<std::vector<FieldSample>> drawn_boundary(const geometry::Part& part) {
    std::vector<std::vector<FieldSample>> loops;
    for (const geometry::Loop& loop : part.loops) {
        loops.emplace_back();
        for (int e : loop.edges) {
            const geometry::Curve& curve = part.edges[static_cast<std::size_t>(e)].curve;
            const int steps = std::max(1, static_cast<int>(std::ceil(turning(curve, 0, 1) / drawn_turn)));
            for (int i = 0; i < steps; ++i)
                loops.back().push_back({geometry::point(curve, static_cast<double>(i) / steps), {0, 0}, {}});
        }
    }
    return loops;
}

void pack_samples(const PartField& field, const std::vector<bool>& inside, PackedField& packed) {
    Packer packer(packed);
    std::vector<Values> values;
    for (const FieldSample& s : field.samples) values.push_back(packer.values(s));
    const std::vector<int> first = shared(field, values, packer);
    std::vector<int> place(field.samples.size(), -1);
    int n = 0;
    for (const bool of_inside : {true, false}) {
        for (std::size_t i = 0; i < place.size(); ++i) {
            if (first[i] != static_cast<int>(i) || inside[i] != of_inside) continue;
            place[i] = n++;
            packer.add(field.samples[i].at, values[i]);
        }
        if (of_inside) packed.n_inside = static_cast<std::size_t>(n);
    }
    packed.samples = packer.text();
    Bytes patches;
    int before = 0;
    for (const FieldPatch& patch : field.patches) {
        std::array<int, 4> corner{};
        for (std::size_t i = 0; i < 4; ++i)
            corner[i] = place[static_cast<std::size_t>(first[static_cast<std::size_t>(patch.corner[i])])];
        append_signed(corner[0] - before, patches);
        for (std::size_t i = 1; i < 4; ++i) append_signed(corner[i] - corner[0], patches);
        before = corner[0];
    }
    packed.patches = base64(patches);
}

}  // namespace

PackedField packed_field(const PartField& field, const geometry::Part& part) {
    PackedField packed;
    const geometry::Box2 box = geometry::bounding_box(part);
    packed.origin = box.empty() ? Vec2(0, 0) : box.center();
    packed.step = box.diagonal() > 0 ? place_step * box.diagonal() : 1;
    const geometry::SlabbedPieces pieces = geometry::slabbed(geometry::monotone_pieces(part));
    std::vector<bool> inside;
    for (const FieldSample& s : field.samples) inside.push_back(geometry::contains(pieces, s.at));
    packed.scale = scale_of(field, inside);
    pack_samples(field, inside, packed);
    Packer packer(packed);
    for (const auto& loop : field.boundary.empty() ? drawn_boundary(part) : field.boundary) {
        packed.loop_sizes.push_back(loop.size());
        for (const FieldSample& s : loop) packer.add(s.at, packer.values(s));
    }
    packed.loops = packer.text();
    return packed;
}

}  // namespace abut::report
