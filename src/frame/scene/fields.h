// SPDX-License-Identifier: MIT
// The effects of fields on the marks of a run. A field gives a mark a value and a weight from 0 to 1. Where a value
// alone would change x to y, the mark gets x + weight (y - x).
//
// fields_of      a set, a layer and its style → RunFields, which refer to the values of the set
// effect_on      a mark → FieldEffect
// effects_on     consecutive marks → FieldRows, and bounds of all of them
#pragma once

#include "base/assert.h"
#include "frame/scene/style.h"
#include "marks/point_set.h"

#include <algorithm>

namespace hrbfnpr::frame {

// What fields do to a mark.
struct FieldEffect {
    float density = 1.0F; // a factor of the share of marks that is shown, from 0 to 1
    // The tone tau becomes tone_factor tau + tone_added, clamped to 0 … 1.
    float tone_factor = 1.0F, tone_added = 0.0F;
    float width = 1.0F; // a factor of radii and of widths

    [[nodiscard]] float tone(float tau) const noexcept {
        return std::clamp(tone_factor * tau + tone_added, 0.0F, 1.0F);
    }
};

// The effects on consecutive marks, and bounds for all of them.
struct FieldRows {
    FieldEffect effect[marks::most_in_cluster];
    float density[marks::most_in_cluster]; // the same as in `effect`, for loops over vectors
};
struct FieldBounds {
    float most_density = 1.0F;
    float least_tone_factor = 1.0F, least_tone_added = 0.0F;
    float most_width = 1.0F;

    // Returns a lower bound of the tones of the marks. `tau` is a lower bound without fields.
    [[nodiscard]] float least_tone(float tau) const noexcept {
        return std::clamp(least_tone_factor * tau + least_tone_added, 0.0F, 1.0F);
    }
};

// The fields that the style of a run names, except that for inks. NULL: the style names none, or the layer has no
// values of it.
struct RunFields {
    const marks::MarkField* density = nullptr;
    const marks::MarkField* tone = nullptr;
    const marks::MarkField* width = nullptr;
    const marks::MarkField* mask = nullptr;
    FieldRule tone_rule = FieldRule::replace;

    [[nodiscard]] bool any() const noexcept {
        return density != nullptr || tone != nullptr || width != nullptr || mask != nullptr;
    }

    [[nodiscard]] FieldEffect effect_on(std::int64_t mark) const noexcept {
        FieldEffect effect;
        if (density != nullptr) effect.density = blended(*density, mark, 1.0F);
        if (tone != nullptr) {
            const float weight = weight_of(*tone, mark);
            if (tone_rule == FieldRule::replace) {
                effect.tone_factor = 1.0F - weight;
                effect.tone_added = weight * std::clamp(tone->value[mark], 0.0F, 1.0F);
            } else {
                effect.tone_factor = blended(*tone, mark, most_factor);
            }
        }
        if (width != nullptr) effect.width = blended(*width, mark, most_factor);
        // A mark without any width would still be touched by the pen of a plotter.
        const bool is_left_out = (mask != nullptr && blended(*mask, mark, 1.0F) < 0.5F) || effect.width == 0.0F;
        if (is_left_out) effect.density = 0.0F;
        return effect;
    }

    // Sets the effects on marks. mark_at(i) is the index of the i-th of them.
    template <class MarkAt>
    FieldBounds effects_on(std::int64_t count, const MarkAt& mark_at, FieldRows& rows) const noexcept {
        HRBFNPR_ASSERT(count > 0 && count <= marks::most_in_cluster);
        FieldBounds bounds{0.0F, most_factor, 1.0F, 0.0F};
        for (std::int64_t i = 0; i < count; ++i) {
            const FieldEffect effect = effect_on(mark_at(i));
            rows.effect[i] = effect;
            rows.density[i] = effect.density;
            bounds.most_density = std::max(bounds.most_density, effect.density);
            bounds.least_tone_factor = std::min(bounds.least_tone_factor, effect.tone_factor);
            bounds.least_tone_added = std::min(bounds.least_tone_added, effect.tone_added);
            bounds.most_width = std::max(bounds.most_width, effect.width);
        }
        return bounds;
    }

    // The largest factor of a tone or a width.
    static constexpr float most_factor = 16.0F;

private:
    [[nodiscard]] static float weight_of(const marks::MarkField& field, std::int64_t mark) noexcept {
        return field.weight.empty() ? 1.0F : field.weight[mark];
    }
    // Returns 1 + weight (value - 1), with the value clamped to 0 … most.
    [[nodiscard]] static float blended(const marks::MarkField& field, std::int64_t mark, float most) noexcept {
        return 1.0F + weight_of(field, mark) * (std::clamp(field.value[mark], 0.0F, most) - 1.0F);
    }
};

// Finds the field `name` of a layer. Returns NULL if `name` is NULL, or if only other layers of the set have the field.
// `member` is the style's member that names it. Throws Error{invalid_argument}.
[[nodiscard]] const marks::MarkField* find_field(const marks::PointSet& set, std::int64_t layer, const char* name,
                                                 const char* member, marks::FieldKind kind, std::int64_t item);

// Finds the fields of a layer. `item` is the number of the item in messages. Throws Error{invalid_argument}.
[[nodiscard]] RunFields fields_of(const marks::PointSet& set, std::int64_t layer, const LayerStyle& style,
                                  std::int64_t item);

} // namespace hrbfnpr::frame
