#include "frame/scene/style.h"

namespace hrbfnpr::frame {
namespace {

constexpr std::uint32_t stipple = 1, curvature = 2, combing = 4; // bits of groups

constexpr std::array<const char*, preset_count> names{
    "stipple", "hatch", "cross-hatch", "combing", "silhouette", "contour-and-stipple", "xray", "full"};

// Only the groups of `shown` put ink on the front.
void show(Style& style, std::uint32_t shown) {
    for (std::size_t g = 0; g < style.group.size(); ++g) style.group[g].shown = (shown >> g & 1U) != 0;
}

} // namespace

const char* preset_name(std::uint32_t number) noexcept { return number < preset_count ? names[number] : nullptr; }

Preset preset(std::uint32_t number) {
    Preset preset{preset_name(number), stipple, Style{}};
    Style& style = preset.style;
    // Contours come from every group that there is: the more marks, the crisper they are.
    style.silhouette_radius = 1.2F;
    switch (number) {
    case 0: // stipple
        show(style, stipple);
        // Without contours the stipples themselves must reach the rim.
        style.silhouette_groups = 0;
        style.silhouette_threshold = 0.05;
        style.group[0].radius = 1.1F;
        break;
    case 1: // hatch
    case 2: // cross-hatch
        preset.needed_groups = curvature | stipple;
        show(style, curvature);
        style.group[1].sets = number == 1 ? 2U : 3U;
        style.group[1].radius = 1.1F;
        break;
    case 3: // combing
        preset.needed_groups = combing | stipple;
        show(style, combing);
        style.group[2].radius = 1.1F;
        break;
    case 4: // silhouette
        show(style, 0);
        // A layer or two of surface leave hidden contours visible, but pale.
        style.attenuation_front = 0.2;
        style.attenuation_back = 0.1;
        break;
    case 5: // contour-and-stipple
        show(style, stipple);
        break;
    case 6: // xray
        show(style, 0);
        style.hidden_lines = HiddenLines::show;
        break;
    default: // full
        preset.needed_groups = stipple | curvature;
        show(style, stipple | curvature);
        style.halo_width = 4.0F;
        // Strokes stay in the darker parts, stipples go on into the light.
        style.group[1].share = 0.6F;
        break;
    }
    return preset;
}

} // namespace hrbfnpr::frame
