// SPDX-License-Identifier: MIT
// The marks on a surface, in layers. A set does not change once it is made. Marks are stored as structures of arrays.
#pragma once

#include "base/assert.h"
#include "base/list.h"
#include "base/operation.h"
#include "base/work.h"
#include "geometry/vec.h"
#include "paint/kind.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace hrbfnpr::marks {

// The values equal those of the constants HRBFNPR_LAYER_KIND, HRBFNPR_DISTRIBUTION and HRBFNPR_SEED.
enum class Kind : std::uint32_t { any = 0, stipples = 1, hatch = 2, own = 3 };
inline constexpr std::uint32_t kind_count = 4;
enum class Distribution : std::uint32_t { blue_noise = 0, published = 1 };
enum class SeedSource : std::uint32_t { automatic = 0, samples = 1, box = 2, points = 3 };

// The article's recursion has at most this many levels.
inline constexpr int most_levels = 12;
// The largest number of layers. A longer list is regarded as a mistake: an array of marks was given as layers.
inline constexpr std::int64_t most_layers = 65536;

// A name in zero-terminated UTF-8.
using LayerName = std::array<char, 64>;
// Returns the name that an unnamed layer of this kind gets, such as "stipples"; empty for Kind::any.
[[nodiscard]] LayerName default_name(Kind kind) noexcept;

// The counts of candidates at a level: attempted = placed + the sum of all dropped candidates.
struct LevelReport {
    std::int64_t attempted = 0;
    std::int64_t placed = 0;
    std::int64_t dropped_not_converged = 0;
    std::int64_t dropped_strayed = 0;
    std::int64_t dropped_degenerate = 0;
    std::int64_t dropped_budget = 0;
};

struct LayerReport {
    explicit LayerReport(base::Memory& memory) noexcept : level(memory) {}

    std::int64_t full_count = 0;
    std::int32_t levels = 0;
    double step = 0.0;
    double seconds = 0.0;
    base::Array<LevelReport> level; // indexed by level; a missing level has no candidates

    // Returns the report of a level. Missing levels up to it are added.
    [[nodiscard]] LevelReport& of(std::int32_t number) {
        if (level.size() <= number) level.resize(std::int64_t{number} + 1);
        return level[number];
    }
};

// Returns a rank in [0,1). Rounding u to a float must not give 1.
[[nodiscard]] inline float rank_of(double u) noexcept {
    constexpr float below_one = 0x1.fffffep-1F;
    return std::min(static_cast<float>(u), below_one);
}

// The range of tones in which a layer of marks appears, from the darkness at which its first mark is shown to the
// darkness at which all its marks are shown.
struct TonePart {
    double begin = 0.0;
    double end = 1.0;

    [[nodiscard]] double length() const noexcept { return end - begin; }
    [[nodiscard]] float rank(float own) const noexcept {
        if (begin == 0.0 && end == 1.0) return own;
        return rank_of(1.0 - begin - (1.0 - static_cast<double>(own)) * length());
    }
};

// Read and write vectors in arrays of 3n floats.
inline void set_vector(base::Array<float>& array, std::int64_t i, const glm::dvec3& v) noexcept {
    HRBFNPR_ASSERT(i >= 0 && 3 * i + 2 < array.size());
    for (int axis = 0; axis < 3; ++axis) array[3 * i + axis] = static_cast<float>(v[axis]);
}
[[nodiscard]] inline glm::vec3 vector_at(const base::Array<float>& array, std::int64_t i) noexcept {
    return {array[3 * i], array[3 * i + 1], array[3 * i + 2]};
}

// Copies an array into the memory of `to`, if that is large enough.
template <class T>
void copy_array(const base::Array<T>& from, base::Array<T>& to) {
    static_assert(std::is_trivially_copyable_v<T>);
    to.resize_for_overwrite(from.size());
    if (!from.empty())
        std::memcpy(static_cast<void*>(to.data()), from.data(), sizeof(T) * static_cast<std::size_t>(from.size()));
}

// ---- Clusters: groups of marks with similar places and normals, in the order in which a tone shows them. A frame can
// skip whole groups.

// Sixteen marks. Each array of sixteen numbers fills a cache line.
struct MarkBlock {
    static constexpr std::int64_t size = 16;
    float x[size], y[size], z[size]; // relative to the origin of the set, in the unit of the set
    float nx[size], ny[size], nz[size];
    float rank[size];         // in descending order within a block, and from block to block of a cluster
    std::uint32_t mark[size]; // indices of the marks in the layer

