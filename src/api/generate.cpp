// SPDX-License-Identifier: MIT
// Makes point sets by generating marks on a model.
#include "generate/generate.h"

#include "api/barrier.h"
#include "api/descriptor.h"
#include "api/field.h"
#include "api/fields.h"
#include "api/layer_fields.h"
#include "api/layers.h"
#include "api/lists.h"
#include "api/model.h"
#include "api/operation.h"
#include "api/point_set.h"
#include "api/still.h"
#include "api/views.h"

#include <algorithm>
#include <array>
#include <numbers>

using namespace hrbfnpr;

static_assert(static_cast<int>(marks::Distribution::blue_noise) == HRBFNPR_DISTRIBUTION_BLUE_NOISE);
static_assert(static_cast<int>(marks::Distribution::published) == HRBFNPR_DISTRIBUTION_PUBLISHED);
static_assert(static_cast<int>(generate::ToneRanges::full) == HRBFNPR_TONE_RANGES_FULL);
static_assert(static_cast<int>(generate::ToneRanges::in_turn) == HRBFNPR_TONE_RANGES_IN_TURN);
static_assert(static_cast<int>(marks::SeedSource::automatic) == HRBFNPR_SEED_AUTO);
static_assert(static_cast<int>(marks::SeedSource::samples) == HRBFNPR_SEED_SAMPLES);
static_assert(static_cast<int>(marks::SeedSource::box) == HRBFNPR_SEED_BOX);
static_assert(static_cast<int>(marks::SeedSource::points) == HRBFNPR_SEED_POINTS);

