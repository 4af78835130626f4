// SPDX-License-Identifier: MIT
#include "frame/scene/shading.h"

#include "base/assert.h"
#include "base/status.h"
#include "frame/scene/tuning.h"
#include "light/light.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace hrbfnpr::frame {
namespace {

using geometry::VecArray;

struct WorldMarks {
    explicit WorldMarks(base::Memory& memory) noexcept : position(memory), normal(memory) {}
    VecArray position, normal;
};

[[nodiscard]] WorldMarks in_world(const base::Work& work, const ShadedItem& item, const marks::Layer& layer) {
    WorldMarks marks(work.memory);
    marks.position.resize(layer.count());
    marks.normal.resize(layer.count());
    const glm::dmat3 linear(item.to_world);
    const glm::dmat3 of_normals = glm::transpose(glm::inverse(linear));
    const glm::dvec3 origin(item.to_world * glm::dvec4(item.set->origin, 1.0));
    work.for_chunks(layer.count(), 65536, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            marks.position.set(i, origin + linear * glm::dvec3(marks::vector_at(layer.position, i)));
            marks.normal.set(i, glm::normalize(of_normals * glm::dvec3(marks::vector_at(layer.normal, i))));
        }
    });
    return marks;
}

// Adds the order of the blocks to numbers of marks. Places without a mark get 1.
[[nodiscard]] MarkNumbers in_both_orders(base::Array<float>&& of_mark, const marks::Layer& layer) {
    const base::Array<marks::MarkBlock>& block = layer.clusters.block;
    MarkNumbers numbers(of_mark.memory());
    numbers.of_mark = std::move(of_mark);
    numbers.in_blocks.resize_for_overwrite(block.size() * marks::MarkBlock::size);
    std::fill(numbers.in_blocks.begin(), numbers.in_blocks.end(), 1.0F);
    for (const marks::Cluster& cluster : layer.clusters.cluster)
        for (std::int64_t i = 0; i < cluster.count; ++i) {
            const std::int64_t place = cluster.block * marks::MarkBlock::size + i;
            const std::uint32_t mark = block[place / marks::MarkBlock::size].mark[place % marks::MarkBlock::size];
            numbers.in_blocks[place] = numbers.of_mark[mark];
        }
    return numbers;
}

void copy(const MarkNumbers& from, MarkNumbers& to) {
    marks::copy_arrays(from, to, &MarkNumbers::of_mark, &MarkNumbers::in_blocks);
}

void lower(SeenShares& least, const SeenShares& seen) noexcept {
    least.open = std::min(least.open, seen.open);
    for (std::size_t i = 0; i < least.visible.size(); ++i)
        least.visible[i] = std::min(least.visible[i], seen.visible[i]);
    least.bend = std::min(least.bend, seen.bend);
}

// The shares of which the least is found begin with the largest.
constexpr SeenShares most_seen{1.0F, {1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F}, 1.0F};

void find_least(const Shading& shading, std::int64_t number, const marks::Layer& layer, LayerShading& to) {
    for (const marks::Cluster& cluster : layer.clusters.cluster) {
        SeenShares least = most_seen;
        for (std::int64_t i = 0; i < cluster.count; ++i) {
            const std::int64_t place = cluster.block * marks::MarkBlock::size + i;
            const marks::MarkBlock& block = layer.clusters.block[place / marks::MarkBlock::size];
            lower(least, shading.of_mark(number, block.mark[place % marks::MarkBlock::size]));
        }
        to.of_cluster.push_back(least);
    }
    for (const marks::StrokePiece& piece : layer.clusters.piece) {
        SeenShares least = most_seen;
        for (std::int64_t i = 0; i < piece.count; ++i)
            lower(least, shading.of_mark(number, layer.mark_of(piece.first + i)));
        to.of_piece.push_back(least);
    }
}

// Returns how the surface bends, or nothing if curvature is not wanted.
[[nodiscard]] std::unique_ptr<light::SurfaceBend> bend_of(const base::Work& work, const ShadedItem& item,
                                                          const ShadingSettings& settings) {
    if (item.mesh == nullptr || !(settings.curvature_scale > 0.0)) return nullptr;
    const curves::SurfaceMesh& mesh = *item.mesh;
    geometry::Bounds bounds;
    for (std::int64_t i = 0; i < mesh.vertices(); ++i) bounds.extend(mesh.position[i]);
    return std::make_unique<light::SurfaceBend>(work, light::SurfaceTriangles{mesh.position, mesh.corner, mesh.side},
                                                settings.curvature_scale * bounds.diagonal());
}

