// SPDX-License-Identifier: MIT
#include "marks/point_set.h"

#include "base/assert.h"
#include "base/long_array.h"
#include "base/sort_on_threads.h"
#include "geometry/cell_grid.h"
#include "geometry/morton.h"
#include "geometry/point_grid.h"
#include "geometry/unit.h"
#include "marks/tuning.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrbfnpr::marks {
namespace {

constexpr NormalVariation unknown_variation{-1.0F, {}};

constexpr int cell_bits = 16; // number of bits for each coordinate of a mark's cell on the Morton curve

// The number of ranges of clusters, and the number of marks, for a task.
constexpr std::int64_t ranges_a_task = 64;
constexpr std::int64_t marks_a_task = 16384;

std::array<float, 3> to_floats(const glm::dvec3& v) noexcept {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

// ---- The bounds of a cluster. place(i) and normal(i) describe marks begin .. end - 1.

// Returns a cone around the normals. It is slightly larger than necessary, because it is stored in floats.
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

// Sets the ball and the cone around the marks. Both are slightly larger than necessary.
template <class Place, class Normal>
void set_extent(Extent& extent, std::int64_t begin, std::int64_t end, const Place& place, const Normal& normal) {
    geometry::Bounds bounds;
    for (std::int64_t i = begin; i < end; ++i) bounds.extend(place(i));
    const glm::dvec3 centre = bounds.centre();
    double radius = 0.0;
    for (std::int64_t i = begin; i < end; ++i) radius = std::max(radius, glm::length(place(i) - centre));
    extent.centre = to_floats(centre);
    extent.radius = static_cast<float>(radius * 1.00001);
    extent.cone = cone_around(begin, end, normal);
}

// Returns how the normals turn along the surface: a linear map, fitted by least squares. For each mark, it maps the
// offset of its place from the mean place to the offset of its normal from the mean normal.
template <class Place, class Normal>
NormalVariation fit_normal_variation(std::int64_t begin, std::int64_t end, const Place& place, const Normal& normal) {
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
    // Marks lie near a plane. Their spread perpendicular to it is not informative, so the map is damped in this
    // direction.
    const glm::dvec3 axis = glm::normalize(mean);
    const double trace = spread[0][0] + spread[1][1] + spread[2][2];
    const glm::dmat3 map = mixed * glm::inverse(spread + trace * glm::outerProduct(axis, axis));
    const glm::dmat3 s = 0.5 * (map + glm::transpose(map));
    // The larger curvature is computed from the trace and the Frobenius norm of the map in the tangent plane.
    // [Kindlmann et al. 2003]
    const double squares = glm::dot(s[0], s[0]) + glm::dot(s[1], s[1]) + glm::dot(s[2], s[2]);
    const double t = s[0][0] + s[1][1] + s[2][2];
    const double bend = 0.5 * (std::abs(t) + std::sqrt(std::max(0.0, 2.0 * squares - t * t)));
    if (!(bend <= marks_tuning.most_curvature)) return unknown_variation;
    const auto [x, yz] = std::pair(to_floats({s[0][0], s[1][0], s[2][0]}), to_floats({s[1][1], s[2][1], s[2][2]}));
    return {static_cast<float>(bend), {x[0], x[1], x[2], yz[0], yz[1], yz[2]}};
}

// Sets the bounds of a piece. `positions` and the normals have three floats for each mark of the layer. `tone_normals`
// may be null if they are unknown.
void set_extent(StrokePiece& piece, const Layer& layer, const float* positions, const float* normals,
                const float* tone_normals, double unit) {
    const std::int64_t begin = piece.first;
    const std::int64_t end = begin + piece.count;
    HRBFNPR_ASSERT(begin < end && end <= layer.count());
    const auto vectors = [&](const float* from) {
        return [from, &layer](std::int64_t at) {
            const float* const v = from + 3 * layer.mark_of(at);
            return glm::dvec3(v[0], v[1], v[2]);
        };
    };
    const auto position = vectors(positions);
    set_extent(
        piece, begin, end, [&](std::int64_t at) { return position(at) / unit; }, vectors(normals));
    piece.tone = tone_normals == normals   ? piece.cone
                 : tone_normals != nullptr ? cone_around(begin, end, vectors(tone_normals))
                                           : Cone{{}, -1.0F, 0.0F}; // a cone that contains all directions
}

// ---- Clusters of a finished layer

struct KeyedMark {
    // The sort key: the direction (0 or 1) of the stroke, then the side of a cube that the normal points to, then the
    // position on a Morton curve.
    std::uint64_t key;
    std::uint32_t mark;
};

base::Array<KeyedMark> sorted_along_curve(const base::Work& work, const Layer& layer, double unit) {
    constexpr std::int64_t last = (std::int64_t{1} << cell_bits) - 1;
    base::Array<KeyedMark> order(layer.rank.memory());
    order.resize_for_overwrite(layer.count());
    const auto place = [&](std::int64_t i) { return glm::dvec3(vector_at(layer.position, i)) / unit; };
    geometry::Bounds bounds;
    for (std::int64_t i = 0; i < order.size(); ++i) bounds.extend(place(i));
    const double side = bounds.longest_side();
    const double scale = side > 0.0 ? static_cast<double>(last) / side : 0.0;
    work.for_chunks(order.size(), marks_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const glm::dvec3 at = (place(i) - bounds.min) * scale;
            const std::uint64_t code =
                geometry::morton_code({geometry::truncate_to(at.x, last), geometry::truncate_to(at.y, last),
                                       geometry::truncate_to(at.z, last)});
            const std::uint64_t set = layer.has_strokes() ? layer.direction_of(i) : 0U;
            const glm::vec3 n = vector_at(layer.normal, i);
            const glm::vec3 a = glm::abs(n);
            const int axis = a.x >= a.y ? (a.x >= a.z ? 0 : 2) : (a.y >= a.z ? 1 : 2);
            const std::uint64_t cube_side = 2U * static_cast<unsigned>(axis) + (n[axis] < 0.0F ? 1U : 0U);
            order[i] = {(set * 8 + cube_side) << (3 * cell_bits) | code, static_cast<std::uint32_t>(i)};
        }
    });
    base::sort_on_threads(work, order, [](const KeyedMark& a, const KeyedMark& b) {
        return a.key != b.key ? a.key < b.key : a.mark < b.mark;
    });
    return order;
}

