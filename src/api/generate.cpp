// SPDX-License-Identifier: MIT
// Making point sets by generation on a model.
#include "generate/generate.h"

#include "api/barrier.h"
#include "api/checks.h"
#include "api/descriptor.h"
#include "api/layers.h"
#include "api/lists.h"
#include "api/model.h"
#include "api/operation.h"
#include "api/point_set.h"
#include "api/views.h"

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
static_assert(static_cast<int>(marks::SeedSource::automatic) == HRBFNPR_SEED_AUTO);
static_assert(static_cast<int>(marks::SeedSource::samples) == HRBFNPR_SEED_SAMPLES);
static_assert(static_cast<int>(marks::SeedSource::box) == HRBFNPR_SEED_BOX);
static_assert(static_cast<int>(marks::SeedSource::points) == HRBFNPR_SEED_POINTS);

namespace hrbfnpr::api {

template <>
hrbfnpr_layer_desc defaults() noexcept {
    const generate::LayerSettings settings;
    hrbfnpr_layer_desc desc{};
    desc.kind = static_cast<std::uint32_t>(settings.kind);
    desc.budget = settings.budget;
    desc.density = static_cast<std::uint32_t>(settings.density.kind);
    desc.density_strength = settings.density.strength;
    desc.symmetry = static_cast<std::uint32_t>(settings.strokes.symmetry);
    desc.levels = settings.published.levels;
    return desc;
}

template <>
hrbfnpr_generate_desc defaults() noexcept {
    const generate::Settings settings;
    hrbfnpr_generate_desc desc{};
    desc.distribution = static_cast<std::uint32_t>(settings.distribution);
    desc.seed_source = static_cast<std::uint32_t>(settings.seeds.source);
    desc.box_resolution = static_cast<std::uint32_t>(settings.seeds.box_resolution);
    desc.box_jitter = settings.seeds.box_jitter;
    desc.initial_step = settings.seeds.initial_step;
    desc.projection_tolerance = settings.projection_tolerance;
    desc.random_seed = settings.random_seed;
    return desc;
}

namespace {

marks::TonePart checked_part(const char* owner, const char* field, float begin, float end) {
    if (!((begin == 0.0F && end == 0.0F) || (begin >= 0.0F && begin < end && end <= 1.0F)))
        fail(Status::invalid_argument, "%s.%sbegin is %g and .%send is %g; it must be 0 <= begin < end <= 1, or both 0",
             owner, field, static_cast<double>(begin), field, static_cast<double>(end));
    return {static_cast<double>(begin), static_cast<double>(end)};
}

stipples::DensitySettings checked_density(const Checks& checks, const hrbfnpr_layer_desc& desc) {
    checks.one_of("density", desc.density, HRBFNPR_DENSITY_CALLBACK + 1, "HRBFNPR_DENSITY_...");
    checks.between("density_strength", desc.density_strength, 0.0, 1.0);
    if (desc.density == HRBFNPR_DENSITY_CALLBACK) checks.given("density_function", desc.density_function != nullptr);
    return {static_cast<stipples::Density>(desc.density), desc.density_strength, desc.density_function,
            desc.density_user};
}

strokes::Settings checked_strokes(const Checks& checks, const hrbfnpr_layer_desc& desc) {
    checks.at_least("separation", desc.separation, 0.0);
    checks.at_least("step", desc.step, 0.0);
    checks.at_least("length", desc.length, 0.0);
    checks.one_of("symmetry", desc.symmetry, HRBFNPR_SYMMETRY_CROSS + 1, "HRBFNPR_SYMMETRY_...");
    if (desc.kind == HRBFNPR_LAYER_KIND_FIELD) checks.given("direction_function", desc.direction_function != nullptr);
    strokes::Settings settings;
    settings.separation = desc.separation;
    settings.step = desc.step;
    settings.longest = desc.length;
    settings.symmetry = static_cast<marks::Symmetry>(desc.symmetry);
    settings.direction = {desc.direction_function, desc.direction_user};
    return settings;
}

published::Settings checked_published(const Checks& checks, const hrbfnpr_layer_desc& desc) {
    checks.one_of("start", desc.start, HRBFNPR_STROKE_START_STIPPLES + 1, "HRBFNPR_STROKE_START_...");
    checks.between("start_level", desc.start_level, 0, marks::most_levels);
    checks.between("levels", desc.levels, -1, marks::most_levels);
    return {desc.levels, desc.start == HRBFNPR_STROKE_START_STIPPLES, desc.start_level};
}

generate::LayerSettings checked(const hrbfnpr_layer_desc& desc, const char* owner) {
    const Checks checks(owner);
    if (desc.kind < HRBFNPR_LAYER_KIND_STIPPLES || desc.kind > HRBFNPR_LAYER_KIND_FIELD)
        fail(Status::invalid_argument,
             "%s.kind is %u; it must be HRBFNPR_LAYER_KIND_STIPPLES, PRINCIPAL, COMBING or FIELD (1 to 4)", owner,
             desc.kind);
    checks.flags("flags", desc.flags, HRBFNPR_LAYER_WITH_CURVATURE);
    checks.at_least("budget", static_cast<double>(desc.budget), 0.0);
    generate::LayerSettings settings;
    settings.kind = static_cast<marks::Kind>(desc.kind);
    settings.name = checked_name(desc.name, owner);
    settings.budget = desc.budget;
    settings.with_curvature = (desc.flags & HRBFNPR_LAYER_WITH_CURVATURE) != 0;
    settings.part = {checked_part(owner, "tone_", desc.tone_begin, desc.tone_end),
                     checked_part(owner, "second_tone_", desc.second_tone_begin, desc.second_tone_end)};
    settings.density = checked_density(checks, desc);
    settings.strokes = checked_strokes(checks, desc);
    settings.published = checked_published(checks, desc);
    return settings;
}

void check_numbers(const hrbfnpr_generate_desc& desc) {
    const Checks checks("generate_desc");
    checks.one_of("distribution", desc.distribution, HRBFNPR_DISTRIBUTION_PUBLISHED + 1, "HRBFNPR_DISTRIBUTION_...");
    checks.at_least("shared_budget", static_cast<double>(desc.shared_budget), 0.0);
    checks.one_of("tone_ranges", desc.tone_ranges, HRBFNPR_TONE_RANGES_IN_TURN + 1, "HRBFNPR_TONE_RANGES_...");
    checks.one_of("seed_source", desc.seed_source, HRBFNPR_SEED_POINTS + 1, "HRBFNPR_SEED_...");
    checks.between("box_jitter", desc.box_jitter, 0.0, 0.5);
    checks.between("box_resolution", desc.box_resolution, 1, 256);
    checks.zero("reserved", desc.reserved);
    checks.at_least("initial_step", desc.initial_step, 0.0);
    checks.positive("projection_tolerance", desc.projection_tolerance);
}

generate::Settings checked(const hrbfnpr_generate_desc& desc) {
    check_numbers(desc);
    generate::Settings settings;
    settings.distribution = static_cast<marks::Distribution>(desc.distribution);
    settings.shared_budget = desc.shared_budget;
    settings.tone_ranges = static_cast<generate::ToneRanges>(desc.tone_ranges);
    settings.seeds.source = static_cast<marks::SeedSource>(desc.seed_source);
    settings.seeds.box_resolution = static_cast<std::int32_t>(desc.box_resolution);
    settings.seeds.box_jitter = desc.box_jitter;
    settings.seeds.initial_step = desc.initial_step;
    settings.projection_tolerance = desc.projection_tolerance;
    settings.random_seed = desc.random_seed;
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
    const double step =
        generate::step_patches(context.runtime, model.implicit(), model.samples(), settings, out, use.progress());
    use.finish();
    return step;
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
