// SPDX-License-Identifier: MIT
#include "marks/clusters.h"

#include "base/assert.h"
#include "base/long_array.h"
#include "base/sort.h"
#include "geometry/cell_grid.h"
#include "geometry/morton.h"
#include "geometry/unit.h"
#include "marks/tuning.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace hrbfnpr::marks {
namespace {

constexpr int cell_bits = 16; // bits for each coordinate of a mark's cell on the Morton curve

std::array<float, 3> to_floats(const glm::dvec3& v) noexcept {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

// ---- The bounds of a cluster. place(i) and normal(i) are those of marks begin .. end - 1.

// Around the normals, and a little larger than the truth, so that floats hold it.
struct Cone {
    std::array<float, 3> axis{};
    float cosine = 1.0F, sine = 0.0F; // the cosine and sine of its half angle
};

template <class Normal>
Cone cone_around(std::int64_t begin, std::int64_t end, const Normal& normal) {
    HRBFNPR_ASSERT(begin < end);
    glm::dvec3 sum(0.0);
    for (std::int64_t i = begin; i < end; ++i) sum += normal(i);
    const glm::dvec3 axis = glm::normalize(sum);
    double cosine = 1.0;
    for (std::int64_t i = begin; i < end; ++i) cosine = std::min(cosine, glm::dot(axis, normal(i)));
    const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)) + 1e-3;
    return {to_floats(axis), static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
}

// The ball and the cone around the marks; both are a little larger than the truth.
template <class Place, class Normal>
void set_extent(Extent& extent, std::int64_t begin, std::int64_t end, const Place& place, const Normal& normal) {
    geometry::Bounds bounds;
    for (std::int64_t i = begin; i < end; ++i) bounds.extend(place(i));
    const glm::dvec3 centre = bounds.centre();
    double radius = 0.0;
    for (std::int64_t i = begin; i < end; ++i) radius = std::max(radius, glm::length(place(i) - centre));
    extent.centre = to_floats(centre);
    extent.radius = static_cast<float>(radius * 1.00001);
    const Cone cone = cone_around(begin, end, normal);
    extent.axis = cone.axis;
    extent.cone_cosine = cone.cosine;
    extent.cone_sine = cone.sine;
}

// How the normals turn along the surface: Cluster::shape and ::bend.
struct Turn {
    std::array<float, 6> shape{};
    float bend = -1.0F; // < 0: not known
};

// By the linear map that takes the marks' offsets from their mean to the normals', in the sense of least squares.
template <class Place, class Normal>
Turn fit_turn(std::int64_t begin, std::int64_t end, const Place& place, const Normal& normal) {
    glm::dvec3 middle(0.0);
    glm::dvec3 mean(0.0);
    for (std::int64_t i = begin; i < end; ++i) {
        middle += place(i);
        mean += normal(i);
    }
    middle /= static_cast<double>(end - begin);
    mean /= static_cast<double>(end - begin);
    glm::dmat3 spread(0.0);
    glm::dmat3 mixed(0.0);
    for (std::int64_t i = begin; i < end; ++i) {
        const glm::dvec3 p = place(i) - middle;
        spread += glm::outerProduct(p, p);
        mixed += glm::outerProduct(normal(i) - mean, p);
    }
    // Marks lie near a plane. Across it their spread tells nothing, so the map is damped there.
    const glm::dvec3 axis = glm::normalize(mean);
    const double trace = spread[0][0] + spread[1][1] + spread[2][2];
    const glm::dmat3 map = mixed * glm::inverse(spread + trace * glm::outerProduct(axis, axis));
    const glm::dmat3 s = 0.5 * (map + glm::transpose(map));
    // The larger curvature of a symmetric map of a plane, from its trace and its Frobenius norm.  [Kindlmann et al.
    // 2003]
    const double squares = glm::dot(s[0], s[0]) + glm::dot(s[1], s[1]) + glm::dot(s[2], s[2]);
    const double t = s[0][0] + s[1][1] + s[2][2];
    const double bend = 0.5 * (std::abs(t) + std::sqrt(std::max(0.0, 2.0 * squares - t * t)));
    if (!(bend <= marks_tuning.most_bend)) return {};
    const auto [x, yz] = std::pair(to_floats({s[0][0], s[1][0], s[2][0]}), to_floats({s[1][1], s[2][1], s[2][2]}));
    return {{x[0], x[1], x[2], yz[0], yz[1], yz[2]}, static_cast<float>(bend)};
}

void set_turn(Cluster& cluster, const Turn& turn) noexcept {
    cluster.shape = turn.shape;
    cluster.bend = turn.bend;
}

// Three floats of each mark of a layer, relative to the set's origin.
struct MarkPlaces {
    const float* position;
    const float* normal;
    const float* tone_normal; // NULL: they are not known
};

void set_extent(StrokePiece& piece, const Layer& layer, const MarkPlaces& places, double unit) {
    const std::int64_t begin = piece.first;
    const std::int64_t end = begin + piece.count;
    HRBFNPR_ASSERT(begin < end && end <= layer.count());
    const auto vectors = [&](const float* from) {
        return [from, &layer](std::int64_t at) {
            const float* const v = from + 3 * layer.mark_of(at);
            return glm::dvec3(v[0], v[1], v[2]);
        };
    };
    const auto position = vectors(places.position);
    set_extent(
        piece, begin, end, [&](std::int64_t at) { return position(at) / unit; }, vectors(places.normal));
    Cone tone{{}, -1.0F, 0.0F}; // the cone of all directions
    if (places.tone_normal == places.normal)
        tone = {piece.axis, piece.cone_cosine, piece.cone_sine};
    else if (places.tone_normal != nullptr)
        tone = cone_around(begin, end, vectors(places.tone_normal));
    piece.tone_axis = tone.axis;
    piece.tone_cosine = tone.cosine;
    piece.tone_sine = tone.sine;
}

// ---- Clusters of a finished layer

struct Keyed {
    std::uint64_t key; // set of directions, side of the cube that the normal points at, place along a Morton curve
    std::uint32_t mark;
};

std::uint64_t side_of(const glm::dvec3& n) noexcept {
    const glm::dvec3 a = glm::abs(n);
    const int axis = a.x >= a.y ? (a.x >= a.z ? 0 : 2) : (a.y >= a.z ? 1 : 2);
    return static_cast<std::uint64_t>(2 * axis + (n[axis] < 0.0 ? 1 : 0));
}

base::Array<Keyed> sorted_along_curve(const Layer& layer, double unit, const base::Progress& progress) {
    constexpr std::int64_t last = (std::int64_t{1} << cell_bits) - 1;
    base::Array<Keyed> order(layer.rank.memory(), layer.count());
    const auto place = [&](std::int64_t i) { return glm::dvec3(vector_at(layer.position, i)) / unit; };
    geometry::Bounds bounds;
    for (std::int64_t i = 0; i < order.size(); ++i) bounds.extend(place(i));
    const double side = bounds.longest_side();
    const double scale = side > 0.0 ? static_cast<double>(last) / side : 0.0;
    for (std::int64_t i = 0; i < order.size(); ++i) {
        if (i % 16384 == 0) progress.check();
        const glm::dvec3 at = (place(i) - bounds.min) * scale;
        const std::uint64_t code = geometry::morton_code(
            {geometry::whole(at.x, last), geometry::whole(at.y, last), geometry::whole(at.z, last)});
        const std::uint64_t set = layer.has_strokes() ? layer.direction_of(i) : 0U;
        order[i] = {(set * 8 + side_of(vector_at(layer.normal, i))) << (3 * cell_bits) | code,
                    static_cast<std::uint32_t>(i)};
    }
    base::sort_long(
        order.begin(), order.end(),
        [](const Keyed& a, const Keyed& b) { return a.key != b.key ? a.key < b.key : a.mark < b.mark; }, progress);
    return order;
}

class Clustering {
public:
    Clustering(const Layer& layer, double unit, MarkClusters& result, const base::Progress& progress)
        : layer_(layer), unit_(unit), result_(result), progress_(progress),
          order_(sorted_along_curve(layer, unit, progress)) {
        split(0, order_.size(), 3 * cell_bits, Turn{});
        fill();
    }

private:
    [[nodiscard]] glm::dvec3 place(std::int64_t mark) const noexcept {
        return glm::dvec3(vector_at(layer_.position, mark)) / unit_;
    }