// A layer whose marks are put into clusters; the marks are sorted by their keys.
struct SortedMarks {
    [[nodiscard]] glm::dvec3 place(std::int64_t i) const noexcept {
        return glm::dvec3(vector_at(layer.position, order[i].mark)) / unit;
    }
    [[nodiscard]] glm::dvec3 normal(std::int64_t i) const noexcept { return vector_at(layer.normal, order[i].mark); }

    const Layer& layer;
    double unit;
    base::Array<KeyedMark> order;
};

// Returns the end of the marks from `begin` on, up to `end`, whose keys agree in the bits above `shift`.
[[nodiscard]] std::int64_t end_of_key(const SortedMarks& sorted, std::int64_t begin, std::int64_t end, int shift) {
    const KeyedMark* const marks = sorted.order.data();
    const std::uint64_t head = marks[begin].key >> shift;
    return std::partition_point(marks + begin, marks + end,
                                [&](const KeyedMark& k) { return k.key >> shift == head; }) -
           marks;
}

// Consecutive marks whose keys agree in the bits above `shift`.
struct KeyRange {
    std::int64_t begin, end;
    int shift;
    std::int64_t fit = -1; // its index in ClusterRanges::fit; -1 if it is not there yet

    [[nodiscard]] std::int64_t count() const noexcept { return end - begin; }
};

// A range of marks that become one cluster, or several if they have the same key.
struct ClusterRange {
    std::int64_t begin, end;
    std::int64_t fit; // the index of the range that says how the normals of these marks turn; -1 if none does
};

// The ranges of all clusters.
struct ClusterRanges {
    explicit ClusterRanges(base::Memory& memory) noexcept : cluster(memory), fit(memory) {}

    base::Array<ClusterRange> cluster;
    base::Array<KeyRange> fit;
};

