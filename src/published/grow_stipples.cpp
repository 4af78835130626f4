// SPDX-License-Identifier: MIT
#include "base/random.h"
#include "geometry/tangent_frame.h"
#include "published/growth.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::published {
namespace {

// As the article prints them.
constexpr std::int64_t children = 4;
constexpr double jitter = 0.125;

class Stipples {
public:
    Stipples(const marks::Site& site, const Start& start, const GrowthSettings& settings, marks::Marks& marks,
             marks::LayerReport& report)
        : site_(site), start_(start), settings_(settings), marks_(marks), report_(report), settler_(site),
          parent_(site.memory()), key_(site.memory()) {}

    // Returns whether the budget cut the level.
    bool place_seeds(const base::Progress& progress);
    bool refine(std::int32_t level, double rho, const base::Progress& progress);

private:
    void reserve(std::int64_t count, const base::Progress& progress) {
        make_room(count, progress, marks_.position, marks_.normal, marks_.key, marks_.stroke, marks_.place,
                  marks_.level);
    }
    // Where a child starts: (i r + j u) rho in the parent's tangent plane, i and j = +-1 + U(-1/8, 1/8),
    // drawn for each child.                                                        [NPAR 5.2]
    [[nodiscard]] glm::dvec3 offset(std::int64_t parent, std::int64_t child, std::uint64_t key) const noexcept {
        const auto u = base::uniform4(site_.random_seed, key, base::Purpose::stipple_jitter);
        const double i = (child & 1) != 0 ? 1.0 : -1.0;
        const double j = (child & 2) != 0 ? 1.0 : -1.0;
        const geometry::TangentFrame frame = geometry::stipple_frame(marks_.normal[parent]);
        return (i + jitter * (2.0 * u[0] - 1.0)) * frame.r + (j + jitter * (2.0 * u[1] - 1.0)) * frame.u;
    }

    const marks::Site& site_;
    const Start& start_;
    const GrowthSettings& settings_;
    marks::Marks& marks_;
    marks::LayerReport& report_;
    marks::Settler settler_;
    base::Array<std::int64_t> parent_; // the mark that each start of the chunk comes from
    base::Array<std::uint64_t> key_;
    std::uint64_t full_count_ = 0; // marks before this level, had none been dropped
};

bool Stipples::place_seeds(const base::Progress& progress) {
    const std::int64_t count = start_.position.size();
    const std::int64_t room = settings_.budget > 0 ? settings_.budget : count;
    const marks::Thinning thinning(
        site_, count, room, marks::stream_of(marks::Kind::stipples),
        [](std::int64_t i) { return static_cast<std::uint64_t>(i); }, progress);
    reserve(std::min(room, count), progress);
    for (std::int64_t i = 0; i < count; ++i) {
        if (i % marks::chunk_size == 0) progress.check();
        if (!thinning.keeps(static_cast<std::uint64_t>(i))) continue;
        marks_.position.push_back(start_.position[i]);
        marks_.normal.push_back(start_.normal[i]);
        marks_.key.push_back(static_cast<std::uint64_t>(i));
        marks_.stroke.push_back(static_cast<std::uint32_t>(i));
        marks_.place.push_back(0);
        marks_.level.push_back(0);
    }
    marks::LevelReport& level = report_.of(0);
    level.attempted = count;
    level.placed = marks_.count();
    level.dropped_budget = count - marks_.count();
    full_count_ = static_cast<std::uint64_t>(count);
    return thinning.active();
}

// The mark `key` of a full tree of n marks has the children n + 4 key + {0, 1, 2, 3}.
bool Stipples::refine(std::int32_t level, double rho, const base::Progress& progress) {
    HRBFNPR_ASSERT(level > 0 && rho > 0.0);
    marks::LevelReport& report = report_.of(level);
    const std::int64_t parents = marks_.count();
    const std::int64_t room =
        settings_.budget > 0 ? std::max<std::int64_t>(0, settings_.budget - parents) : children * parents;
    const auto key_of = [&](std::int64_t i) {
        return full_count_ + 4 * marks_.key[i / children] + static_cast<std::uint64_t>(i % children);
    };
    const marks::Thinning thinning(site_, children * parents, room, marks::stream_of(marks::Kind::stipples), key_of,
                                   progress);
    reserve(parents + std::min(room, children * parents), progress);
    constexpr std::int64_t parents_of_chunk = marks::chunk_size / children;
    // No start is farther from its parent than this. A child that lands farther from its start than its start is from
    // the parent belongs to another part of the surface.
    const double stray_limit = std::sqrt(2.0) * (1.0 + jitter) * rho;
    for (std::int64_t begin = 0; begin < parents; begin += parents_of_chunk) {
        const std::int64_t end = std::min(parents, begin + parents_of_chunk);
        settler_.start.clear();
        parent_.clear();
        key_.clear();
        for (std::int64_t parent = begin; parent < end; ++parent)
            for (std::int64_t child = 0; child < children; ++child) {
                const std::uint64_t key = key_of(children * parent + child);
                if (!thinning.keeps(key)) {
                    ++report.attempted;
                    ++report.dropped_budget;
                    continue;
                }
                settler_.start.push_back(marks_.position[parent] + rho * offset(parent, child, key));
                parent_.push_back(parent);
                key_.push_back(key);
            }
        const auto all = static_cast<double>(parents);
        settler_.settle(stray_limit, report,
                        progress.part(static_cast<double>(begin) / all, static_cast<double>(end) / all));
        for (std::int64_t i = 0; i < settler_.start.size(); ++i) {
            if (!settler_.placed(i)) continue;
            marks_.position.push_back(settler_.position(i));
            marks_.normal.push_back(settler_.normal(i));
            marks_.key.push_back(key_[i]);
            marks_.stroke.push_back(marks_.stroke[parent_[i]]);
            marks_.place.push_back(0);
            marks_.level.push_back(static_cast<std::uint8_t>(level));
        }
    }
    full_count_ *= 1 + static_cast<std::uint64_t>(children);
    return thinning.active();
}

} // namespace

void grow_stipples(const marks::Site& site, const Start& start, const GrowthSettings& settings, marks::Marks& marks,
                   marks::LayerReport& report, const base::Progress& progress) {
    report.full_count = marks::grown_count(start.full_count, 1 + children, settings.levels);
    report.step = settings.step;
    marks::require_room(settings.layer, marks::grown_count(start.position.size(), 1 + children, settings.levels),
                        settings.levels, settings.budget);
    Stipples stipples(site, start, settings, marks, report);
    const bool full = stipples.place_seeds(progress);
    refine_levels(
        settings, 1 + children, full, report, progress,
        [&](std::int32_t level, double rho, const base::Progress& part) { return stipples.refine(level, rho, part); });
}

} // namespace hrbfnpr::published