    // The position and the normal of the mark at place i in the order.
    [[nodiscard]] auto places() const noexcept {
        return [this](std::int64_t i) { return place(order_[i].mark); };
    }
    [[nodiscard]] auto normals() const noexcept {
        return [this](std::int64_t i) { return glm::dvec3(vector_at(layer_.normal, order_[i].mark)); };
    }

    // Splits marks begin .. end - 1 into parts that agree in the key down to `shift`, until they are small enough.
    // parent: the turn of the part that holds all of them, for parts that are too small to tell their own.
    void split(std::int64_t begin, std::int64_t end, int shift, const Turn& parent) {
        while (begin < end) {
            const std::uint64_t head = order_[begin].key >> shift;
            const Keyed* const next = std::partition_point(order_.data() + begin, order_.data() + end,
                                                           [&](const Keyed& k) { return k.key >> shift == head; });
            const std::int64_t stop = next - order_.data();
            const std::int64_t count = stop - begin;
            const bool tells = count >= marks_tuning.fewest_to_fit && count <= 16 * most_in_cluster;
            const Turn turn = tells ? fit_turn(begin, stop, places(), normals()) : parent;
            if (count <= most_in_cluster || shift == 0)
                close(begin, stop, turn);
            else
                split(begin, stop, shift - 3, turn);
            begin = stop;
        }
    }