// Splits a range into parts whose keys agree, until the parts are small enough. `around` is the smallest range around
// it that is neither too large nor too small to say how its normals turn, or null. It is used for parts that are too
// small.
void split_by_key(const SortedMarks& sorted, KeyRange& range, KeyRange* around, ClusterRanges& ranges,
                  const base::Progress& progress) {
    progress.check();
    const std::int64_t count = range.count();
    if (count >= marks_tuning.fewest_to_fit && count <= 16 * most_in_cluster) around = &range;
    if (count <= most_in_cluster || range.shift == 0) {
        if (around != nullptr && around->fit < 0) {
            around->fit = ranges.fit.size();
            ranges.fit.push_back(*around);
        }
        ranges.cluster.push_back({range.begin, range.end, around != nullptr ? around->fit : -1});
        return;
    }
    for (std::int64_t begin = range.begin; begin < range.end;) {
        KeyRange part{begin, end_of_key(sorted, begin, range.end, range.shift - 3), range.shift - 3};
        split_by_key(sorted, part, around, ranges, progress);
        begin = part.end;
    }
}

[[nodiscard]] base::Array<NormalVariation> fit_ranges(const base::Work& work, const SortedMarks& sorted,
                                                      const base::Array<KeyRange>& ranges) {
    base::Array<NormalVariation> turn(work.memory, ranges.size());
    work.for_chunks(ranges.size(), ranges_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t k = begin; k < end; ++k)
            turn[k] = fit_normal_variation(
                ranges[k].begin, ranges[k].end, [&](std::int64_t i) { return sorted.place(i); },
                [&](std::int64_t i) { return sorted.normal(i); });
    });
    return turn;
}

// Returns the clusters without their bounds. A range that has more than most_in_cluster marks has marks that are all
// alike, so it may be divided anywhere.
[[nodiscard]] base::Array<Cluster> cut_ranges(const Layer& layer, const SortedMarks& sorted,
                                              const ClusterRanges& ranges, const base::Array<NormalVariation>& turn) {
    base::Array<Cluster> clusters(turn.memory());
    std::int64_t blocks = 0;
    for (const ClusterRange& range : ranges.cluster)
        for (std::int64_t begin = range.begin; begin < range.end; begin += most_in_cluster) {
            Cluster cluster;
            cluster.count = static_cast<std::int32_t>(std::min(range.end - begin, most_in_cluster));
            cluster.direction = layer.has_strokes() ? layer.direction_of(sorted.order[begin].mark) : 0U;
            cluster.block = std::exchange(blocks, blocks + (cluster.count + MarkBlock::size - 1) / MarkBlock::size);
            static_cast<NormalVariation&>(cluster) = range.fit >= 0 ? turn[range.fit] : unknown_variation;
            clusters.push_back(cluster);
        }
    return clusters;
}

void sort_by_rank(const Layer& layer, KeyedMark* begin, KeyedMark* end) {
    std::sort(begin, end, [&](const KeyedMark& a, const KeyedMark& b) {
        const float u = layer.rank[a.mark];
        const float v = layer.rank[b.mark];
        return u != v ? u > v : a.mark < b.mark;
    });
}

// Copies the marks of a cluster into its blocks. Its first mark is sorted.order[from].
void fill_blocks(const SortedMarks& sorted, const Cluster& cluster, std::int64_t from, MarkClusters& result) noexcept {
    constexpr std::int64_t size = MarkBlock::size;
    const Layer& layer = sorted.layer;
    for (std::int64_t i = 0; i < cluster.count; ++i) {
        const std::uint32_t mark = sorted.order[from + i].mark;
        MarkBlock& block = result.block[cluster.block + i / size];
        block.set(i % size, sorted.place(from + i), vector_at(layer.normal, mark));
        block.rank[i % size] = layer.rank[mark];
        block.mark[i % size] = mark;
        if (!layer.width.empty()) result.width[cluster.block * size + i] = layer.width[mark];
    }
}

