// The marks on a surface: immutable once made, structure of arrays.
#pragma once

#include "base/memory.h"
#include "geometry/vec.h"
#include "marks/mark_clusters.h"

#include <array>
#include <cstdint>

namespace hrbfnpr::marks {

// Same numbers as HRBFNPR_GROUP_..., HRBFNPR_DISTRIBUTION_..., HRBFNPR_STROKE_FIELD_..., HRBFNPR_SEED_...
enum class Group : std::uint32_t { stipple = 0, curvature = 1, combing = 2 };
inline constexpr int group_count = 3;
enum class Distribution : std::uint32_t { blue_noise = 0, published = 1 };
enum class StrokeField : std::uint32_t { line = 0, cross = 1 };
enum class SeedSource : std::uint32_t { automatic = 0, samples = 1, box = 2, points = 3 };

inline constexpr int most_levels = 12;

// What became of the candidates: attempted = placed + the dropped ones.
struct LevelReport {
    std::int64_t attempted = 0;
    std::int64_t placed = 0;
    std::int64_t dropped_not_converged = 0;
    std::int64_t dropped_strayed = 0;
    std::int64_t dropped_degenerate = 0;
    std::int64_t dropped_budget = 0;
};

struct GroupReport {
    std::int64_t strokes = 0;
    std::int64_t full_count = 0;
    std::int32_t levels = 0;
    double step = 0.0;
    double seconds = 0.0;
    std::array<LevelReport, most_levels + 1> level{};
};

// Of an array of 3n.
[[nodiscard]] inline glm::vec3 vector_at(const base::Array<float>& array, std::int64_t i) noexcept {
    return {array[3 * i], array[3 * i + 1], array[3 * i + 2]};
}

// Types, shapes and meaning of each array: HRBFNPR_ATTRIBUTE_... in hrbfnpr.h.
struct MarkGroup {
    explicit MarkGroup(base::Memory& memory) noexcept
        : position(memory), normal(memory), direction(memory), curvature(memory), rank(memory), level(memory),
          stroke(memory), width(memory), clusters(memory) {}

    base::Array<float> position;       // 3n, relative to the set's origin
    base::Array<float> normal;         // 3n
    base::Array<float> direction;      // 3n
    base::Array<float> curvature;      // 3n, or empty
    base::Array<float> rank;           // n
    base::Array<std::uint8_t> level;   // n
    base::Array<std::uint32_t> stroke; // 2n
    base::Array<float> width;          // n, or empty: all 1
    MarkClusters clusters;             // of all marks, by cluster_marks()
    GroupReport report;

    [[nodiscard]] std::int64_t count() const noexcept { return rank.size(); }
    [[nodiscard]] std::int64_t bytes() const noexcept;
};

struct PointSet {
    explicit PointSet(base::Memory& memory) noexcept : group{MarkGroup(memory), MarkGroup(memory), MarkGroup(memory)} {}

    Distribution distribution = Distribution::published;
    SeedSource seed_source = SeedSource::points;
    glm::dvec3 origin{0.0};
    geometry::Bounds bounds; // of all marks, absolute
    double spacing = 0.0;
    double unit = 1.0; // of lengths in the clusters: a power of two, by cluster_marks()
    LevelReport seeds;
    double seconds_seeds = 0.0;
    double seconds_total = 0.0;
    std::array<MarkGroup, group_count> group;

    [[nodiscard]] std::int64_t bytes() const noexcept;
};

} // namespace hrbfnpr::marks
