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

// Copies numbers of marks to the order of the blocks. Places without a mark get 1.
void sort_into_blocks(const base::Array<float>& of_marks, std::int64_t first, const marks::Layer& layer, float* to) {
    const base::Array<marks::MarkBlock>& block = layer.clusters.block;
    std::fill_n(to, block.size() * marks::MarkBlock::size, 1.0F);
    for (const marks::Cluster& cluster : layer.clusters.cluster)
        for (std::int64_t i = 0; i < cluster.count; ++i) {
            const std::int64_t place = cluster.block * marks::MarkBlock::size + i;
            to[place] = of_marks[first + block[place / marks::MarkBlock::size].mark[place % marks::MarkBlock::size]];
        }
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
void add_bends(const base::Work& work, const ShadedItem& item, const marks::Layer& layer,
               const light::SurfaceBend& bend, LayerShading& to) {
    ShadedItem own = item;
    own.to_world = glm::dmat4(1.0);
    const WorldMarks marks = in_world(work, own, layer);
    to.bend = bend.contrast(work, {marks.position, marks.normal, 0.0});
    to.bend_in_blocks.resize_for_overwrite(layer.clusters.block.size() * marks::MarkBlock::size);
    sort_into_blocks(to.bend, 0, layer, to.bend_in_blocks.data());
}

} // namespace

LightShares Shading::in_blocks(std::int64_t layer, std::int64_t first_place) const noexcept {
    const LayerShading& from = layers[layer];
    LightShares shares;
    if (!from.open_in_blocks.empty()) shares.open = from.open_in_blocks.data() + first_place;
    if (!from.bend_in_blocks.empty()) shares.bend = from.bend_in_blocks.data() + first_place;
    const std::int64_t places = shadows > 0 ? from.visible_in_blocks.size() / shadows : 0;
    for (std::size_t i = 0; i < shadow.size(); ++i)
        if (shadow[i] >= 0 && places > 0)
            shares.visible[i] = from.visible_in_blocks.data() + shadow[i] * places + first_place;
    return shares;
}

std::span<const float> Shading::of_layer(std::int64_t layer, std::int64_t light) const noexcept {
    const LayerShading& from = layers[layer];
    if (light < 0) return from.open.span();
    const std::int32_t number = shadow[static_cast<std::size_t>(light)];
    if (number < 0) return {};
    const std::int64_t marks = from.visible.size() / shadows;
    return from.visible.span().subspan(static_cast<std::size_t>(number * marks), static_cast<std::size_t>(marks));
}

SeenShares Shading::of_mark(std::int64_t layer, std::int64_t mark) const noexcept {
    const LayerShading& from = layers[layer];
    SeenShares seen;
    if (!from.open.empty()) seen.open = from.open[mark];
    if (!from.bend.empty()) seen.bend = from.bend[mark];
    const std::int64_t marks = shadows > 0 ? from.visible.size() / shadows : 0;
    for (std::size_t i = 0; i < shadow.size(); ++i)
        if (shadow[i] >= 0) seen.visible[i] = from.visible[shadow[i] * marks + mark];
    return seen;
}

bool Shading::has_bend() const noexcept {
    return std::any_of(layers.begin(), layers.end(), [](const LayerShading& layer) { return !layer.bend.empty(); });
}

std::int64_t Shading::bytes() const noexcept {
    std::int64_t sum = 0;
    for (const LayerShading& layer : layers)
        sum += layer.open.bytes() + layer.visible.bytes() + layer.bend.bytes() + layer.open_in_blocks.bytes() +
               layer.visible_in_blocks.bytes() + layer.bend_in_blocks.bytes() + layer.of_cluster.bytes() +
               layer.of_piece.bytes();
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
    for (std::size_t i = 0; i < item.lights.size(); ++i)
        if (item.lights[i].shadow > 0.0F) shading.shadow[i] = shading.shadows++;
    const double offset = scene_tuning.shading_offset * casters.cell;
    const bool has_bend = settings.previous != nullptr && settings.previous->has_bend();
    const auto bend = has_bend ? nullptr : bend_of(work.without_progress(), item, settings);
    for (std::int64_t number = 0; number < item.set->layers.size(); ++number) {
        const marks::Layer& layer = item.set->layers[number];
        const base::Work part =
            work.part(static_cast<double>(number) / static_cast<double>(item.set->layers.size()),
                      static_cast<double>(number + 1) / static_cast<double>(item.set->layers.size()));
        LayerShading& to = shading.layers.add(LayerShading(work.memory));
        const WorldMarks world = in_world(work, item, layer);
        const light::Places places{world.position, world.normal, offset};
        const std::int64_t in_blocks = layer.clusters.block.size() * marks::MarkBlock::size;
        if (settings.previous != nullptr) {
            marks::copy_array(settings.previous->layers[number].open, to.open);
            marks::copy_array(settings.previous->layers[number].open_in_blocks, to.open_in_blocks);
        } else if (settings.reach > 0.0) {
            light::Sky sky{settings.reach};
            sky.rays = settings.sky_rays;
            to.open = light::find_openness(part, casters.tree, places, sky);
            to.open_in_blocks.resize_for_overwrite(in_blocks);
            sort_into_blocks(to.open, 0, layer, to.open_in_blocks.data());
        }
        if (has_bend) {
            marks::copy_array(settings.previous->layers[number].bend, to.bend);
            marks::copy_array(settings.previous->layers[number].bend_in_blocks, to.bend_in_blocks);
        } else if (bend != nullptr) {
            add_bends(part.without_progress(), item, layer, *bend, to);
        }
        to.visible_in_blocks.resize_for_overwrite(shading.shadows * in_blocks);
        for (std::size_t i = 0; i < item.lights.size(); ++i) {
            if (shading.shadow[i] < 0) continue;
            const light::Lamp lamp = lamp_of(item.lights[i], item, settings.shadow_rays);
            const base::Array<float> visible = light::find_visible(part.without_progress(), casters.tree, places, lamp);
            sort_into_blocks(visible, 0, layer, to.visible_in_blocks.data() + shading.shadow[i] * in_blocks);
            for (const float share : visible) to.visible.push_back(share);
        }
        find_least(shading, number, layer, to);
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
    std::array<std::array<float, at_once>, 2 + most_lights> share{};
    LightShares shares;
    shares.open = share[0].data();
    shares.bend = share[most_lights + 1].data();
    for (std::size_t k = 0; k < most_lights; ++k)
        if (shaded.shading->shadow[k] >= 0) shares.visible[k] = share[k + 1].data();
    for (std::int64_t first = 0; first < rows.count; first += at_once) {
        const std::int64_t size = std::min(at_once, rows.count - first);
        for (std::int64_t i = 0; i < size; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const SeenShares seen =
                shaded.shading->of_mark(shaded.layer, shaded.marks[static_cast<std::size_t>(first + i)]);
            share[0][at] = seen.open;
            share[most_lights + 1][at] = seen.bend;
            for (std::size_t k = 0; k < most_lights; ++k) share[k + 1][at] = seen.visible[k];
        }
        loops.light_rows(
            lighting,
            {rows.x + first, rows.y + first, rows.z + first, rows.nx + first, rows.ny + first, rows.nz + first, size},
            nu + first, shares, tau + first);
    }
}

} // namespace hrbfnpr::frame