void find_clusters(const base::Work& work, const Layer& layer, double unit, MarkClusters& result) {
    SortedMarks sorted{layer, unit, sorted_along_curve(work, layer, unit)};
    ClusterRanges ranges(work.memory);
    for (std::int64_t begin = 0; begin < layer.count();) {
        KeyRange side{begin, end_of_key(sorted, begin, layer.count(), 3 * cell_bits), 3 * cell_bits};
        split_by_key(sorted, side, nullptr, ranges, work);
        begin = side.end;
    }
    result.cluster = cut_ranges(layer, sorted, ranges, fit_ranges(work, sorted, ranges.fit));
    work.for_chunks(ranges.cluster.size(), ranges_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t k = begin; k < end; ++k)
            sort_by_rank(layer, sorted.order.data() + ranges.cluster[k].begin,
                         sorted.order.data() + ranges.cluster[k].end);
    });
    base::Array<std::int64_t> first(work.memory, result.cluster.size()); // the index of each cluster's first mark
    std::int64_t marks = 0;
    std::int64_t blocks = 0;
    for (std::int64_t c = 0; c < first.size(); ++c) {
        first[c] = std::exchange(marks, marks + result.cluster[c].count);
        blocks = result.cluster[c].block + (result.cluster[c].count + MarkBlock::size - 1) / MarkBlock::size;
    }
    HRBFNPR_ASSERT(marks == layer.count());
    base::resize_long(result.block, blocks, work);
    if (!layer.width.empty()) base::resize_long(result.width, blocks * MarkBlock::size, work);
    work.for_chunks(first.size(), ranges_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t c = begin; c < end; ++c) {
            set_extent(
                result.cluster[c], first[c], first[c] + result.cluster[c].count,
                [&](std::int64_t i) { return sorted.place(i); }, [&](std::int64_t i) { return sorted.normal(i); });
            fill_blocks(sorted, result.cluster[c], first[c], result);
        }
    });
}

void cut_strokes(const base::Work& work, const Layer& layer, double unit, base::Array<StrokePiece>& pieces) {
    for (const std::int64_t s : work.over(layer.strokes())) {
        const std::int64_t end = layer.stroke_first[s + 1];
        for (std::int64_t first = layer.stroke_first[s]; first < end; first += StrokePiece::most) {
            StrokePiece piece;
            piece.first = static_cast<std::uint32_t>(first);
            piece.count = static_cast<std::uint8_t>(std::min(end - first, StrokePiece::most));
            base::push_back_long(pieces, piece, work);
        }
    }
    const float* const tone_normal = layer.tone_normal.empty() ? layer.normal.data() : layer.tone_normal.data();
    work.for_chunks(pieces.size(), ranges_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t k = begin; k < end; ++k) {
            StrokePiece& piece = pieces[k];
            piece.level = layer.level[layer.mark_of(piece.first)];
            for (std::int64_t i = 1; i < piece.count; ++i)
                piece.level = std::min(piece.level, layer.level[layer.mark_of(piece.first + i)]);
            set_extent(piece, layer, layer.position.data(), layer.normal.data(), tone_normal, unit);
        }
    });
}

// ---- Gaps between nested lines

constexpr std::size_t most_lines = 64; // the largest number of lines beside a mark
constexpr std::int64_t strokes_a_task = 16;

// Returns the gap around a mark, in separations: the mean distance between neighbouring lines there. Each mark on this
// mark's line or on a line beside it has an offset across the line. The gap is the weighted mean of the differences
// between consecutive offsets; nearer differences have more weight. The gap is 1 if there is no other line beside the
// mark. `place` has the positions of the marks in the order of the grid.
float gap_around(const Layer& layer, const geometry::PointGrid& grid, const geometry::VecArray& place,
                 std::int64_t mark) noexcept {
    const glm::dvec3 own(vector_at(layer.position, mark));
    const glm::dvec3 n = vector_at(layer.normal, mark);
    const glm::dvec3 along = vector_at(layer.direction, mark);
    const glm::dvec3 across = glm::cross(n, along);
    std::array<double, most_lines> offset;
    std::size_t count = 0;
    // Most marks are outside the strip. They are rejected without a division, by a slightly wider strip.
    const double strip = 1.001 * marks_tuning.strip_half_width * layer.report.step;
    grid.around(own, [&](std::int64_t at) {
        const glm::dvec3 from_own = place[at] - own;
        if (!(std::abs(glm::dot(from_own, along)) < strip)) return;
        const glm::dvec3 way = from_own / layer.report.step;
        const double u = glm::dot(way, across);
        // Comparisons are false for NaN, so a mark with NaN is not beside any mark.
        if (count < most_lines && std::abs(u) < marks_tuning.gap_reach &&
            std::abs(glm::dot(way, along)) < marks_tuning.strip_half_width &&
            std::abs(glm::dot(way, n)) < marks_tuning.gap_steepest * std::abs(u) + 0.1 &&
            glm::dot(n, glm::dvec3(vector_at(layer.normal, grid.index(at)))) > marks_tuning.gap_cosine)
            offset[count++] = u;
    });
    std::sort(offset.begin(), offset.begin() + static_cast<std::ptrdiff_t>(count));
    double sum = 0.0;
    double weights = 0.0;
    double last = count > 0 ? offset[0] : 0.0;
    for (std::size_t i = 1; i < count; ++i) {
        const double here = offset[i];
        if (here - last < marks_tuning.same_line) continue;
        const double at = 0.5 * (last + here) / marks_tuning.gap_reach;
        const double weight = (1.0 - at * at) * (1.0 - at * at);
        sum += weight * std::min(here - last, marks_tuning.widest_gap);
        weights += weight;
        last = here;
    }
    return weights > 0.0 ? static_cast<float>(sum / weights) : 1.0F;
}

