// SPDX-License-Identifier: MIT
// Making point sets by generation on a model.
#include "generate/generate.h"

#include "api/barrier.h"
#include "api/descriptor.h"
#include "api/fields.h"
#include "api/layers.h"
#include "api/lists.h"
#include "api/model.h"
#include "api/operation.h"
#include "api/point_set.h"
#include "api/views.h"

#include <numbers>

using namespace hrbfnpr;

static_assert(static_cast<int>(marks::Distribution::blue_noise) == HRBFNPR_DISTRIBUTION_BLUE_NOISE);
static_assert(static_cast<int>(marks::Distribution::published) == HRBFNPR_DISTRIBUTION_PUBLISHED);
static_assert(static_cast<int>(marks::Symmetry::line) == HRBFNPR_SYMMETRY_LINE);
static_assert(static_cast<int>(marks::Symmetry::cross) == HRBFNPR_SYMMETRY_CROSS);
static_assert(static_cast<int>(stipples::Density::uniform) == HRBFNPR_DENSITY_UNIFORM);
static_assert(static_cast<int>(stipples::Density::curvature) == HRBFNPR_DENSITY_CURVATURE);
static_assert(static_cast<int>(stipples::Density::callback) == HRBFNPR_DENSITY_CALLBACK);
static_assert(static_cast<int>(generate::ToneRanges::full) == HRBFNPR_TONE_RANGES_FULL);
static_assert(static_cast<int>(generate::ToneRanges::in_turn) == HRBFNPR_TONE_RANGES_IN_TURN);
static_assert(static_cast<int>(hatching::Guide::curvature) == HRBFNPR_HATCH_GUIDE_CURVATURE);
static_assert(static_cast<int>(hatching::Guide::combing) == HRBFNPR_HATCH_GUIDE_COMBING);
static_assert(static_cast<int>(hatching::Guide::sections) == HRBFNPR_HATCH_GUIDE_SECTIONS);
static_assert(static_cast<int>(hatching::Guide::light) == HRBFNPR_HATCH_GUIDE_LIGHT);
static_assert(static_cast<int>(hatching::Guide::silhouette) == HRBFNPR_HATCH_GUIDE_SILHOUETTE);
static_assert(static_cast<int>(marks::SeedSource::automatic) == HRBFNPR_SEED_AUTO);
static_assert(static_cast<int>(marks::SeedSource::samples) == HRBFNPR_SEED_SAMPLES);
static_assert(static_cast<int>(marks::SeedSource::box) == HRBFNPR_SEED_BOX);
static_assert(static_cast<int>(marks::SeedSource::points) == HRBFNPR_SEED_POINTS);

