// SPDX-License-Identifier: MIT
// Rasterizes the drawing, and measures the share of pixels that differ from the paper. The counts of marks in
// hrbfnpr_drawing_info tell why marks are not shown.
#include "picture/blank.h"

#include "picture/look.h"
#include "picture/report.h"
#include "picture/tuning_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace hrbfnpr::picture {
namespace {

hrbfnpr_drawing_info info_of(const Drawing& drawing) {
    auto info = defaults<hrbfnpr_drawing_info>(hrbfnpr_drawing_info_init);
    call([&](hrbfnpr_error* error) { return hrbfnpr_drawing_get_info(drawing.get(), &info, error); });
    return info;
}

// Calls visit(layer) for each layer of a style.
template <class Visit>
void each_layer_of(const hrbfnpr_style& style, Visit&& visit) {
    const std::int64_t stride =
        style.layer_stride != 0 ? style.layer_stride : static_cast<std::int64_t>(sizeof(hrbfnpr_layer_style));
    const auto* const first = reinterpret_cast<const std::byte*>(style.layers);
    for (std::int64_t i = 0; i < style.layer_count; ++i)
        visit(*reinterpret_cast<const hrbfnpr_layer_style*>(first + i * stride));
}

bool shows_marks(const hrbfnpr_style& style) {
    bool any = false;
    each_layer_of(style, [&](const hrbfnpr_layer_style& layer) { any = any || layer.shown != 0; });
    return any;
}

// Tells whether the ink of every shown layer looks like the paper.
bool has_invisible_ink(const hrbfnpr_style& style) {
    bool all = shows_marks(style);
    each_layer_of(style, [&](const hrbfnpr_layer_style& layer) {
        const bool is_paper = std::equal(layer.ink, layer.ink + 3, style.paper);
        all = all && (layer.shown == 0 || is_paper || layer.ink[3] == 0.0F);
    });
    return all;
}

// Returns the share of the picture that differs from the paper.
double share_of_ink(const Drawing& drawing, const hrbfnpr_camera& camera, const hrbfnpr_style& style, Pool& pool) {
    constexpr double most_pixels = 32768.0; // The largest width and height, in pixels.
    const double width = std::min(std::ceil(camera.viewport[0] + camera.viewport[2]), most_pixels);
    const double height = std::min(std::ceil(camera.viewport[1] + camera.viewport[3]), most_pixels);
    if (!(width >= 1.0 && height >= 1.0)) return 0.0; // The viewport has no pixel inside the image.
    auto image = defaults<hrbfnpr_image>(hrbfnpr_image_init);
    image.format = HRBFNPR_FORMAT_RGBA8;
    image.width = static_cast<std::int32_t>(width);
    image.height = static_cast<std::int32_t>(height);
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    Vector<std::array<std::uint8_t, 4>> pixels(count, &pool);
    image.pixels = pixels.data();
    call([&](hrbfnpr_error* error) { return hrbfnpr_drawing_rasterize(drawing.get(), &image, nullptr, error); });
    std::array<double, 4> paper{};
    for (std::size_t k = 0; k < 4; ++k) paper[k] = 255.0 * static_cast<double>(style.paper[k]);
    const auto has_ink = [&](const std::array<std::uint8_t, 4>& pixel) {
        double colour = 0.0;
        for (std::size_t k = 0; k < 3; ++k)
            colour = std::max(
                colour, std::abs(static_cast<double>(pixel[k]) * static_cast<double>(pixel[3]) - paper[k] * paper[3]));
        return std::max(colour / 255.0, std::abs(pixel[3] - paper[3])) >= blank_tuning.ink_seen;
    };
    return static_cast<double>(std::count_if(pixels.begin(), pixels.end(), has_ink)) / static_cast<double>(count);
}

// Tells whether the camera sees at least one of 27 points of the box: its corners, the midpoints of its edges and
// faces, and its centre.
bool is_in_view(const geometry::Bounds& bounds, const hrbfnpr_camera& camera) noexcept {
    constexpr std::array steps{0.0, 0.5, 1.0};
    for (const double x : steps) {
        for (const double y : steps) {
            for (const double z : steps) {
                const glm::dvec3 place = bounds.min + glm::dvec3(x, y, z) * (bounds.max - bounds.min);
                const glm::dvec4 clip = clip_place(camera, place);
                if (std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w && std::abs(clip.z) <= clip.w) return true;
            }
        }
    }
    return false;
}

void add_reason(String& reasons, std::string_view reason) {
    if (!reasons.empty()) reasons += "; ";
    reasons += reason;
}

String reasons_of_blank(const hrbfnpr_drawing_info& info, const geometry::Bounds& bounds, const hrbfnpr_camera& camera,
                        const hrbfnpr_style& style, bool is_flipped, Pool& pool) {
    const auto facing = static_cast<double>(info.front + info.silhouette);
    const auto takes_most = [](std::int64_t dropped, double of) {
        return static_cast<double>(dropped) > of / blank_tuning.cause_divisor;
    };
    String reasons(&pool);
    if (info.outside == info.marks || !is_in_view(bounds, camera)) {
        reasons =
            "The camera looks away from the model or past it: leave out {eye} and {direction}, or set {target} in "
            "the model";
        return reasons;
    }
    if (bounds.longest_side() == 0.0) {
        reasons = "All samples are at one point";
        return reasons;
    }
    if (info.back > blank_tuning.back_over_front * (info.front + info.silhouette)) {
        add_reason(reasons, "the surface shows only its back: try another {azimuth}, or {sides=both}, or ");
        reasons += is_flipped ? "leave out {flip!}" : "{flip!}";
    }
    if (static_cast<double>(info.dropped_hidden) > blank_tuning.most_hidden * facing) {
        add_reason(reasons,
                   formatted(pool, "%lld of %lld marks that face the eye are hidden, as if normals pointed inward: ",
                             static_cast<long long>(info.dropped_hidden),
                             static_cast<long long>(info.front + info.silhouette)));
        reasons += is_flipped ? "leave out {flip!}" : "{flip!} turns them";
    }
    // The number of front and contour marks that the tone shows.
    const double toned = facing - static_cast<double>(info.dropped_tone);
    const bool by_depth = takes_most(info.dropped_depth, toned);
    const bool by_zoom = takes_most(info.dropped_zoom, toned);
    if (takes_most(info.dropped_tone, facing) && reasons.empty() && !by_depth && !by_zoom)
        add_reason(reasons,
                   "the surface is too light for any mark: {tone=none} draws all marks, {light} turns the light");
    if (by_depth) add_reason(reasons, "marks vanish with distance: leave out {depth_range}");
    if (by_zoom) add_reason(reasons, "marks vanish at this zoom: leave out {zoom_reference}");
    if (has_invisible_ink(style)) add_reason(reasons, "the ink has the colour of the paper, or is transparent");
    if (reasons.empty())
        add_reason(reasons, "the model is too small in the picture, or the style draws no marks: try "
                            "{style=contour-and-stipple}");
    if (reasons[0] >= 'a' && reasons[0] <= 'z') reasons[0] = static_cast<char>(reasons[0] - 'a' + 'A');
    return reasons;
}

} // namespace

