#include "marks/cluster_marks.h"

#include "geometry/cell_grid.h"
#include "geometry/morton.h"
#include "geometry/unit.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace hrbfnpr::marks {
namespace {

constexpr int cell_bits = 16;              // of each coordinate of a mark's place along the curve
constexpr std::int64_t fewest_to_fit = 12; // marks for the turn of the normals; else it is the parent cell's

struct Keyed {
    std::uint64_t key; // set of directions, side of the cube that the normal points at, place along the curve
    std::uint32_t mark;
};

// Curvatures beyond it, as of marks at one place with different normals, are none.
constexpr double most_bend = 1e30;

struct Turn {
    glm::dmat3 shape{0.0};
    double bend = -1.0;
};

[[nodiscard]] glm::dvec3 precise(const base::Array<float>& a, std::int64_t i) noexcept { return vector_at(a, i); }

// A power of two in which the positions of all layers are of ordinary size.
[[nodiscard]] double unit_of(const PointSet& set) noexcept {
    float largest = 0.0F;
    for (const Layer& layer : set.layers)
        for (const float coordinate : layer.position) largest = std::max(largest, std::abs(coordinate));
    return geometry::unit_for(double{largest});
}

[[nodiscard]] std::uint64_t side_of(const glm::dvec3& n) noexcept {
    const glm::dvec3 a = glm::abs(n);
    const int axis = a.x >= a.y ? (a.x >= a.z ? 0 : 2) : (a.y >= a.z ? 1 : 2);
    return static_cast<std::uint64_t>(2 * axis + (n[axis] < 0.0 ? 1 : 0));
}

class Clustering {
public:
    Clustering(const Layer& layer, double unit, MarkClusters& result, const base::Progress& progress)
        : layer_(layer), strokes_(layer.has_strokes()), unit_(unit), result_(result), progress_(progress),
          order_(layer.rank.memory(), layer.count()) {}

    void run() {
        if (layer_.count() == 0) return;
        sort();
        split(0, order_.size(), 3 * cell_bits, Turn{});
        fill();
    }

private:
    [[nodiscard]] glm::dvec3 place(std::int64_t mark) const noexcept { return precise(layer_.position, mark) / unit_; }

    void sort() {
        geometry::Bounds bounds;
        for (std::int64_t i = 0; i < order_.size(); ++i) bounds.extend(place(i));
        const glm::dvec3 size = bounds.size();
        const double side = std::max({size.x, size.y, size.z});
        const double scale = side > 0.0 ? ((1 << cell_bits) - 1) / side : 0.0;
        for (std::int64_t i = 0; i < order_.size(); ++i) {
            if (i % 65536 == 0) progress_.check();
            const glm::dvec3 at = (place(i) - bounds.min) * scale;
            constexpr std::int64_t last = (1 << cell_bits) - 1;
            const std::uint64_t code = geometry::morton_code(
                {geometry::whole(at.x, last), geometry::whole(at.y, last), geometry::whole(at.z, last)});
            const std::uint64_t set = strokes_ ? layer_.direction_of(i) : 0U;
            order_[i] = {(set * 8 + side_of(precise(layer_.normal, i))) << (3 * cell_bits) | code,
                         static_cast<std::uint32_t>(i)};
        }
        std::sort(order_.begin(), order_.end(),
                  [](const Keyed& a, const Keyed& b) { return a.key != b.key ? a.key < b.key : a.mark < b.mark; });
    }

