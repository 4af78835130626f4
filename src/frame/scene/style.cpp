// SPDX-License-Identifier: MIT
#include "frame/scene/style.h"

#include <cstring>

namespace hrbfnpr::frame {
namespace {

constexpr LayerStyle default_layer{};

} // namespace

bool LayerStyle::is_for(const marks::Layer& layer) const noexcept {
    return (kind == marks::Kind::any || kind == layer.kind) &&
           (name == nullptr || std::strcmp(name, layer.name.data()) == 0);
}

const LayerStyle& Style::of(const marks::Layer& layer) const noexcept {
    for (const LayerStyle& style : layers)
        if (style.is_for(layer)) return style;
    return default_layer;
}

} // namespace hrbfnpr::frame