std::optional<double> find_blank(const Drawing& drawing, const hrbfnpr_camera& camera, const hrbfnpr_style& style,
                                 Pool& pool) {
    const hrbfnpr_drawing_info info = info_of(drawing);
    const double ink = share_of_ink(drawing, camera, style, pool);
    const auto facing = static_cast<double>(info.front + info.silhouette);
    const bool has_few = shows_marks(style) && static_cast<double>(info.shown) < blank_tuning.least_shown * facing;
    const bool is_hidden = static_cast<double>(info.dropped_hidden) > blank_tuning.most_hidden * facing;
    if (ink >= blank_tuning.least_ink && !(has_few && is_hidden)) return std::nullopt;
    return ink;
}

Blank why_blank(const Drawing& drawing, double ink, const geometry::Bounds& bounds, const hrbfnpr_camera& camera,
                const hrbfnpr_style& style, bool is_flipped, Pool& pool) {
    const hrbfnpr_drawing_info info = info_of(drawing);
    String text("the picture would be blank: ", &pool);
    if (ink > 0.0)
        text += formatted(pool, "%lld of %lld marks are visible, and ink covers %.2f%% of it",
                          static_cast<long long>(info.shown), static_cast<long long>(info.marks), 100.0 * ink);
    else
        text += "nothing is drawn";
    (text += ". ") += reasons_of_blank(info, bounds, camera, style, is_flipped, pool);
    return {info.shown, info.marks, ink, std::move(text)};
}

} // namespace hrbfnpr::picture