    [[nodiscard]] glm::vec3 place_at(std::int64_t i) const noexcept { return {x[i], y[i], z[i]}; }
    [[nodiscard]] glm::vec3 normal_at(std::int64_t i) const noexcept { return {nx[i], ny[i], nz[i]}; }
    void set(std::int64_t i, const glm::vec3& place, const glm::vec3& normal) noexcept {
        x[i] = place.x;
        y[i] = place.y;
        z[i] = place.z;
        nx[i] = normal.x;
        ny[i] = normal.y;
        nz[i] = normal.z;
    }
};

// The set of directions whose angle with the axis is at most the cone's half angle.
struct Cone {
    std::array<float, 3> axis{};
    float cosine = 1.0F, sine = 0.0F; // the cosine and sine of the half angle
};

// How normals turn along a surface.
struct NormalVariation {
    float max_curvature = 0.0F; // the largest absolute normal curvature; negative if unknown
    // The derivative of the normal with respect to the place, as a symmetric matrix: xx, xy, xz, yy, yz, zz. If normals
    // point outward, the matrix is positive where the surface is convex.
    std::array<float, 6> shape{};
};

// The bounds of the places and normals of some marks. Lengths and curvatures are in the unit of the set.
struct Extent {
    float radius = 0.0F; // radius of the ball around the centre that contains all marks
    std::array<float, 3> centre{};
    Cone cone; // contains all normals
};

struct Cluster : Extent, NormalVariation {
    std::int64_t block = 0;      // the index of its first block; its last block may be partly empty
    std::int32_t count = 0;      // the number of marks
    std::uint32_t direction = 0; // the direction (0 or 1) of the strokes of its marks; 0 if there are no strokes
};

// Consecutive marks of a stroke. The pieces of all strokes are stored in order. A stroke of n marks has pieces_of(n)
// pieces.
struct StrokePiece : Extent {
    static constexpr std::int64_t most = 32;
    Cone tone;               // contains all normals for tone, which may lie outside the cone of normals
    std::uint32_t first = 0; // the position of its first mark in the order of the strokes
    std::uint8_t count = 0;
    std::uint8_t level = 0; // the lowest level among its marks
};

[[nodiscard]] constexpr std::int64_t pieces_of(std::int64_t marks) noexcept {
    return (marks + StrokePiece::most - 1) / StrokePiece::most;
}

struct MarkClusters {
    explicit MarkClusters(base::Memory& memory) noexcept
        : block(memory), width(memory), cluster(memory), piece(memory), gap(memory) {}

    base::Array<MarkBlock> block;
    base::Array<float> width; // the width of each mark, in the order of the blocks; empty if all are 1
    base::Array<Cluster> cluster;
    base::Array<StrokePiece> piece; // the pieces of all strokes
    base::Array<float> gap;         // the gap of each mark, in separations, as measure_gaps() computes it; or empty

    [[nodiscard]] std::int64_t bytes() const noexcept;
};

inline constexpr std::int64_t most_in_cluster = 128;

// ---- Layers and sets

using paint::components_of;
using paint::FieldKind;
inline constexpr std::int64_t most_fields = 64; // the largest number of fields of a set

// The values of a field at the marks of a layer. Directions are in the coordinates of the set.
struct MarkField {
    explicit MarkField(base::Memory& memory) noexcept : value(memory), weight(memory) {}

    LayerName name{};
    FieldKind kind = FieldKind::scalar;
    base::Array<float> value;  // components_of(kind) numbers for each mark
    base::Array<float> weight; // from 0 to 1 for each mark; empty if all are 1

    [[nodiscard]] std::int64_t bytes() const noexcept { return value.bytes() + weight.bytes(); }
};

// Copies the given array members of an object.
template <class Owner, class... Members>
void copy_arrays(const Owner& from, Owner& to, Members... member) {
    (copy_array(from.*member, to.*member), ...);
}

// hrbfnpr.h documents the type, shape and meaning of each array at its HRBFNPR_MARK_ATTRIBUTE constants.
struct Layer {
    explicit Layer(base::Memory& memory, Kind is = Kind::own) noexcept
        : kind(is), name(default_name(is)), position(memory), normal(memory), direction(memory), curvature(memory),
          rank(memory), level(memory), stroke(memory), width(memory), tone_normal(memory), stroke_first(memory),
          stroke_order(memory), clusters(memory), fields(memory), report(memory) {}

