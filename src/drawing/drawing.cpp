// SPDX-License-Identifier: MIT
#include "drawing/drawing.h"

#include "geometry/unit.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::drawing {
namespace {

[[nodiscard]] glm::vec3 unit_or_zero(const glm::vec3& v) noexcept {
    const float length = glm::length(v);
    return length > 0.0F ? v / length : glm::vec3(0.0F);
}

// The linear part, so that squares of what it gives are floats: lengths do not matter.
[[nodiscard]] glm::mat3 of_moderate_scale(const glm::dmat4& m) noexcept {
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
    : layers(memory), dots(memory), dot_pieces(memory), strokes(memory), points(memory), splats(memory),
      splat_pieces(memory), dot_tiles(memory, tile_size), splat_tiles(memory, tile_size),
      segment_tiles(memory, tile_size), items(memory), runs(memory), posed_position(memory), posed_normal(memory),
      posed_direction(memory) {}

void Drawing::clear() noexcept {
    line_counts = LineCounts{};
    counts = {};
    one_color = true;
    dot_count = 0;
    layers.clear();
    dots.clear();
    dot_pieces.clear();
    strokes.clear();
    points.clear();
    splats.clear();
    splat_pieces.clear();
    items.clear();
    runs.clear();
    posed_position.clear();
    posed_normal.clear();
    posed_direction.clear();
}

std::int64_t Drawing::bytes() const noexcept {
    return layers.bytes() + dots.bytes() + dot_pieces.bytes() + strokes.bytes() + points.bytes() + splats.bytes() +
           splat_pieces.bytes() + dot_tiles.bytes() + splat_tiles.bytes() + segment_tiles.bytes() + items.bytes() +
           runs.bytes() + posed_position.bytes() + posed_normal.bytes() + posed_direction.bytes();
}

// Of runs without marks, which begin where the next one does, it is the one behind them.
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
    const Run& run = runs[place_of(id)];
    const ItemSource& item = items[run.item];
    const marks::Layer& layer = item.set->layers[run.layer];
    const std::int64_t mark = id - run.first_id;
    const bool posed = run.posed >= 0;
    const glm::vec3 place =
        posed ? marks::vector_at(posed_position, run.posed + mark) : marks::vector_at(layer.position, mark);
    const glm::vec3 normal =
        posed ? marks::vector_at(posed_normal, run.posed + mark) : marks::vector_at(layer.normal, mark);
    const glm::vec3 direction = posed && run.poses_directions ? marks::vector_at(posed_direction, run.posed + mark)
                                                              : marks::vector_at(layer.direction, mark);
    MarkSource source;
    source.position = glm::vec3(item.to_world * glm::dvec4(glm::vec3(glm::dvec3(place) / item.unit), 1.0));
    source.normal = unit_or_zero(item.normal_to_world * normal);
    source.direction = unit_or_zero(of_moderate_scale(item.to_world) * direction);
    return source;
}

} // namespace hrbfnpr::drawing
