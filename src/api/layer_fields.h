// SPDX-License-Identifier: MIT
// The fields of hrbfnpr_layer_desc, and the settings of the rooms that make layers of marks.
#pragma once

#include "api/fields.h"
#include "generate/settings.h"

#include <hrbfnpr.h>

namespace hrbfnpr::api {

static_assert(static_cast<int>(stipples::Density::uniform) == HRBFNPR_DENSITY_UNIFORM);
static_assert(static_cast<int>(stipples::Density::curvature) == HRBFNPR_DENSITY_CURVATURE);
static_assert(static_cast<int>(stipples::Density::callback) == HRBFNPR_DENSITY_CALLBACK);
static_assert(HRBFNPR_DENSITY_FIELD > HRBFNPR_DENSITY_CALLBACK);
static_assert(static_cast<int>(hatching::Guide::curvature) == HRBFNPR_HATCH_GUIDE_CURVATURE);
static_assert(static_cast<int>(hatching::Guide::combing) == HRBFNPR_HATCH_GUIDE_COMBING);
static_assert(static_cast<int>(hatching::Guide::sections) == HRBFNPR_HATCH_GUIDE_SECTIONS);
static_assert(static_cast<int>(hatching::Guide::light) == HRBFNPR_HATCH_GUIDE_LIGHT);
static_assert(static_cast<int>(hatching::Guide::silhouette) == HRBFNPR_HATCH_GUIDE_SILHOUETTE);

// Each function below returns the table of the fields that one room stores in its settings for a layer.
[[nodiscard]] constexpr auto layer_fields() noexcept {
    using Given = hrbfnpr_layer_desc;
    using To = generate::LayerSettings;
    return FieldTable{field("kind", &Given::kind, &To::kind, rule::Any{}),
                      field("name", &Given::name, rule::Any{}),
                      field("budget", &Given::budget, &To::budget, rule::not_negative),
                      field("tone_begin", &Given::tone_begin, rule::Any{}),
                      field("tone_end", &Given::tone_end, rule::Any{}),
                      field("second_tone_begin", &Given::second_tone_begin, rule::Any{}),
                      field("second_tone_end", &Given::second_tone_end, rule::Any{}),
                      field("flags", &Given::flags, rule::Flags{HRBFNPR_LAYER_WITH_CURVATURE}),
                      field("tone_smoothing", &Given::tone_smoothing, &To::tone_smoothing, rule::Between{-1.0, 0.1}),
                      field("density_field", &Given::density_field, rule::Any{}),
                      field("direction_field", &Given::direction_field, rule::Any{})};
}
[[nodiscard]] constexpr auto density_fields() noexcept {
    using Given = hrbfnpr_layer_desc;
    using To = stipples::DensitySettings;
    return FieldTable{
        field("density", &Given::density, &To::kind, rule::OneOf{HRBFNPR_DENSITY_FIELD, "HRBFNPR_DENSITY_*"}),
        field("density_strength", &Given::density_strength, &To::strength, rule::Between{0.0, 1.0}),
        field("density_function", &Given::density_function, &To::function, rule::Any{}),
        field("density_user", &Given::density_user, &To::user, rule::Any{})};
}
[[nodiscard]] constexpr auto direction_fields() noexcept {
    using Given = hrbfnpr_layer_desc;
    using To = marks::DirectionFunction;
    return FieldTable{field("direction_function", &Given::direction_function, &To::function, rule::Any{}),
                      field("direction_user", &Given::direction_user, &To::user, rule::Any{})};
}
[[nodiscard]] constexpr auto hatch_fields() noexcept {
    using Given = hrbfnpr_layer_desc;
    using To = hatching::Settings;
    return FieldTable{field("separation", &Given::separation, &To::separation, rule::not_negative),
                      field("step", &Given::step, &To::step, rule::not_negative),
                      field("angle", &Given::angle, rule::Between{-360.0, 360.0})};
}
[[nodiscard]] constexpr auto guide_fields() noexcept {
    using Given = hrbfnpr_layer_desc;
    using To = hatching::FieldSettings;
    return FieldTable{
        field("smoothing", &Given::smoothing, &To::smoothing, rule::Between{1e-6, 1.0}),
        field("axis", &Given::axis, rule::Any{}),
        field("axis_weight", &Given::axis_weight, &To::axis_weight, rule::Between{0.0, 1e3}),
        field("guide", &Given::guide, &To::guide, rule::OneOf{HRBFNPR_HATCH_GUIDE_SILHOUETTE, "HRBFNPR_HATCH_GUIDE_*"}),
        field("guide_direction", &Given::guide_direction, rule::Any{}),
        field("guide_weight", &Given::guide_weight, &To::guide_weight, rule::Between{0.0, 1.0})};
}
[[nodiscard]] constexpr auto published_fields() noexcept {
    using Given = hrbfnpr_layer_desc;
    using To = published::Settings;
    return FieldTable{
        field("start", &Given::start, &To::from_stipples,
              rule::OneOf{HRBFNPR_STROKE_START_STIPPLES, "HRBFNPR_STROKE_START_*"}),
        field("start_level", &Given::start_level, &To::start_level, rule::Between{0.0, marks::most_levels}),
        field("levels", &Given::levels, &To::levels, rule::Between{-1.0, marks::most_levels})};
}
static_assert(sizeof(void*) != 8 || layer_fields().bytes + density_fields().bytes + direction_fields().bytes +
                                            published_fields().bytes + hatch_fields().bytes + guide_fields().bytes +
                                            sizeof(hrbfnpr_layer_desc::struct_size) ==
                                        sizeof(hrbfnpr_layer_desc));

// Returns the defaults as a constant.
[[nodiscard]] constexpr hrbfnpr_layer_desc default_layer_desc() noexcept {
    const generate::LayerSettings settings;
    hrbfnpr_layer_desc desc{};
    desc.struct_size = sizeof desc;
    layer_fields().set_defaults(settings, desc);
    density_fields().set_defaults(settings.density, desc);
    direction_fields().set_defaults(settings.hatching.direction, desc);
    published_fields().set_defaults(settings.published, desc);
    hatch_fields().set_defaults(settings.hatching, desc);
    guide_fields().set_defaults(settings.hatching.field, desc);
    for (int c = 0; c < 3; ++c) {
        desc.axis[c] = settings.hatching.field.axis[c];
        desc.guide_direction[c] = settings.hatching.field.guide_direction[c];
    }
    return desc;
}

} // namespace hrbfnpr::api