namespace hrbfnpr::api {

namespace {

using Layer = hrbfnpr_layer_desc;
using Generate = hrbfnpr_generate_desc;

// Of each room's settings those fields that it keeps.
constexpr auto layer_fields() noexcept {
    using To = generate::LayerSettings;
    return FieldTable{field("kind", &Layer::kind, &To::kind, rule::Any{}),
                      field("name", &Layer::name, rule::Any{}),
                      field("budget", &Layer::budget, &To::budget, rule::not_negative),
                      field("tone_begin", &Layer::tone_begin, rule::Any{}),
                      field("tone_end", &Layer::tone_end, rule::Any{}),
                      field("second_tone_begin", &Layer::second_tone_begin, rule::Any{}),
                      field("second_tone_end", &Layer::second_tone_end, rule::Any{}),
                      field("flags", &Layer::flags, rule::Flags{HRBFNPR_LAYER_WITH_CURVATURE}),
                      field("tone_smoothing", &Layer::tone_smoothing, &To::tone_smoothing, rule::Between{-1.0, 0.1})};
}
constexpr auto density_fields() noexcept {
    using To = stipples::DensitySettings;
    return FieldTable{
        field("density", &Layer::density, &To::kind, rule::OneOf{HRBFNPR_DENSITY_CALLBACK, "HRBFNPR_DENSITY_..."}),
        field("density_strength", &Layer::density_strength, &To::strength, rule::Between{0.0, 1.0}),
        field("density_function", &Layer::density_function, &To::function, rule::Any{}),
        field("density_user", &Layer::density_user, &To::user, rule::Any{})};
}
constexpr auto stroke_fields() noexcept {
    using To = strokes::Settings;
    return FieldTable{field("separation", &Layer::separation, &To::separation, rule::not_negative),
                      field("step", &Layer::step, &To::step, rule::not_negative),
                      field("length", &Layer::length, &To::longest, rule::not_negative),
                      field("symmetry", &Layer::symmetry, &To::symmetry,
                            rule::OneOf{HRBFNPR_SYMMETRY_CROSS, "HRBFNPR_SYMMETRY_..."})};
}
constexpr auto direction_fields() noexcept {
    using To = marks::DirectionFunction;
    return FieldTable{field("direction_function", &Layer::direction_function, &To::function, rule::Any{}),
                      field("direction_user", &Layer::direction_user, &To::user, rule::Any{})};
}
constexpr auto hatch_fields() noexcept {
    using To = hatching::FieldSettings;
    return FieldTable{field("angle", &Layer::angle, rule::Between{-360.0, 360.0}),
                      field("smoothing", &Layer::smoothing, &To::smoothing, rule::Between{1e-6, 1.0}),
                      field("axis", &Layer::axis, rule::Any{}),
                      field("axis_weight", &Layer::axis_weight, &To::axis_weight, rule::Between{0.0, 1e3}),
                      field("guide", &Layer::guide, &To::guide,
                            rule::OneOf{HRBFNPR_HATCH_GUIDE_SILHOUETTE, "HRBFNPR_HATCH_GUIDE_..."}),
                      reserved("reserved", &Layer::reserved),
                      field("guide_direction", &Layer::guide_direction, rule::Any{}),
                      field("guide_weight", &Layer::guide_weight, &To::guide_weight, rule::Between{0.0, 1.0})};
}
constexpr auto published_fields() noexcept {
    using To = published::Settings;
    return FieldTable{
        field("start", &Layer::start, &To::from_stipples,
              rule::OneOf{HRBFNPR_STROKE_START_STIPPLES, "HRBFNPR_STROKE_START_..."}),
        field("start_level", &Layer::start_level, &To::start_level, rule::Between{0.0, marks::most_levels}),
        field("levels", &Layer::levels, &To::levels, rule::Between{-1.0, marks::most_levels})};
}
static_assert(sizeof(void*) != 8 || layer_fields().bytes + density_fields().bytes + stroke_fields().bytes +
                                            direction_fields().bytes + published_fields().bytes + hatch_fields().bytes +
                                            sizeof(Layer::struct_size) ==
                                        sizeof(Layer));

constexpr auto generate_fields() noexcept {
    using To = generate::Settings;
    return FieldTable{
        field("distribution", &Generate::distribution, &To::distribution,
              rule::OneOf{HRBFNPR_DISTRIBUTION_PUBLISHED, "HRBFNPR_DISTRIBUTION_..."}),
        field("layers", &Generate::layers, rule::Any{}),
        field("layer_count", &Generate::layer_count, rule::Any{}),
        field("layer_stride", &Generate::layer_stride, rule::Any{}),
        field("shared_budget", &Generate::shared_budget, &To::shared_budget, rule::not_negative),
        field("tone_ranges", &Generate::tone_ranges, &To::tone_ranges,
              rule::OneOf{HRBFNPR_TONE_RANGES_IN_TURN, "HRBFNPR_TONE_RANGES_..."}),
        reserved("reserved", &Generate::reserved),
        field("projection_tolerance", &Generate::projection_tolerance, &To::projection_tolerance, rule::Positive{}),
        field("random_seed", &Generate::random_seed, &To::random_seed, rule::Any{})};
}
constexpr auto seed_fields() noexcept {
    using To = generate::SeedSettings;
    return FieldTable{
        field("seed_source", &Generate::seed_source, &To::source, rule::OneOf{HRBFNPR_SEED_POINTS, "HRBFNPR_SEED_..."}),
        field("seed_points", &Generate::seed_points, rule::Any{}),
        field("box_jitter", &Generate::box_jitter, &To::box_jitter, rule::Between{0.0, 0.5}),
        field("box_resolution", &Generate::box_resolution, &To::box_resolution, rule::Between{1.0, 256.0}),
        field("initial_step", &Generate::initial_step, &To::initial_step, rule::not_negative)};
}
static_assert(sizeof(void*) != 8 ||
              generate_fields().bytes + seed_fields().bytes + sizeof(Generate::struct_size) == sizeof(Generate));

} // namespace

template <>
hrbfnpr_layer_desc defaults() noexcept {
    const generate::LayerSettings settings;
    hrbfnpr_layer_desc desc{};
    layer_fields().set_defaults(settings, desc);
    density_fields().set_defaults(settings.density, desc);
    stroke_fields().set_defaults(settings.strokes, desc);
    published_fields().set_defaults(settings.published, desc);
    hatch_fields().set_defaults(settings.hatching.field, desc);
    for (int c = 0; c < 3; ++c) {
        desc.axis[c] = settings.hatching.field.axis[c];
        desc.guide_direction[c] = settings.hatching.field.guide_direction[c];
    }
    return desc;
}

template <>
hrbfnpr_generate_desc defaults() noexcept {
    const generate::Settings settings;
    hrbfnpr_generate_desc desc{};
    generate_fields().set_defaults(settings, desc);
    seed_fields().set_defaults(settings.seeds, desc);
    return desc;
}

namespace {

marks::TonePart checked_part(const char* owner, const char* field, float begin, float end) {
    if (!((begin == 0.0F && end == 0.0F) || (begin >= 0.0F && begin < end && end <= 1.0F)))
        fail(Status::invalid_argument, "%s.%sbegin is %g and .%send is %g; it must be 0 <= begin < end <= 1, or both 0",
             owner, field, static_cast<double>(begin), field, static_cast<double>(end));
    return {static_cast<double>(begin), static_cast<double>(end)};
}

glm::dvec3 checked_direction(const double (&given)[3], const char* field, const char* owner) {
    const glm::dvec3 direction(given[0], given[1], given[2]);
    const double length = glm::length(direction);
    if (!(length > 1e-150 && length < 1e150))
        fail(Status::invalid_argument, "%s.%s is (%g, %g, %g); it must have a direction", owner, field, direction.x,
             direction.y, direction.z);
    return direction / length;
}

void check(const hrbfnpr_layer_desc& desc, const char* owner) {
    if (desc.kind < HRBFNPR_LAYER_KIND_STIPPLES || desc.kind > HRBFNPR_LAYER_KIND_HATCH ||
        desc.kind == HRBFNPR_LAYER_KIND_OWN)
        fail(Status::invalid_argument,
             "%s.kind is %u; it must be HRBFNPR_LAYER_KIND_STIPPLES, PRINCIPAL, COMBING, FIELD (1 to 4) or HATCH (6)",
             owner, desc.kind);
    layer_fields().check(owner, desc);
    density_fields().check(owner, desc);
    stroke_fields().check(owner, desc);
    published_fields().check(owner, desc);
    hatch_fields().check(owner, desc);
    const Checks checks(owner);
    if (desc.density == HRBFNPR_DENSITY_CALLBACK) checks.given("density_function", desc.density_function != nullptr);
    if (desc.kind == HRBFNPR_LAYER_KIND_FIELD) checks.given("direction_function", desc.direction_function != nullptr);
}

generate::LayerSettings checked(const hrbfnpr_layer_desc& desc, const char* owner) {
    check(desc, owner);
    generate::LayerSettings settings;
    layer_fields().copy(desc, settings);
    density_fields().copy(desc, settings.density);
    stroke_fields().copy(desc, settings.strokes);
    direction_fields().copy(desc, settings.strokes.direction);
    published_fields().copy(desc, settings.published);
    hatch_fields().copy(desc, settings.hatching.field);
    settings.hatching.angle = desc.angle * std::numbers::pi / 180.0;
    settings.hatching.field.axis = checked_direction(desc.axis, "axis", owner);
    settings.hatching.field.guide_direction = checked_direction(desc.guide_direction, "guide_direction", owner);
    settings.name = checked_name(desc.name, owner);
    settings.with_curvature = (desc.flags & HRBFNPR_LAYER_WITH_CURVATURE) != 0;
    settings.part = {checked_part(owner, "tone_", desc.tone_begin, desc.tone_end),
                     checked_part(owner, "second_tone_", desc.second_tone_begin, desc.second_tone_end)};
    return settings;
}

generate::Settings checked(const hrbfnpr_generate_desc& desc) {
    generate_fields().check("generate_desc", desc);
    seed_fields().check("generate_desc", desc);
    generate::Settings settings;
    generate_fields().copy(desc, settings);
    seed_fields().copy(desc, settings.seeds);
    settings.seeds.points = in_view(desc.seed_points, "generate_desc.seed_points", points_type);
    if (desc.seed_source == HRBFNPR_SEED_POINTS && settings.seeds.points.empty())
        fail(Status::invalid_argument,
             "generate_desc.seed_points is empty; seed_source POINTS needs one point at least");
    const List<hrbfnpr_layer_desc> layers(desc.layers, desc.layer_count, desc.layer_stride, marks::most_layers,
                                          "generate_desc.layers");
    for (std::int64_t i = 0; i < layers.count(); ++i)
        settings.layers.push_back(checked(layers[i], layers.name(i).text));
    return generate::completed(std::move(settings));
}

hrbfnpr_point_set* generate(hrbfnpr_context& context, const hrbfnpr_model& model, const hrbfnpr_generate_desc& desc,
                            hrbfnpr_operation* operation) {
    const generate::Settings settings = checked(desc);
    const OperationUse use(operation);
    const generate::SampleHint samples = model.samples();
    generate::check_request(model.implicit(), settings);
    const implicit::Implicit& implicit =
        model.implicit_for(generate::expected_evaluations(samples, settings), use.progress());
    marks::PointSet set = generate::generate(context.runtime, implicit, samples, settings, use.progress());
    use.finish();
    return make_handle<hrbfnpr_point_set>(context, std::move(set));
}

double step_patches(const hrbfnpr_context& context, const hrbfnpr_model& model, const hrbfnpr_generate_desc& desc,
                    const hrbfnpr_array_out* corners, hrbfnpr_operation* operation) {
    const generate::Settings settings = checked(desc);
    const std::int64_t count = deref(corners, "corners").count;
    const base::OutView out = out_view(corners, "corners", {12, float_types}, count);
    const OperationUse use(operation);
    return generate::step_patches(context.runtime, model.implicit(), model.samples(), settings, out, use.progress());
}

} // namespace
} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_layer_desc_init(hrbfnpr_layer_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_generate_desc_init(hrbfnpr_generate_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_point_set_generate(hrbfnpr_context* context, const hrbfnpr_model* model,
                                          const hrbfnpr_generate_desc* desc, hrbfnpr_operation* operation,
                                          hrbfnpr_point_set** out_point_set, hrbfnpr_error* error) {
    return api::guarded_create(out_point_set, "out_point_set", error, [&] {
        return api::generate(api::deref(context, "context"), api::deref(model, "model"),
                             api::read_optional_struct(desc, "generate_desc"), operation);
    });
}

hrbfnpr_status hrbfnpr_point_set_step_patches(hrbfnpr_context* context, const hrbfnpr_model* model,
                                              const hrbfnpr_generate_desc* desc, const hrbfnpr_array_out* corners,
                                              double* step, hrbfnpr_operation* operation, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const double used = api::step_patches(api::deref(context, "context"), api::deref(model, "model"),
                                              api::read_optional_struct(desc, "generate_desc"), corners, operation);
        if (step != nullptr) *step = used;
    });
}

} // extern "C"
