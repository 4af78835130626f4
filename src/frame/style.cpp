#include "frame/style.h"

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
    switch (number) {
    case 0: // stipple
        show(style, stipple);
        style.silhouette_groups = 0;
        style.silhouette_threshold = 0.05;
        break;
    case 1: // hatch
    case 2: // cross-hatch
        preset.needed_groups = curvature | stipple;
        show(style, curvature);
        style.group[1].sets = number == 1 ? 2U : 3U;
        break;
    case 3: // combing
        preset.needed_groups = combing | stipple;
        show(style, combing);
        break;
    case 4: // silhouette
        show(style, 0);
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
        break;
    }
    return preset;
}

} // namespace hrbfnpr::frame