// Computes the gap of each mark of the layer, in separations. The gap is the distance between the lines around the
// mark. It is averaged over some of these lines and along the mark's own line, because the tone depends on the share of
// paper that each line has. `gap` stays empty if the layer has no lines with a known separation.
void measure_gaps(const base::Work& work, const Layer& layer, base::Array<float>& gap) {
    gap.clear();
    // Published strokes keep no distance from each other: the step in their report is not a distance between strokes.
    const bool nested = layer.kind == Kind::own || (layer.kind == Kind::hatch && layer.progressive);
    if (!nested || layer.strokes() <= 1 || !(layer.report.step > 0.0)) return;
    HRBFNPR_ASSERT(layer.direction.size() == 3 * layer.count());
    const std::int64_t marks = layer.count();
    geometry::VecArray place(work.memory, marks);
    for (std::int64_t i = 0; i < marks; ++i) place.set(i, glm::dvec3(vector_at(layer.position, i)));
    const geometry::PointGrid grid(place, marks_tuning.gap_reach * layer.report.step, work);
    const geometry::VecArray ordered = grid.in_order(place, work);
    // The separation may come from a file, and may be far too large. So the neighbours of some marks are counted first.
    // If each mark has too many, gaps are not measured, because that would take too long.
    const std::int64_t sample = std::max<std::int64_t>(marks / 32, 1);
    std::int64_t visits = 0;
    for (std::int64_t i = 0; i < marks; i += sample) grid.around(place[i], [&](std::int64_t) { ++visits; });
    if (visits > marks_tuning.most_neighbours * (marks / sample)) return;
    gap.resize(marks);
    work.for_chunks(layer.strokes(), strokes_a_task, [&](std::int64_t begin, std::int64_t end) {
        base::Array<float> measured(work.memory);
        const auto averaged = [&](std::int64_t k) {
            const std::int64_t reach = std::min({marks_tuning.averaged_measurements, k, measured.size() - 1 - k});
            float sum = 0.0F;
            for (std::int64_t i = k - reach; i <= k + reach; ++i) sum += measured[i];
            return sum / static_cast<float>(2 * reach + 1);
        };
        for (std::int64_t s = begin; s < end; ++s) {
            work.check();
            const std::int64_t first = layer.stroke_first[s];
            const std::int64_t count = std::int64_t{layer.stroke_first[s + 1]} - first;
            measured.clear();
            for (std::int64_t i = 0; i < count; i += marks_tuning.marks_per_measurement)
                measured.push_back(gap_around(layer, grid, ordered, layer.mark_of(first + i)));
            for (std::int64_t i = 0; i < count; ++i) {
                const std::int64_t k = i / marks_tuning.marks_per_measurement;
                const float t = static_cast<float>(i % marks_tuning.marks_per_measurement) /
                                static_cast<float>(marks_tuning.marks_per_measurement);
                gap[layer.mark_of(first + i)] =
                    std::lerp(averaged(k), averaged(std::min(k + 1, measured.size() - 1)), t);
            }
        }
    });
}

// ---- Clusters that moved

void copy_clusters(const MarkClusters& from, MarkClusters& to) {
    copy_arrays(from, to, &MarkClusters::block, &MarkClusters::width, &MarkClusters::cluster, &MarkClusters::piece);
}