    void close(std::int64_t begin, std::int64_t end, const Turn& turn) {
        progress_.check();
        std::sort(order_.data() + begin, order_.data() + end, [&](const Keyed& a, const Keyed& b) {
            const float u = layer_.rank[a.mark];
            const float v = layer_.rank[b.mark];
            return u != v ? u > v : a.mark < b.mark;
        });
        // More marks than that are at one place only if they are all alike.
        for (; begin < end; begin += most_in_cluster) {
            const std::int64_t stop = std::min(end, begin + most_in_cluster);
            Cluster cluster;
            cluster.count = static_cast<std::int32_t>(stop - begin);
            cluster.set = layer_.has_strokes() ? layer_.direction_of(order_[begin].mark) : 0U;
            set_extent(cluster, begin, stop, places(), normals());
            set_turn(cluster, turn);
            result_.cluster.push_back(cluster);
        }
    }

    void fill() {
        constexpr std::int64_t size = MarkBlock::size;
        std::int64_t blocks = 0;
        for (Cluster& cluster : result_.cluster) {
            cluster.block = blocks;
            blocks += (cluster.count + size - 1) / size;
        }
        base::resize_long(result_.block, blocks, progress_);
        if (!layer_.width.empty()) base::resize_long(result_.width, blocks * size, progress_);
        const Keyed* from = order_.data();
        for (const Cluster& cluster : result_.cluster) {
            progress_.check();
            for (std::int64_t i = 0; i < cluster.count; ++i) put(cluster.block * size + i, (from++)->mark);
        }
        HRBFNPR_ASSERT(from == order_.end());
    }

    void put(std::int64_t slot, std::int64_t mark) {
        MarkBlock& block = result_.block[slot / MarkBlock::size];
        const std::int64_t at = slot % MarkBlock::size;
        const glm::vec3 p(place(mark));
        const glm::vec3 n = vector_at(layer_.normal, mark);
        block.x[at] = p.x;
        block.y[at] = p.y;
        block.z[at] = p.z;
        block.nx[at] = n.x;
        block.ny[at] = n.y;
        block.nz[at] = n.z;
        block.rank[at] = layer_.rank[mark];
        block.mark[at] = static_cast<std::uint32_t>(mark);
        if (!layer_.width.empty()) result_.width[slot] = layer_.width[mark];
    }

    const Layer& layer_;
    double unit_;
    MarkClusters& result_;
    const base::Progress& progress_;
    base::Array<Keyed> order_;
};

void cut_strokes(const Layer& layer, double unit, base::Array<StrokePiece>& pieces, const base::Progress& progress) {
    const float* const tone_normal = layer.tone_normal.empty() ? layer.normal.data() : layer.tone_normal.data();
    for (std::int64_t s = 0; s < layer.strokes(); ++s) {
        if (s % 1024 == 0) progress.check();
        const std::int64_t end = layer.stroke_first[s + 1];
        for (std::int64_t first = layer.stroke_first[s]; first < end; first += StrokePiece::most) {
            StrokePiece piece;
            piece.first = static_cast<std::uint32_t>(first);
            piece.count = static_cast<std::uint8_t>(std::min(end - first, StrokePiece::most));
            piece.level = layer.level[layer.mark_of(first)];
            for (std::int64_t i = 1; i < piece.count; ++i)
                piece.level = std::min(piece.level, layer.level[layer.mark_of(first + i)]);
            set_extent(piece, layer, {layer.position.data(), layer.normal.data(), tone_normal}, unit);
            base::push_back_long(pieces, piece, progress);
        }
    }
}

// ---- Clusters that moved

void copy_clusters(const MarkClusters& from, MarkClusters& to) {
    copy_array(from.block, to.block);
    copy_array(from.width, to.width);
    copy_array(from.cluster, to.cluster);
    copy_array(from.piece, to.piece);
}

// The nearest of the clusters beside it in the order that tells how the surface bends and faces alike; null: none.
const Cluster* nearest_that_tells(const base::Array<Cluster>& clusters, std::int64_t c) noexcept {
    const Cluster& own = clusters[c];
    const auto vector = [](const std::array<float, 3>& a) { return glm::vec3(a[0], a[1], a[2]); };
    const auto square = [&](const Cluster& other) {
        const glm::vec3 way = vector(own.centre) - vector(other.centre);
        return glm::dot(way, way);
    };
    const Cluster* nearest = nullptr;
    for (const std::int64_t k : {c - 1, c + 1}) {
        if (k < 0 || k >= clusters.size() || clusters[k].count < marks_tuning.fewest_to_fit) continue;
        if (glm::dot(vector(clusters[k].axis), vector(own.axis)) > marks_tuning.alike_cosine &&
            (nearest == nullptr || square(clusters[k]) < square(*nearest)))
            nearest = &clusters[k];
    }
    return nearest;
}

} // namespace

