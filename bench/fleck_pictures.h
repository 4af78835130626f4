// SPDX-License-Identifier: MIT
// Flecks in engravings of meshes, as the command line draws them, but without halos, which are white by intent.
#pragma once

#include "flecks.h"
#include "picture_stages.h"
#include "support/meshes.h"

namespace bench {

inline constexpr std::int32_t fleck_pixels = 4000; // longer side of a picture; strips of white are some pixels wide
inline constexpr double fleck_unit = fleck_pixels / 1000.0;

// Makes and draws an engraving of a mesh.
struct Engraving {
    Engraving(hrbfnpr_context* context, const PictureMesh& mesh) {
        scenes::Check check;
        const hrbfnpr_picture_source source = detail::source_of(mesh, nullptr);
        auto no_halo = scenes::made(hrbfnpr_change_init);
        no_halo.field = "style.halo_width";
        no_halo.value = "0";
        auto desc = scenes::made(hrbfnpr_picture_desc_init);
        desc.sources = &source;
        desc.source_count = 1;
        desc.style_name = "engraving";
        desc.changes = &no_halo;
        desc.change_count = 1;
        desc.size = fleck_pixels;
        hrbfnpr_picture* made = nullptr;
        check(hrbfnpr_picture_create(context, &desc, nullptr, &made, check.error()));
        picture.reset(made);
        hrbfnpr_drawing* drawn = nullptr;
        check(hrbfnpr_picture_draw(made, nullptr, nullptr, &drawn, check.error()));
        drawing.reset(drawn);
    }
    [[nodiscard]] InkImage image() const {
        scenes::Check check;
        auto pixels = scenes::made(hrbfnpr_image_init);
        pixels.format = HRBFNPR_FORMAT_COVERAGE8;
        check(hrbfnpr_picture_plate_size(picture.get(), nullptr, &pixels.width, &pixels.height, check.error()));
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(pixels.width) *
                                        static_cast<std::size_t>(pixels.height));
        pixels.pixels = bytes.data();
        check(hrbfnpr_drawing_rasterize(drawing.get(), &pixels, nullptr, check.error()));
        InkImage image{pixels.width, pixels.height, {}};
        image.ink.reserve(bytes.size());
        for (const std::uint8_t byte : bytes) image.ink.push_back(static_cast<float>(byte) / 255.0F);
        return image;
    }

    hrbfnpr::test::Picture picture;
    scenes::Drawing drawing;
};

// Returns the flecks of an engraving. Lengths and areas are those of a picture of 1000 pixels.
[[nodiscard]] inline Flecks flecks_of(hrbfnpr_context* context, const PictureMesh& mesh) {
    FleckRules rules;
    for (const hrbfnpr_layer_style& layer : Style(HRBFNPR_PRESET_ENGRAVING).layer)
        if (layer.shape == HRBFNPR_SHAPE_HATCH)
            rules.spacing = static_cast<double>(layer.hatch_spacing) * fleck_pixels / 800.0;
    Flecks found = find_flecks(Engraving(context, mesh).image(), rules);
    found.dark /= fleck_unit * fleck_unit;
    for (Fleck& fleck : found.fleck) fleck = {fleck.x / fleck_unit, fleck.y / fleck_unit, fleck.diameter / fleck_unit};
    return found;
}

// Returns a tube around a trefoil knot.
[[nodiscard]] inline PictureMesh fleck_knot() {
    constexpr std::int32_t along = 400;
    constexpr std::int32_t around = 40;
    const auto middle = [](double t) {
        const double radius = 2.0 + std::cos(3.0 * t);
        return glm::dvec3(radius * std::cos(2.0 * t), radius * std::sin(2.0 * t), 1.2 * std::sin(3.0 * t));
    };
    PictureMesh mesh;
    for (std::int32_t i = 0; i < along; ++i)
        for (std::int32_t k = 0; k < around; ++k) {
            const double t = 2.0 * detail::pi * i / along;
            const double turn = 2.0 * detail::pi * k / around;
            const glm::dvec3 way = glm::normalize(middle(t + 1e-3) - middle(t - 1e-3));
            const glm::dvec3 side = glm::normalize(glm::cross(way, glm::dvec3(0.0, 0.0, 1.0)));
            mesh.points.push_back(middle(t) + 0.4 * (std::cos(turn) * side + std::sin(turn) * glm::cross(side, way)));
            const auto at = [&](std::int32_t a, std::int32_t b) { return a % along * around + b % around; };
            mesh.faces.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            mesh.faces.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    return mesh;
}

[[nodiscard]] inline PictureMesh fleck_mesh(const hrbfnpr::test::Triangles& triangles) {
    PictureMesh mesh;
    for (std::size_t i = 0; i + 2 < triangles.vertices.size(); i += 3)
        mesh.points.emplace_back(triangles.vertices[i], triangles.vertices[i + 1], triangles.vertices[i + 2]);
    for (std::size_t i = 0; i + 2 < triangles.triangles.size(); i += 3)
        mesh.faces.push_back({triangles.triangles[i], triangles.triangles[i + 1], triangles.triangles[i + 2]});
    return mesh;
}

} // namespace bench