    Kind kind;
    LayerName name;
    bool progressive = false;     // true if each prefix of the marks in descending order of rank is evenly spread
    base::Array<float> position;  // 3n numbers, relative to the origin of the set
    base::Array<float> normal;    // 3n numbers
    base::Array<float> direction; // 3n numbers
    base::Array<float> curvature; // 3n numbers, or empty
    base::Array<float> rank;      // n numbers
    // n numbers: the level of the recursion, or of nested hatching, at which each mark was added
    base::Array<std::uint8_t> level;
    base::Array<std::uint32_t> stroke; // 2n numbers
    base::Array<float> width;          // n numbers; empty if all are 1
    base::Array<float> tone_normal;    // 3n numbers; empty if they equal `normal`
    // For s strokes, s + 1 numbers: where each stroke begins in the order of the strokes, and the number of marks.
    // Empty if there are no strokes.
    base::Array<std::uint32_t> stroke_first;
    base::Array<std::uint32_t> stroke_order; // n numbers; empty if the marks are stored stroke by stroke
    MarkClusters clusters;                   // the clusters of the marks, which cluster_marks() makes
    base::List<MarkField> fields;            // fields with values for these marks; each has another name
    LayerReport report;
    // The number of marks that the whole surface would have, if only those that one camera needs were placed. 0: all
    // were placed.
    std::int64_t whole = 0;
    double tone_begin = 0.0; // If marks are missing: the darkness at which the first mark is shown.

    [[nodiscard]] std::int64_t count() const noexcept { return rank.size(); }
    // Returns the number of marks on the whole surface. The tone follows from this number.
    [[nodiscard]] std::int64_t whole_count() const noexcept { return whole > 0 ? whole : count(); }
    [[nodiscard]] std::int64_t bytes() const noexcept;

    [[nodiscard]] bool has_strokes() const noexcept { return !stroke_first.empty(); }
    [[nodiscard]] std::int64_t strokes() const noexcept { return has_strokes() ? stroke_first.size() - 1 : 0; }
    // Returns the index of the mark at a position in the order of the strokes.
    [[nodiscard]] std::int64_t mark_of(std::int64_t place_in_order) const noexcept {
        return stroke_order.empty() ? place_in_order : std::int64_t{stroke_order[place_in_order]};
    }
    // Returns the field of this name, or NULL.
    [[nodiscard]] const MarkField* field_of(const char* wanted) const noexcept;
    // Returns the index of the stroke that a mark belongs to, or -1.
    [[nodiscard]] std::int64_t stroke_of(std::int64_t mark) const noexcept;
    // Returns the direction of a mark's stroke, 0 or 1. The layer must have strokes.
    [[nodiscard]] std::uint32_t direction_of(std::int64_t mark) const noexcept { return stroke[2 * mark] & 1U; }
};

struct PointSet {
    explicit PointSet(base::Memory& memory) noexcept : layers(memory), still(memory) {}

    Distribution distribution = Distribution::published;
    SeedSource seed_source = SeedSource::points;
    glm::dvec3 origin{0.0};
    geometry::Bounds bounds; // the box around all marks, in absolute coordinates
    double spacing = 0.0;
    double unit = 1.0; // the unit of length of the clusters, a power of two that cluster_marks() chooses
    LevelReport seeds;
    double seconds_seeds = 0.0;
    double seconds_total = 0.0;
    base::List<Layer> layers;
    // The numbers of the only drawing that the marks are for, see frame::still_key(). Empty: any drawing.
    base::Array<double> still;

    [[nodiscard]] std::int64_t bytes() const noexcept;
    [[nodiscard]] std::int64_t count() const noexcept; // the number of marks
    // Returns the number of marks that the largest layer has on the whole surface.
    [[nodiscard]] std::int64_t largest() const noexcept;
};

// Fills stroke_first and stroke_order from `stroke`. Strokes are sorted by their numbers.
void index_strokes(Layer& layer, const base::Progress& progress = {});

// Fills set.unit and the clusters of all layers. Numbers may have any finite size. The result has the same bits for any
// number of threads.
void cluster_marks(const base::Work& work, PointSet& set);

// Fills `moved` with the clusters of the layer, but with the marks at other places, for example on an animated surface.
// `position` (relative to the set's origin) and `normal` have three floats for each mark. `unit` is the unit of the
// set. Allocates nothing if `moved` had at least as many marks before.
void move_clusters(const Layer& layer, const float* position, const float* normal, double unit, MarkClusters& moved);

// Fills `turned` with the given clusters, but with opposite normals. Allocates nothing if `turned` had at least as many
// marks before.
void turn_clusters(const MarkClusters& clusters, MarkClusters& turned);

} // namespace hrbfnpr::marks
