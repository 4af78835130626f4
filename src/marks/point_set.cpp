// SPDX-License-Identifier: MIT
#include "marks/point_set.h"

#include "base/sort.h"

#include <algorithm>
#include <cstring>

namespace hrbfnpr::marks {

LayerName default_name(Kind kind) noexcept {
    constexpr std::array<const char*, kind_count> names = {"", "stipples", "hatch", "own"};
    LayerName name{};
    const char* const text = names[static_cast<std::size_t>(kind)];
    std::memcpy(name.data(), text, std::strlen(text));
    return name;
}

std::int64_t Layer::bytes() const noexcept {
    std::int64_t sum = fields.bytes();
    for (const MarkField& field : fields) sum += field.bytes();
    return sum + position.bytes() + normal.bytes() + direction.bytes() + curvature.bytes() + rank.bytes() +
           level.bytes() + stroke.bytes() + width.bytes() + tone_normal.bytes() + stroke_first.bytes() +
           stroke_order.bytes() + clusters.bytes() + report.level.bytes();
}

const MarkField* Layer::field_of(const char* wanted) const noexcept {
    HRBFNPR_ASSERT(wanted != nullptr);
    for (const MarkField& field : fields)
        if (std::strcmp(wanted, field.name.data()) == 0) return &field;
    return nullptr;
}

// Strokes are sorted by number whenever stroke_order is not empty, so a binary search can find a stroke.
std::int64_t Layer::stroke_of(std::int64_t mark) const noexcept {
    HRBFNPR_ASSERT(mark >= 0 && mark < count());
    if (!has_strokes()) return -1;
    const std::uint32_t* const first = stroke_first.begin();
    const std::uint32_t* const found =
        stroke_order.empty() ? std::upper_bound(first, stroke_first.end() - 1, static_cast<std::uint32_t>(mark))
                             : std::upper_bound(first, stroke_first.end() - 1, stroke[2 * mark],
                                                [&](std::uint32_t number, std::uint32_t place) {
                                                    return number < stroke[2 * std::int64_t{stroke_order[place]}];
                                                });
    return found - first - 1;
}

std::int64_t PointSet::bytes() const noexcept {
    std::int64_t sum = layers.bytes();
    for (const Layer& layer : layers) sum += layer.bytes();
    return sum;
}

std::int64_t PointSet::count() const noexcept {
    std::int64_t sum = 0;
    for (const Layer& layer : layers) sum += layer.count();
    return sum;
}

std::int64_t PointSet::largest() const noexcept {
    std::int64_t most = 0;
    for (const Layer& layer : layers) most = std::max(most, layer.whole_count());
    return most;
}

void index_strokes(Layer& layer, const base::Progress& progress) {
    const std::int64_t count = layer.count();
    HRBFNPR_ASSERT(layer.stroke.size() == 2 * count);
    const auto before = [&](std::int64_t a, std::int64_t b) {
        const std::uint32_t* const s = layer.stroke.data() + 2 * a;
        const std::uint32_t* const t = layer.stroke.data() + 2 * b;
        return s[0] != t[0] ? s[0] < t[0] : s[1] != t[1] ? s[1] < t[1] : a < b;
    };
    layer.stroke_first.clear();
    layer.stroke_order.clear();
    bool ordered = true;
    for (std::int64_t i = 1; i < count && ordered; ++i) ordered = before(i - 1, i);
    if (!ordered) {
        layer.stroke_order.resize_for_overwrite(count);
        for (std::int64_t i = 0; i < count; ++i) layer.stroke_order[i] = static_cast<std::uint32_t>(i);
        base::sort_long(layer.stroke_order.begin(), layer.stroke_order.end(), before, progress);
    }
    if (count == 0) return;
    layer.stroke_first.push_back(0);
    progress.check();
    for (std::int64_t place = 1; place < count; ++place)
        if (layer.stroke[2 * layer.mark_of(place)] != layer.stroke[2 * layer.mark_of(place - 1)])
            layer.stroke_first.push_back(static_cast<std::uint32_t>(place));
    layer.stroke_first.push_back(static_cast<std::uint32_t>(count));
}

} // namespace hrbfnpr::marks
