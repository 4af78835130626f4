// SPDX-License-Identifier: MIT
#include "drawing/drawing.h"

#include "base/scratch.h"
#include "geometry/unit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hrbfnpr::drawing {
namespace {

constexpr std::int64_t keys_a_task = 16384;
constexpr unsigned digit_bits = 8;
constexpr std::int64_t digits = std::int64_t{1} << digit_bits;

[[nodiscard]] std::int64_t digit_of(std::uint64_t key, unsigned shift) noexcept {
    return static_cast<std::int64_t>(key >> shift & std::uint64_t{digits - 1});
}

[[nodiscard]] glm::vec3 unit_or_zero(const glm::vec3& v) noexcept {
    const float length = glm::length(v);
    return length > 0.0F ? v / length : glm::vec3(0.0F);
}

// Returns the linear part of a matrix, scaled so that floats can hold squares of the vectors that it transforms.
// Callers do not use the length of these vectors.
[[nodiscard]] glm::mat3 with_moderate_scale(const glm::dmat4& m) noexcept {
    const double scale = std::cbrt(std::abs(glm::determinant(glm::dmat3(m))));
    return glm::mat3(glm::dmat3(m) / geometry::unit_for(scale));
}

} // namespace

Counts& Counts::operator+=(const Counts& other) noexcept {
    for (std::int64_t Counts::*const field :
         {&Counts::marks, &Counts::outside, &Counts::front, &Counts::back, &Counts::silhouette, &Counts::shown,
          &Counts::dropped_tone, &Counts::dropped_depth, &Counts::dropped_zoom, &Counts::dropped_hidden,
          &Counts::splats, &Counts::culled})
        this->*field += other.*field;
    return *this;
}

Drawing::Drawing(base::Memory& memory) noexcept
    : layers(memory), dots(memory), dot_ranges(memory), strokes(memory), points(memory), splats(memory),
      splat_ranges(memory), dot_tiles(memory, tile_size), splat_tiles(memory, tile_size),
      segment_tiles(memory, tile_size), items(memory), runs(memory), posed_position(memory), posed_normal(memory),
      posed_direction(memory) {}

void Drawing::clear() noexcept {
    line_counts = {};
    counts = {};
    one_color = true;
    dot_count = 0;
    for_arrays(*this, [](auto& array) { array.clear(); });
}

std::int64_t Drawing::bytes() const noexcept {
    std::int64_t bytes = dot_tiles.bytes() + splat_tiles.bytes() + segment_tiles.bytes();
    for_arrays(*this, [&](const auto& array) { bytes += array.bytes(); });
    return bytes;
}

// A run without marks has the same first id as the next run. The search returns the last run with this id.
std::int64_t Drawing::place_of(std::uint32_t id) const noexcept {
    return std::upper_bound(runs.begin(), runs.end(), id,
                            [](std::uint32_t a, const Run& r) { return a < r.first_id; }) -
           runs.begin() - 1;
}

const Run* Drawing::run_of(std::uint32_t id) const noexcept {
    const std::int64_t place = place_of(id);
    return place >= 0 && id - runs[place].first_id < runs[place].count ? &runs[place] : nullptr;
}

Identity Drawing::identify(std::uint32_t id) const noexcept {
    HRBFNPR_ASSERT(run_of(id) != nullptr);
    const Run& run = runs[place_of(id)];
    const marks::Layer& layer = items[run.item].set->layers[run.layer];
    const std::int64_t mark = id - run.first_id;
    return {run.item, run.layer, mark, layer.stroke_of(mark), layer.has_strokes() ? layer.stroke[2 * mark + 1] : 0};
}

glm::vec3 Drawing::world(const glm::vec3& seen) const noexcept {
    const glm::dvec4 found = from_window * glm::dvec4(glm::dvec3(seen), 1.0);
    return glm::vec3(glm::dvec3(found) / found.w);
}