// Finds how the surface bends at the marks of a layer.
[[nodiscard]] MarkNumbers bends_of(const base::Work& work, const ShadedItem& item, const marks::Layer& layer,
                                   const light::SurfaceBend& bend) {
    ShadedItem own = item;
    own.to_world = glm::dmat4(1.0);
    const WorldMarks marks = in_world(work, own, layer);
    return in_both_orders(bend.contrast(work, {marks.position, marks.normal, 0.0}), layer);
}

// Finds the shares of the marks of a layer. `bend` is null if curvature is not wanted, or known from before.
void shade_layer(const base::Work& work, const Casters& casters, const ShadedItem& item,
                 const ShadingSettings& settings, const light::SurfaceBend* bend, std::int64_t number,
                 LayerShading& to) {
    const marks::Layer& layer = item.set->layers[number];
    const WorldMarks world = in_world(work.without_progress(), item, layer);
    const light::Places places{world.position, world.normal, scene_tuning.shading_offset * casters.cell};
    if (settings.previous != nullptr) {
        copy(settings.previous->layers[number].open, to.open);
        copy(settings.previous->layers[number].bend, to.bend);
    } else if (settings.reach > 0.0) {
        light::Sky sky{settings.reach};
        sky.rays = settings.sky_rays;
        to.open = in_both_orders(light::find_openness(work, casters.tree, places, sky), layer);
    }
    if (bend != nullptr) to.bend = bends_of(work.without_progress(), item, layer, *bend);
    for (const LightStyle& light : item.lights) {
        MarkNumbers& visible = to.visible.add(MarkNumbers(work.memory));
        if (!(light.shadow > 0.0F)) continue;
        const light::Lamp lamp = lamp_of(light, item, settings.shadow_rays);
        visible = in_both_orders(light::find_visible(work.without_progress(), casters.tree, places, lamp), layer);
    }
}

[[nodiscard]] bool has_bend(const Shading& shading) noexcept {
    return std::any_of(shading.layers.begin(), shading.layers.end(),
                       [](const LayerShading& layer) { return !layer.bend.empty(); });
}

} // namespace

LightShares Shading::in_blocks(std::int64_t layer, std::int64_t first_place) const noexcept {
    const LayerShading& from = layers[layer];
    const auto part = [&](const MarkNumbers& numbers) {
        return numbers.empty() ? nullptr : numbers.in_blocks.data() + first_place;
    };
    LightShares shares;
    shares.open = part(from.open);
    shares.bend = part(from.bend);
    for (std::int64_t i = 0; i < from.visible.size(); ++i) shares.visible[i] = part(from.visible[i]);
    return shares;
}

std::span<const float> Shading::of_layer(std::int64_t layer, std::int64_t light) const noexcept {
    const LayerShading& from = layers[layer];
    if (light < 0) return from.open.of_mark.span();
    return light < from.visible.size() ? from.visible[light].of_mark.span() : std::span<const float>();
}

SeenShares Shading::of_mark(std::int64_t layer, std::int64_t mark) const noexcept {
    const LayerShading& from = layers[layer];
    SeenShares seen;
    if (!from.open.empty()) seen.open = from.open.of_mark[mark];
    if (!from.bend.empty()) seen.bend = from.bend.of_mark[mark];
    for (std::int64_t i = 0; i < from.visible.size(); ++i)
        if (!from.visible[i].empty()) seen.visible[static_cast<std::size_t>(i)] = from.visible[i].of_mark[mark];
    return seen;
}

std::int64_t Shading::bytes() const noexcept {
    std::int64_t sum = 0;
    for (const LayerShading& layer : layers) {
        sum += layer.open.bytes() + layer.bend.bytes() + layer.of_cluster.bytes() + layer.of_piece.bytes();
        for (const MarkNumbers& visible : layer.visible) sum += visible.bytes();
    }
    for (const curves::FoundLines& found : lines) sum += found.lines.bytes();
    return sum;
}

light::Lamp lamp_of(const LightStyle& style, const ShadedItem& item, std::int32_t rays) noexcept {
    const glm::dmat4 to_world = style.space == LightSpace::camera ? glm::inverse(item.view)
                                : style.space == LightSpace::item ? item.to_world
                                                                  : glm::dmat4(1.0);
    light::Lamp lamp;
    lamp.is_place = style.kind == LightKind::place;
    lamp.place = glm::dvec3(to_world * glm::dvec4(style.place, lamp.is_place ? 1.0 : 0.0));
    if (!lamp.is_place) lamp.place = glm::normalize(lamp.place);
    lamp.softness = static_cast<double>(style.softness);
    lamp.rays = rays;
    return lamp;
}