// Returns the nearer of the two clusters before and after cluster c. A cluster is taken only if it has enough marks and
// faces nearly the same side as cluster c. Returns null if neither cluster is taken.
const Cluster* nearest_with_variation(const base::Array<Cluster>& clusters, std::int64_t c) noexcept {
    const Cluster& own = clusters[c];
    const auto vector = [](const std::array<float, 3>& a) { return glm::vec3(a[0], a[1], a[2]); };
    const auto square = [&](const Cluster& other) {
        const glm::vec3 way = vector(own.centre) - vector(other.centre);
        return glm::dot(way, way);
    };
    const Cluster* nearest = nullptr;
    for (const std::int64_t k : {c - 1, c + 1}) {
        if (k < 0 || k >= clusters.size() || clusters[k].count < marks_tuning.fewest_to_fit) continue;
        if (glm::dot(vector(clusters[k].cone.axis), vector(own.cone.axis)) > marks_tuning.neighbour_cosine &&
            (nearest == nullptr || square(clusters[k]) < square(*nearest)))
            nearest = &clusters[k];
    }
    return nearest;
}

} // namespace

std::int64_t MarkClusters::bytes() const noexcept {
    return block.bytes() + width.bytes() + cluster.bytes() + piece.bytes() + gap.bytes();
}

void cluster_marks(const base::Work& work, PointSet& set) {
    float largest = 0.0F;
    for (const Layer& layer : set.layers)
        for (const float coordinate : layer.position) largest = std::max(largest, std::abs(coordinate));
    set.unit = geometry::unit_for(double{largest});
    for (Layer& layer : set.layers) {
        HRBFNPR_ASSERT(layer.position.size() == 3 * layer.count() && layer.normal.size() == 3 * layer.count());
        layer.clusters = MarkClusters(work.memory);
        if (layer.count() > 0) find_clusters(work, layer, set.unit, layer.clusters);
        cut_strokes(work, layer, set.unit, layer.clusters.piece);
        measure_gaps(work, layer, layer.clusters.gap);
    }
}

void move_clusters(const Layer& layer, const float* position, const float* normal, double unit, MarkClusters& moved) {
    HRBFNPR_ASSERT(unit > 0.0);
    copy_clusters(layer.clusters, moved);
    for (const Cluster& cluster : moved.cluster)
        for (std::int64_t i = 0; i < cluster.count; ++i) {
            MarkBlock& block = moved.block[cluster.block + i / MarkBlock::size];
            const std::int64_t at = i % MarkBlock::size;
            const float* const p = position + 3 * std::int64_t{block.mark[at]};
            const float* const n = normal + 3 * std::int64_t{block.mark[at]};
            block.set(at, glm::dvec3(p[0], p[1], p[2]) / unit, {n[0], n[1], n[2]});
        }
    // The normals for tone of a moved set are unknown, because they turn with the marks' directions, too.
    const float* const tone_normal = layer.tone_normal.empty() ? normal : nullptr;
    for (StrokePiece& piece : moved.piece) set_extent(piece, layer, position, normal, tone_normal, unit);
    const auto place_in = [&](std::int64_t slot) {
        return glm::dvec3(moved.block[slot / MarkBlock::size].place_at(slot % MarkBlock::size));
    };
    const auto normal_in = [&](std::int64_t slot) {
        return glm::dvec3(moved.block[slot / MarkBlock::size].normal_at(slot % MarkBlock::size));
    };
    for (Cluster& cluster : moved.cluster) {
        const std::int64_t begin = cluster.block * MarkBlock::size;
        const std::int64_t end = begin + cluster.count;
        set_extent(cluster, begin, end, place_in, normal_in);
        if (cluster.count >= marks_tuning.fewest_to_fit)
            static_cast<NormalVariation&>(cluster) = fit_normal_variation(begin, end, place_in, normal_in);
    }
    // A cluster with too few marks copies the variation of its normals from the nearer neighbour with enough marks.
    for (std::int64_t c = 0; c < moved.cluster.size(); ++c) {
        if (moved.cluster[c].count >= marks_tuning.fewest_to_fit) continue;
        const Cluster* const nearest = nearest_with_variation(moved.cluster, c);
        static_cast<NormalVariation&>(moved.cluster[c]) = nearest != nullptr ? *nearest : unknown_variation;
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
        negate(cluster.cone.axis);
        negate(cluster.shape);
    }
    for (StrokePiece& piece : turned.piece) {
        negate(piece.cone.axis);
        negate(piece.tone.axis);
    }
}

} // namespace hrbfnpr::marks