namespace hrbfnpr::api {

namespace {

using Generate = hrbfnpr_generate_desc;

constexpr auto generate_fields() noexcept {
    using To = generate::Settings;
    return FieldTable{
        field("distribution", &Generate::distribution, &To::distribution,
              rule::OneOf{HRBFNPR_DISTRIBUTION_PUBLISHED, "HRBFNPR_DISTRIBUTION_*"}),
        field("layers", &Generate::layers, rule::Any{}),
        field("layer_count", &Generate::layer_count, rule::Any{}),
        field("layer_stride", &Generate::layer_stride, rule::Any{}),
        field("shared_budget", &Generate::shared_budget, &To::shared_budget, rule::not_negative),
        field("tone_ranges", &Generate::tone_ranges, &To::tone_ranges,
              rule::OneOf{HRBFNPR_TONE_RANGES_IN_TURN, "HRBFNPR_TONE_RANGES_*"}),
        reserved("reserved", &Generate::reserved),
        field("projection_tolerance", &Generate::projection_tolerance, &To::projection_tolerance, rule::Positive{}),
        field("random_seed", &Generate::random_seed, &To::random_seed, rule::Any{})};
}
constexpr auto seed_fields() noexcept {
    using To = generate::SeedSettings;
    return FieldTable{
        field("seed_source", &Generate::seed_source, &To::source, rule::OneOf{HRBFNPR_SEED_POINTS, "HRBFNPR_SEED_*"}),
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
    return default_layer_desc();
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
        fail(Status::invalid_argument,
             "%s.%sbegin is %g and %send is %g; they must be 0 <= begin < end <= 1, or both 0", owner, field,
             static_cast<double>(begin), field, static_cast<double>(end));
    return {static_cast<double>(begin), static_cast<double>(end)};
}

glm::dvec3 checked_direction(const double (&given)[3], const char* field, const char* owner) {
    const glm::dvec3 direction(given[0], given[1], given[2]);
    const double length = glm::length(direction);
    if (!(length > 1e-150 && length < 1e150))
        fail(Status::invalid_argument, "%s.%s is (%g, %g, %g); it must be a finite vector other than zero", owner,
             field, direction.x, direction.y, direction.z);
    return direction / length;
}

// The next two functions implement hrbfnpr_density_fn and hrbfnpr_direction_fn. Their `user` is a hrbfnpr_field.
std::int32_t density_of_field(void* user, std::int64_t count, const double* positions, const double* normals,
                              double* density) {
    const auto& handle = *static_cast<const hrbfnpr_field*>(user);
    handle.field.evaluate(
        handle.runtime(), count, [&](std::int64_t i) { return paint::place_at(positions, normals, i); },
        [&](std::int64_t i, const paint::Sample& sample) {
            density[i] = 1.0 + sample.weight * (std::clamp(sample.value.x, 0.0, 1.0) - 1.0);
        });
    return 0;
}

std::int32_t direction_of_field(void* user, std::int64_t count, const double* positions, const double* normals,
                                double* directions) {
    const auto& handle = *static_cast<const hrbfnpr_field*>(user);
    handle.field.evaluate(
        handle.runtime(), count, [&](std::int64_t i) { return paint::place_at(positions, normals, i); },
        [&](std::int64_t i, const paint::Sample& sample) {
            for (int c = 0; c < 3; ++c) directions[3 * i + c] = sample.weight < 0.5 ? 0.0 : sample.value[c];
        });
    return 0;
}

void check_kind(const hrbfnpr_field& given, paint::FieldKind kind, const char* owner, const char* name) {
    constexpr std::array<const char*, paint::field_kind_count> names = {"SCALAR", "COLOUR", "DIRECTION"};
    const paint::FieldKind own = given.field.kind();
    if (own != kind)
        fail(Status::invalid_argument, "%s.%s is a field of kind %s; it must be one of kind %s", owner, name,
             names[static_cast<std::size_t>(own)], names[static_cast<std::size_t>(kind)]);
}

void check_fields(const hrbfnpr_layer_desc& desc, const char* owner) {
    if (desc.density == HRBFNPR_DENSITY_FIELD) {
        Checks(owner).not_null("density_field", desc.density_field != nullptr);
        check_kind(*desc.density_field, paint::FieldKind::scalar, owner, "density_field");
    }
    if (desc.direction_field == nullptr) return;
    check_kind(*desc.direction_field, paint::FieldKind::direction, owner, "direction_field");
    if (desc.direction_function != nullptr)
        fail(Status::invalid_argument, "%s has a direction_field and a direction_function; leave one out", owner);
}

// Makes a layer use its fields as functions of density and direction.
void use_fields(const hrbfnpr_layer_desc& desc, generate::LayerSettings& settings) {
    if (desc.density == HRBFNPR_DENSITY_FIELD) {
        settings.density.kind = stipples::Density::callback;
        settings.density.function = density_of_field;
        settings.density.user = const_cast<hrbfnpr_field*>(desc.density_field);
    }
    if (desc.direction_field != nullptr)
        settings.hatching.direction = {direction_of_field, const_cast<hrbfnpr_field*>(desc.direction_field)};
}

void check(const hrbfnpr_layer_desc& desc, const char* owner) {
    if (desc.kind != HRBFNPR_LAYER_KIND_STIPPLES && desc.kind != HRBFNPR_LAYER_KIND_HATCH)
        fail(Status::invalid_argument, "%s.kind is %u; it must be HRBFNPR_LAYER_KIND_STIPPLES or _HATCH (1 or 2)",
             owner, desc.kind);
    layer_fields().check(owner, desc);
    density_fields().check(owner, desc);
    published_fields().check(owner, desc);
    hatch_fields().check(owner, desc);
    guide_fields().check(owner, desc);
    const Checks checks(owner);
    if (desc.density == HRBFNPR_DENSITY_CALLBACK) checks.not_null("density_function", desc.density_function != nullptr);
    check_fields(desc, owner);
}

generate::LayerSettings checked(const hrbfnpr_layer_desc& desc, const char* owner) {
    check(desc, owner);
    generate::LayerSettings settings;
    layer_fields().copy(desc, settings);
    density_fields().copy(desc, settings.density);
    direction_fields().copy(desc, settings.hatching.direction);
    use_fields(desc, settings);
    published_fields().copy(desc, settings.published);
    hatch_fields().copy(desc, settings.hatching);
    guide_fields().copy(desc, settings.hatching.field);
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
             "generate_desc.seed_points is empty; seed_source POINTS needs at least one point");
    const List<hrbfnpr_layer_desc> layers(desc.layers, desc.layer_count, desc.layer_stride, marks::most_layers,
                                          "generate_desc.layers");
    for (std::int64_t i = 0; i < layers.count(); ++i)
        settings.layers.push_back(checked(layers[i], layers.name(i).text));
    return generate::completed(std::move(settings));
}

hrbfnpr_point_set* generate(hrbfnpr_context& context, const hrbfnpr_model& model, const hrbfnpr_generate_desc& desc,
                            const frame::Still* still, hrbfnpr_operation* operation) {
    generate::Settings settings = checked(desc);
    settings.still = still;
    const OperationUse use(operation);
    const generate::SampleHint samples = model.samples();
    generate::check_request(model.implicit(), settings);
    const implicit::Implicit& implicit =
        model.implicit_for(generate::expected_evaluations(samples, settings), use.progress());
    marks::PointSet set = generate::generate({context.runtime, use.progress()}, implicit, samples, settings);
    use.finish();
    return make_handle<hrbfnpr_point_set>(context, std::move(set));
}

double step_patches(const hrbfnpr_context& context, const hrbfnpr_model& model, const hrbfnpr_generate_desc& desc,
                    const hrbfnpr_array_out* corners, hrbfnpr_operation* operation) {
    const generate::Settings settings = checked(desc);
    const std::int64_t count = deref(corners, "corners").count;
    const base::OutView out = out_view(corners, "corners", {12, float_types}, count);
    const OperationUse use(operation);
    return generate::step_patches({context.runtime, use.progress()}, model.implicit(), model.samples(), settings, out);
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
                             api::read_optional_struct(desc, "generate_desc"), nullptr, operation);
    });
}

hrbfnpr_status hrbfnpr_point_set_generate_still(hrbfnpr_context* context, const hrbfnpr_model* model,
                                                const hrbfnpr_generate_desc* desc, const hrbfnpr_item* item,
                                                const hrbfnpr_camera* camera, hrbfnpr_operation* operation,
                                                hrbfnpr_point_set** out_point_set, hrbfnpr_error* error) {
    return api::guarded_create(out_point_set, "out_point_set", error, [&] {
        hrbfnpr_context& own = api::deref(context, "context");
        const api::CheckedStill still(own.runtime.memory, api::read_struct(item, "item"),
                                      api::read_struct(camera, "camera"));
        return api::generate(own, api::deref(model, "model"), api::read_optional_struct(desc, "generate_desc"),
                             &still.still, operation);
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