Casters casters_of(const base::Work& work, std::span<const Caster> casters) {
    base::Array<glm::dvec3> vertex(work.memory);
    base::Array<geometry::Bvh::Triangle> triangle(work.memory);
    base::Array<Caster> all(work.memory);
    base::Array<std::int64_t> first_face(work.memory);
    base::Array<geometry::Bounds> boxes(work.memory);
    double cell = 0.0;
    geometry::Bounds bounds;
    for (const Caster& caster : casters) {
        const auto first = static_cast<std::int32_t>(vertex.size());
        const curves::SurfaceMesh& mesh = *caster.mesh;
        if (mesh.vertices() > std::numeric_limits<std::int32_t>::max() - vertex.size())
            fail(Status::invalid_argument,
                 "the line sets of all items together have more than 2147483647 vertices; make them with a larger "
                 "cell_size");
        geometry::Bounds box;
        for (std::int64_t i = 0; i < mesh.vertices(); ++i) {
            vertex.push_back(glm::dvec3(caster.to_world * glm::dvec4(mesh.position[i], 1.0)));
            box.extend(vertex.back());
        }
        all.push_back(caster);
        first_face.push_back(triangle.size());
        boxes.push_back(box);
        for (std::int64_t t = 0; t < mesh.triangles(); ++t)
            triangle.push_back(
                {first + mesh.corner[3 * t], first + mesh.corner[3 * t + 1], first + mesh.corner[3 * t + 2]});
        cell = std::max(cell, mesh.side * mean_scale(caster.to_world));
    }
    for (const glm::dvec3& place : vertex) bounds.extend(place);
    return {geometry::Bvh(work, vertex, triangle),
            cell,
            bounds.diagonal(),
            std::move(all),
            std::move(first_face),
            std::move(boxes)};
}

Shading find_shading(const base::Work& work, const Casters& casters, const ShadedItem& item,
                     const ShadingSettings& settings) {
    HRBFNPR_ASSERT(item.lights.size() <= most_lights);
    Shading shading(work.memory);
    const bool knows_bend = settings.previous != nullptr && has_bend(*settings.previous);
    const auto bend = knows_bend ? nullptr : bend_of(work.without_progress(), item, settings);
    const std::int64_t layers = item.set->layers.size();
    for (std::int64_t number = 0; number < layers; ++number) {
        const base::Work part = work.part(static_cast<double>(number) / static_cast<double>(layers),
                                          static_cast<double>(number + 1) / static_cast<double>(layers));
        LayerShading& to = shading.layers.add(LayerShading(work.memory));
        shade_layer(part, casters, item, settings, bend.get(), number, to);
        find_least(shading, number, item.set->layers[number], to);
    }
    return shading;
}

void light_marks(const ProjectionLoops& loops, const Lighting& lighting, const ShadedMarks& shaded,
                 const MarkRows& rows, const float* nu, float* tau) noexcept {
    HRBFNPR_ASSERT(rows.count == static_cast<std::int64_t>(shaded.marks.size()));
    if (shaded.shading == nullptr) {
        loops.light_rows(lighting, rows, nu, {}, tau);
        return;
    }
    // The shares of the marks are scattered in memory.
    constexpr std::int64_t at_once = 64;
    std::array<std::array<float, at_once>, 2 + most_lights> row{};
    const LayerShading& from = shaded.shading->layers[shaded.layer];
    for (std::int64_t first = 0; first < rows.count; first += at_once) {
        const std::int64_t size = std::min(at_once, rows.count - first);
        std::size_t used = 0;
        const auto gather = [&](const MarkNumbers& numbers) -> const float* {
            if (numbers.empty()) return nullptr;
            float* const to = row[used++].data();
            for (std::int64_t i = 0; i < size; ++i)
                to[i] = numbers.of_mark[shaded.marks[static_cast<std::size_t>(first + i)]];
            return to;
        };
        LightShares shares;
        shares.open = gather(from.open);
        shares.bend = gather(from.bend);
        for (std::int64_t k = 0; k < from.visible.size(); ++k) shares.visible[k] = gather(from.visible[k]);
        loops.light_rows(
            lighting,
            {rows.x + first, rows.y + first, rows.z + first, rows.nx + first, rows.ny + first, rows.nz + first, size},
            nu + first, shares, tau + first);
    }
}

} // namespace hrbfnpr::frame