MarkSource Drawing::source(std::uint32_t id) const noexcept {
    HRBFNPR_ASSERT(run_of(id) != nullptr);
    const Run& run = runs[place_of(id)];
    const ItemSource& item = items[run.item];
    const marks::Layer& layer = item.set->layers[run.layer];
    const std::int64_t mark = id - run.first_id;
    const bool posed = run.posed >= 0;
    const auto vector = [&](const base::Array<float>& own, const base::Array<float>& given, bool moved) {
        return moved ? marks::vector_at(own, run.posed + mark) : marks::vector_at(given, mark);
    };
    const glm::vec3 place = vector(posed_position, layer.position, posed);
    const glm::vec3 normal = vector(posed_normal, layer.normal, posed);
    const glm::vec3 direction = vector(posed_direction, layer.direction, posed && run.poses_directions);
    MarkSource source;
    source.position = glm::vec3(item.to_world * glm::dvec4(glm::vec3(glm::dvec3(place) / item.unit), 1.0));
    source.normal = unit_or_zero(item.normal_to_world * normal);
    source.direction = unit_or_zero(with_moderate_scale(item.to_world) * direction);
    return source;
}

void bin_segments(const base::Parallel& parallel, Drawing& drawing) {
    const Tiles& like = drawing.dot_tiles;
    const std::array all = {IndexRange{0, std::max<std::int64_t>(drawing.points.size() - 1, 0)}};
    const glm::vec2 origin(drawing.first_pixel);
    const bool pointed = std::any_of(drawing.strokes.begin(), drawing.strokes.end(), [](const Stroke& stroke) {
        return stroke.cap_begin == Cap::pointed || stroke.cap_end == Cap::pointed;
    });
    drawing.segment_tiles.build(parallel, like.columns() * tile_size, like.rows() * tile_size, all,
                                [&](std::int64_t i, Tiles::Footprint& print) {
                                    const StrokePoint& a = drawing.points[i];
                                    const StrokePoint& b = drawing.points[i + 1];
                                    SegmentEnds ends;
                                    if (const bool may_begin = !(b.length > 0.0F); may_begin || pointed) {
                                        const Stroke& stroke = *stroke_of(drawing, i, drawing.strokes.begin());
                                        if (i + 1 == stroke.first + stroke.count)
                                            return false; // point b begins the next stroke
                                        if (pointed) ends = ends_of(stroke, i);
                                    }
                                    const float around = reach(ends, a, b);
                                    print = {
                                        std::min(a.x, b.x) - around - origin.x, std::min(a.y, b.y) - around - origin.y,
                                        std::max(a.x, b.x) + around - origin.x, std::max(a.y, b.y) + around - origin.y};
                                    return true;
                                });
}

void DepthSort::sort(const base::Parallel& parallel, base::Array<std::uint64_t>& keys) {
    base::resize_scratch(other_, keys.size());
    for (unsigned shift = 32; shift < 64; shift += digit_bits) {
        if (sort_by_digit(parallel, keys, other_, shift)) std::swap(keys, other_);
    }
}

// Sorts by one digit. Returns false, without writing to `to`, if all keys have the same digit.
bool DepthSort::sort_by_digit(const base::Parallel& parallel, const base::Array<std::uint64_t>& from,
                              base::Array<std::uint64_t>& to, unsigned shift) {
    HRBFNPR_ASSERT(to.size() == from.size());
    const std::int64_t count = from.size();
    const std::int64_t chunks = (count + keys_a_task - 1) / keys_a_task;
    base::resize_scratch(histogram_, chunks * digits);
    parallel.for_chunks(count, keys_a_task, [&](std::int64_t begin, std::int64_t end) {
        std::int64_t* const own = histogram_.data() + begin / keys_a_task * digits;
        std::fill(own, own + digits, std::int64_t{0});
        for (std::int64_t i = begin; i < end; ++i) ++own[digit_of(from[i], shift)];
    });
    std::int64_t total = 0;
    for (std::int64_t digit = 0; digit < digits; ++digit) {
        const std::int64_t before = total;
        for (std::int64_t chunk = 0; chunk < chunks; ++chunk)
            total += std::exchange(histogram_[chunk * digits + digit], total);
        if (total - before == count) return false;
    }
    parallel.for_chunks(count, keys_a_task, [&](std::int64_t begin, std::int64_t end) {
        std::int64_t* const own = histogram_.data() + begin / keys_a_task * digits;
        for (std::int64_t i = begin; i < end; ++i) to[own[digit_of(from[i], shift)]++] = from[i];
    });
    return true;
}

} // namespace hrbfnpr::drawing