std::int64_t MarkClusters::bytes() const noexcept {
    return block.bytes() + width.bytes() + cluster.bytes() + piece.bytes() + gap.bytes();
}

void cluster_marks(const base::Runtime& runtime, PointSet& set, const base::Progress& progress) {
    float largest = 0.0F;
    for (const Layer& layer : set.layers)
        for (const float coordinate : layer.position) largest = std::max(largest, std::abs(coordinate));
    set.unit = geometry::unit_for(double{largest});
    runtime.parallel.for_each(set.layers.size(), [&](std::int64_t number) {
        Layer& layer = set.layers[number];
        HRBFNPR_ASSERT(layer.position.size() == 3 * layer.count() && layer.normal.size() == 3 * layer.count());
        layer.clusters = MarkClusters(runtime.memory);
        if (layer.count() > 0) Clustering(layer, set.unit, layer.clusters, progress);
        cut_strokes(layer, set.unit, layer.clusters.piece, progress);
    });
    for (Layer& layer : set.layers) measure_gaps(runtime, layer, layer.clusters.gap, progress);
}

void move_clusters(const Layer& layer, const float* position, const float* normal, double unit, MarkClusters& moved) {
    HRBFNPR_ASSERT(unit > 0.0);
    copy_clusters(layer.clusters, moved);
    for (const Cluster& cluster : moved.cluster) {
        for (std::int64_t i = 0; i < cluster.count; ++i) {
            MarkBlock& block = moved.block[cluster.block + i / MarkBlock::size];
            const std::int64_t at = i % MarkBlock::size;
            const std::int64_t mark = 3 * std::int64_t{block.mark[at]};
            block.x[at] = static_cast<float>(double{position[mark]} / unit);
            block.y[at] = static_cast<float>(double{position[mark + 1]} / unit);
            block.z[at] = static_cast<float>(double{position[mark + 2]} / unit);
            block.nx[at] = normal[mark];
            block.ny[at] = normal[mark + 1];
            block.nz[at] = normal[mark + 2];
        }
    }
    // Normals for tone turn with their marks' directions, too, which are not known here.
    const float* const tone_normal = layer.tone_normal.empty() ? normal : nullptr;
    for (StrokePiece& piece : moved.piece) set_extent(piece, layer, {position, normal, tone_normal}, unit);
    const auto place_in = [&](std::int64_t slot) {
        const MarkBlock& b = moved.block[slot / MarkBlock::size];
        return glm::dvec3(b.x[slot % MarkBlock::size], b.y[slot % MarkBlock::size], b.z[slot % MarkBlock::size]);
    };
    const auto normal_in = [&](std::int64_t slot) {
        const MarkBlock& b = moved.block[slot / MarkBlock::size];
        return glm::dvec3(b.nx[slot % MarkBlock::size], b.ny[slot % MarkBlock::size], b.nz[slot % MarkBlock::size]);
    };
    for (Cluster& cluster : moved.cluster) {
        const std::int64_t begin = cluster.block * MarkBlock::size;
        const std::int64_t end = begin + cluster.count;
        set_extent(cluster, begin, end, place_in, normal_in);
        if (cluster.count >= marks_tuning.fewest_to_fit) set_turn(cluster, fit_turn(begin, end, place_in, normal_in));
    }
    // A cluster of too few marks bends as the nearest one does that tells.
    for (std::int64_t c = 0; c < moved.cluster.size(); ++c) {
        if (moved.cluster[c].count >= marks_tuning.fewest_to_fit) continue;
        const Cluster* const nearest = nearest_that_tells(moved.cluster, c);
        set_turn(moved.cluster[c], nearest != nullptr ? Turn{nearest->shape, nearest->bend} : Turn{});
    }
}

void turn_clusters(const MarkClusters& clusters, MarkClusters& turned) {
    copy_clusters(clusters, turned);
    const auto negate = [](auto& numbers) {
        for (float& number : numbers) number = -number;
    };
    for (MarkBlock& block : turned.block) {
        negate(block.nx);
        negate(block.ny);
        negate(block.nz);
    }
    for (Cluster& cluster : turned.cluster) {
        negate(cluster.axis);
        negate(cluster.shape);
    }
    for (StrokePiece& piece : turned.piece) {
        negate(piece.axis);
        negate(piece.tone_axis);
    }
}

} // namespace hrbfnpr::marks