    // Parts that agree in the key down to `shift`, until they are small enough.
    void split(std::int64_t begin, std::int64_t end, int shift, const Turn& parent) {
        while (begin < end) {
            const std::uint64_t head = order_[begin].key >> shift;
            const Keyed* const next = std::partition_point(order_.data() + begin, order_.data() + end,
                                                           [&](const Keyed& k) { return k.key >> shift == head; });
            const std::int64_t stop = next - order_.data();
            const Turn turn =
                stop - begin >= fewest_to_fit && stop - begin <= 16 * most_in_cluster ? turn_of(begin, stop) : parent;
            if (stop - begin <= most_in_cluster || shift == 0)
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
        for (; begin < end; begin += most_in_cluster)
            result_.cluster.push_back(cluster_of(begin, std::min(end, begin + most_in_cluster), turn));
    }

    // The linear map that takes the marks' offsets from their mean to the normals', in the sense of least squares.
    [[nodiscard]] Turn turn_of(std::int64_t begin, std::int64_t end) const {
        glm::dvec3 middle(0.0);
        glm::dvec3 normal(0.0);
        for (std::int64_t i = begin; i < end; ++i) {
            middle += place(order_[i].mark);
            normal += precise(layer_.normal, order_[i].mark);
        }
        const double count = static_cast<double>(end - begin);
        middle /= count;
        normal /= count;
        glm::dmat3 spread(0.0);
        glm::dmat3 mixed(0.0);
        for (std::int64_t i = begin; i < end; ++i) {
            const glm::dvec3 p = place(order_[i].mark) - middle;
            const glm::dvec3 n = precise(layer_.normal, order_[i].mark) - normal;
            spread += glm::outerProduct(p, p);
            mixed += glm::outerProduct(n, p);
        }
        // Marks lie near a plane: what is across it is left out.
        const glm::dvec3 axis = glm::normalize(normal);
        const double trace = spread[0][0] + spread[1][1] + spread[2][2];
        const glm::dmat3 map = mixed * glm::inverse(spread + trace * glm::outerProduct(axis, axis));
        Turn turn;
        turn.shape = 0.5 * (map + glm::transpose(map));
        double squares = 0.0;
        for (int c = 0; c < 3; ++c) squares += glm::dot(turn.shape[c], turn.shape[c]);
        // Of a symmetric map of a plane, from its trace and its Frobenius norm.  [Kindlmann et al. 2003]
        const double t = turn.shape[0][0] + turn.shape[1][1] + turn.shape[2][2];
        turn.bend = 0.5 * (std::abs(t) + std::sqrt(std::max(0.0, 2.0 * squares - t * t)));
        return turn.bend <= most_bend ? turn : Turn{};
    }

    [[nodiscard]] Cluster cluster_of(std::int64_t begin, std::int64_t end, const Turn& turn) const {
        Cluster cluster;
        cluster.count = static_cast<std::int32_t>(end - begin);
        cluster.set = strokes_ ? layer_.direction_of(order_[begin].mark) : 0U;
        geometry::Bounds bounds;
        glm::dvec3 sum(0.0);
        for (std::int64_t i = begin; i < end; ++i) {
            bounds.extend(place(order_[i].mark));
            sum += precise(layer_.normal, order_[i].mark);
        }
        const glm::dvec3 centre = bounds.centre();
        const glm::dvec3 axis = glm::normalize(sum);
        double radius = 0.0;
        double cosine = 1.0;
        for (std::int64_t i = begin; i < end; ++i) {
            radius = std::max(radius, glm::length(place(order_[i].mark) - centre));
            cosine = std::min(cosine, glm::dot(axis, precise(layer_.normal, order_[i].mark)));
        }
        for (int k = 0; k < 3; ++k) {
            cluster.centre[static_cast<std::size_t>(k)] = static_cast<float>(centre[k]);
            cluster.axis[static_cast<std::size_t>(k)] = static_cast<float>(axis[k]);
        }
        // Both are a little larger than the truth, so that floats hold them.
        cluster.radius = static_cast<float>(radius * 1.00001);
        const double cone = std::acos(std::clamp(cosine, -1.0, 1.0)) + 1e-3;
        cluster.cone_cosine = static_cast<float>(std::cos(cone));
        cluster.cone_sine = static_cast<float>(std::sin(cone));
        cluster.bend = static_cast<float>(turn.bend);
        const glm::dmat3& s = turn.shape;
        const std::array<double, 6> shape = {s[0][0], s[1][0], s[2][0], s[1][1], s[2][1], s[2][2]};
        for (std::size_t k = 0; k < shape.size(); ++k) cluster.shape[k] = static_cast<float>(shape[k]);
        return cluster;
    }

    void fill() {
        constexpr std::int64_t size = MarkBlock::size;
        std::int64_t blocks = 0;
        for (Cluster& cluster : result_.cluster) {
            cluster.block = blocks;
            blocks += (cluster.count + size - 1) / size;
        }
        result_.block.resize(blocks);
        if (!layer_.width.empty()) result_.width.resize(blocks * size);
        const Keyed* from = order_.data();
        for (const Cluster& cluster : result_.cluster) {
            for (std::int64_t i = 0; i < cluster.count; ++i) put(cluster.block * size + i, (from++)->mark);
        }
    }

    void put(std::int64_t slot, std::int64_t mark) {
        MarkBlock& block = result_.block[slot / MarkBlock::size];
        const std::int64_t at = slot % MarkBlock::size;
        const glm::vec3 p(place(mark));
        block.x[at] = p.x;
        block.y[at] = p.y;
        block.z[at] = p.z;
        block.nx[at] = layer_.normal[3 * mark];
        block.ny[at] = layer_.normal[3 * mark + 1];
        block.nz[at] = layer_.normal[3 * mark + 2];
        block.rank[at] = layer_.rank[mark];
        block.mark[at] = static_cast<std::uint32_t>(mark);
        if (!layer_.width.empty()) result_.width[slot] = layer_.width[mark];
    }

    const Layer& layer_;
    bool strokes_;
    double unit_;
    MarkClusters& result_;
    const base::Progress& progress_;
    base::Array<Keyed> order_;
};

} // namespace

std::int64_t MarkClusters::bytes() const noexcept { return block.bytes() + width.bytes() + cluster.bytes(); }

void cluster_marks(const base::Runtime& runtime, PointSet& set, const base::Progress& progress) {
    set.unit = unit_of(set);
    runtime.parallel.for_each(set.layers.size(), [&](std::int64_t number) {
        Layer& layer = set.layers[number];
        layer.clusters = MarkClusters(runtime.memory);
        Clustering(layer, set.unit, layer.clusters, progress).run();
    });
}

} // namespace hrbfnpr::marks
