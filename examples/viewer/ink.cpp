// SPDX-License-Identifier: MIT
// Marks and lines for a style and a picture, by the rules that the command line has for what is left open.
#include "scene.h"

#include <algorithm>
#include <cstring>

namespace viewer {

namespace {

constexpr double stroke_spacing = 1.25; // of marks along a stroke, in radii: near enough to make a line
constexpr double hatch_lines = 300;     // of hatching, all levels, in the root of the area
constexpr double most_marks = 2000000;
constexpr int most_levels = 6;
constexpr std::int64_t patch_count = 48;
// Ink over area at the darkest tone; of strokes that of one direction.
constexpr double stipple_coverage = 0.8, stroke_coverage = 0.55;
constexpr double pi = 3.141592653589793;

bool is_for(const hrbfnpr_layer_style& style, const hrbfnpr_layer_desc& layer) {
    const bool kind = style.kind == HRBFNPR_LAYER_KIND_ANY || style.kind == layer.kind;
    const bool name = style.name == nullptr || (layer.name != nullptr && std::strcmp(style.name, layer.name) == 0);
    return kind && name;
}

hrbfnpr_layer_style style_of(const Style& style, const hrbfnpr_layer_desc& layer) {
    for (const auto& each : style.layers)
        if (is_for(each, layer)) return each;
    return defaults<hrbfnpr_layer_style>(hrbfnpr_layer_style_init);
}

std::int64_t budget_of(double wanted) {
    return static_cast<std::int64_t>(std::clamp(std::nearbyint(wanted), 1.0, most_marks));
}

// As many marks as make the darkest tone nearly black; `pixels`: in a unit of length.
void fill_even(hrbfnpr_layer_desc& layer, const hrbfnpr_layer_style& style, double area, double pixels) {
    const double radius = style.radius;
    if (layer.kind == HRBFNPR_LAYER_KIND_HATCH) {
        // Lines finer than the window has room for, at twice its scale, are not worth waiting for.
        const double finest = 0.5 * style.hatch_spacing / pixels;
        if (layer.separation == 0) layer.separation = std::max(std::sqrt(area) / hatch_lines, finest);
        layer.budget = 0; // as many as there are of that separation
    } else if (layer.kind == HRBFNPR_LAYER_KIND_STIPPLES) {
        const double wanted = stipple_coverage * area * (pixels * pixels) / (pi * (radius * radius));
        layer.budget = budget_of(style.shown ? wanted : 0.25 * wanted); // else they only hide what is behind
    } else {
        const double step = stroke_spacing * radius / pixels;
        if (layer.step == 0) layer.step = step;
        layer.budget = budget_of(2 * area * pixels * stroke_coverage / (2 * radius) / step);
    }
}

// As many refinement steps as do not overfill the picture.
void fill_published(hrbfnpr_layer_desc& layer, double radius, double area, double pixels, double seeds) {
    const double wanted = area * (pixels * pixels) / (pi * (radius * radius));
    const bool stipples = layer.kind == HRBFNPR_LAYER_KIND_STIPPLES;
    const double start = stipples ? seeds : 2 * seeds;
    const double steps = std::nearbyint(std::log(std::max(wanted, 1.0) / start) / std::log(stipples ? 5.0 : 3.0));
    layer.levels = static_cast<std::int32_t>(std::clamp(steps, 1.0, static_cast<double>(most_levels)));
    layer.budget = 0;
}

std::vector<hrbfnpr_layer_desc> layers_for(const Surface& surface, const Settings& settings, Size size) {
    if (!settings.layers.empty()) return settings.layers;
    const Style style = style_for(settings, size, surface);
    const View view = settings.view ? *settings.view : View{};
    const double pixels = 1 / units_per_pixel(camera_of(view, size), surface.centre());
    const bool published = settings.marks.distribution == HRBFNPR_DISTRIBUTION_PUBLISHED;
    auto info = defaults<hrbfnpr_model_info>(hrbfnpr_model_info_init);
    checked([&](auto* error) { return hrbfnpr_model_get_info(surface.model.get(), &info, error); });
    std::vector<hrbfnpr_layer_desc> layers = preset_layers(settings.preset, settings.marks.distribution);
    for (auto& layer : layers) {
        if (published)
            fill_published(layer, style_of(style, layer).radius, surface.area, pixels,
                           std::max<double>(static_cast<double>(info.centres), 1));
        else
            fill_even(layer, style_of(style, layer), surface.area, pixels);
    }
    return layers;
}

// The painted maps that marks are placed by; the maps must stay for as long as the layers are used.
void add_maps(std::vector<hrbfnpr_layer_desc>& layers, PaintedMap& density, PaintedMap& direction) {
    for (auto& layer : layers) {
        if (layer.kind == HRBFNPR_LAYER_KIND_STIPPLES && !density.is_empty()) {
            layer.density = HRBFNPR_DENSITY_CALLBACK;
            layer.density_function = painted_density;
            layer.density_user = &density;
        }
        if (layer.kind == HRBFNPR_LAYER_KIND_HATCH && !direction.is_empty()) {
            layer.direction_function = painted_direction;
            layer.direction_user = &direction;
        }
    }
}

bool has_kind(const Style& style, std::uint32_t kind) {
    return std::any_of(style.lines.begin(), style.lines.end(), [&](const auto& line) { return line.kind == kind; });
}

// The lines that a style draws and that are to be found once.
std::vector<hrbfnpr_line_desc> lines_found_once(const Style& style, const Settings& settings, const Surface& surface) {
    if (!settings.lines.empty()) return settings.lines;
    std::vector<hrbfnpr_line_desc> result;
    for (const auto& line : style.lines) {
        auto desc = defaults<hrbfnpr_line_desc>(hrbfnpr_line_desc_init);
        desc.kind = line.kind;
        const bool once = line.kind == HRBFNPR_LINE_KIND_RIDGE || line.kind == HRBFNPR_LINE_KIND_VALLEY ||
                          line.kind == HRBFNPR_LINE_KIND_PARABOLIC || line.kind == HRBFNPR_LINE_KIND_SECTION;
        if (!once) continue;
        if (line.kind == HRBFNPR_LINE_KIND_SECTION) {
            std::vector<double> levels; // ten planes across z, as the command line has them
            auto info = defaults<hrbfnpr_model_info>(hrbfnpr_model_info_init);
            checked([&](auto* error) { return hrbfnpr_model_get_info(surface.model.get(), &info, error); });
            const double low = info.bounds_min[2], high = info.bounds_max[2];
            for (int i = 0; i < 10; ++i) levels.push_back(low + (high - low) * (i + 0.5) / 10);
            desc.levels = kept(levels);
        }
        result.push_back(desc);
    }
    return result;
}

LineSet lines_of(const Surface& surface, const Settings& settings, Work& work) {
    const Style& style = settings.style;
    if (style.lines.empty() || style.fields.visibility == HRBFNPR_VISIBILITY_PUBLISHED) return nullptr;
    const std::vector<hrbfnpr_line_desc> once = lines_found_once(style, settings, surface);
    hrbfnpr_line_set_desc desc = settings.line_set;
    desc.lines = once.data();
    desc.line_count = static_cast<std::int64_t>(once.size());
    if (has_kind(style, HRBFNPR_LINE_KIND_SUGGESTIVE_CONTOUR) || has_kind(style, HRBFNPR_LINE_KIND_APPARENT_RIDGE) ||
        has_kind(style, HRBFNPR_LINE_KIND_ISOPHOTE))
        desc.flags |= HRBFNPR_LINE_SET_WITH_CURVATURE;
    hrbfnpr_line_set* lines = nullptr;
    work.stage("lines", [&](auto* operation, auto* error) {
        return hrbfnpr_line_set_create(work.context.get(), surface.model.get(), &desc, operation, &lines, error);
    });
    return LineSet(lines, hrbfnpr_line_set_release);
}

// Made in a tenth of the time.
void make_coarse(std::vector<hrbfnpr_layer_desc>& layers) {
    for (auto& layer : layers) {
        if (layer.kind == HRBFNPR_LAYER_KIND_HATCH) {
            if (layer.separation == 0) layer.budget = std::max<std::int64_t>(layer.budget / 9, 100);
            layer.separation *= 3;
        }
        if (layer.kind == HRBFNPR_LAYER_KIND_STIPPLES) layer.budget = std::min<std::int64_t>(layer.budget, 20000);
    }
}

std::vector<hrbfnpr_layer_info> infos_of(const PointSet& marks) {
    auto info = defaults<hrbfnpr_point_set_info>(hrbfnpr_point_set_info_init);
    checked([&](auto* error) { return hrbfnpr_point_set_get_info(marks.get(), &info, error); });
    std::vector<hrbfnpr_layer_info> infos;
    for (std::int64_t layer = 0; layer < info.layers; ++layer) {
        infos.push_back(defaults<hrbfnpr_layer_info>(hrbfnpr_layer_info_init));
        checked(
            [&](auto* error) { return hrbfnpr_point_set_get_layer_info(marks.get(), layer, &infos.back(), error); });
    }
    return infos;
}

} // namespace

double pen_of(const Settings& settings, Size size) {
    return settings.pen > 0 ? settings.pen : std::max(0.75, std::max(size.width, size.height) / 800.0);
}

Style style_for(const Settings& settings, Size size, const Surface& surface) {
    Style style = settings.style;
    if (surface.is_trimmed && !style.lines.empty() && !has_kind(style, HRBFNPR_LINE_KIND_BORDER)) {
        auto border = defaults<hrbfnpr_line_style>(hrbfnpr_line_style_init);
        const auto contour = std::find_if(style.lines.begin(), style.lines.end(),
                                          [](const auto& line) { return line.kind == HRBFNPR_LINE_KIND_CONTOUR; });
        border.kind = HRBFNPR_LINE_KIND_BORDER;
        border.width = contour != style.lines.end() ? contour->width : 2.2F;
        border.hidden = contour != style.lines.end() ? contour->hidden : border.hidden;
        border.taper = 0;
        style.lines.push_back(border);
    }
    return sized(style, pen_of(settings, size));
}

void draw_as_published(Style& style, std::uint32_t preset) {
    for (auto& layer : style.layers) {
        if (layer.kind == HRBFNPR_LAYER_KIND_COMBING && layer.shown) {
            layer.shape = HRBFNPR_SHAPE_DOTS;
            layer.radius = 1.1F;
            layer.share = 1;
        }
        if (layer.kind == HRBFNPR_LAYER_KIND_STIPPLES && preset == HRBFNPR_PRESET_FULL) layer.radius = layer.share = 1;
    }
}

Patches patches_of(const Surface& surface, const Settings& settings, Work& work) {
    Patches patches;
    hrbfnpr_generate_desc desc = settings.marks;
    std::vector<std::array<Vec, 4>> corners(static_cast<std::size_t>(patch_count));
    const hrbfnpr_array_out room = {corners.data(), patch_count, 0, HRBFNPR_SCALAR_FLOAT64, 12};
    desc.initial_step = 0;
    work.stage("patches", [&](auto* operation, auto* error) {
        return hrbfnpr_point_set_step_patches(work.context.get(), surface.model.get(), &desc, &room, &patches.estimate,
                                              operation, error);
    });
    patches.corners = std::move(corners);
    patches.step = patches.estimate;
    return patches;
}

bool has_hatching(const Settings& settings) {
    const auto layers =
        settings.layers.empty() ? preset_layers(settings.preset, settings.marks.distribution) : settings.layers;
    return std::any_of(layers.begin(), layers.end(),
                       [](const auto& layer) { return layer.kind == HRBFNPR_LAYER_KIND_HATCH; });
}

Ink ink_of(const Surface& surface, const Settings& settings, Size size, bool wants_patches, bool coarse, Work& work) {
    Ink ink;
    if (surface.model == nullptr) {
        ink.marks = surface.marks;
        ink.infos = infos_of(ink.marks);
        return ink;
    }
    if (wants_patches) ink.patches = patches_of(surface, settings, work);
    ink.layers = layers_for(surface, settings, size);
    ink.made = ink.layers;
    if (coarse) make_coarse(ink.made);
    std::vector<hrbfnpr_layer_desc> layers = ink.made;
    PaintedMap density(settings.paint, Map::density), direction(settings.paint, Map::direction);
    add_maps(layers, density, direction);
    hrbfnpr_generate_desc desc = settings.marks;
    desc.layers = layers.data();
    desc.layer_count = static_cast<std::int64_t>(layers.size());
    hrbfnpr_point_set* marks = nullptr;
    work.stage("marks", [&](auto* operation, auto* error) {
        return hrbfnpr_point_set_generate(work.context.get(), surface.model.get(), &desc, operation, &marks, error);
    });
    ink.marks = PointSet(marks, hrbfnpr_point_set_release);
    ink.lines = lines_of(surface, settings, work);
    ink.infos = infos_of(ink.marks);
    ink.timings = work.timings;
    return ink;
}

} // namespace viewer
