// Making point sets: by generation on a model, or from the caller's arrays.
#include "sampling/generate.h"

#include "api/barrier.h"
#include "api/checks.h"
#include "api/descriptor.h"
#include "api/model.h"
#include "api/operation.h"
#include "api/point_set.h"
#include "api/views.h"
#include "sampling/cluster_marks.h"

#include <algorithm>
#include <array>
#include <cstdio>

using namespace hrbfnpr;
using sampling::group_count;

static_assert(static_cast<int>(sampling::Group::stipple) == HRBFNPR_GROUP_STIPPLE);
static_assert(static_cast<int>(sampling::Group::curvature) == HRBFNPR_GROUP_CURVATURE);
static_assert(static_cast<int>(sampling::Group::combing) == HRBFNPR_GROUP_COMBING);
static_assert(group_count == HRBFNPR_GROUP_COUNT);
static_assert(static_cast<int>(sampling::Distribution::blue_noise) == HRBFNPR_DISTRIBUTION_BLUE_NOISE);
static_assert(static_cast<int>(sampling::Distribution::paper) == HRBFNPR_DISTRIBUTION_PAPER);
static_assert(static_cast<int>(sampling::StrokeField::line) == HRBFNPR_STROKE_FIELD_LINE);
static_assert(static_cast<int>(sampling::StrokeField::cross) == HRBFNPR_STROKE_FIELD_CROSS);
static_assert(static_cast<int>(sampling::Density::uniform) == HRBFNPR_DENSITY_UNIFORM);
static_assert(static_cast<int>(sampling::Density::curvature) == HRBFNPR_DENSITY_CURVATURE);
static_assert(static_cast<int>(sampling::Density::callback) == HRBFNPR_DENSITY_CALLBACK);
static_assert(sampling::layer_count == HRBFNPR_LAYER_COUNT);
static_assert(static_cast<int>(sampling::SeedSource::automatic) == HRBFNPR_SEED_AUTO);
static_assert(static_cast<int>(sampling::SeedSource::samples) == HRBFNPR_SEED_SAMPLES);
static_assert(static_cast<int>(sampling::SeedSource::box) == HRBFNPR_SEED_BOX);
static_assert(static_cast<int>(sampling::SeedSource::points) == HRBFNPR_SEED_POINTS);

namespace hrbfnpr::api {

template <>
hrbfnpr_generate_desc defaults() noexcept {
    const sampling::GenerateSettings settings;
    hrbfnpr_generate_desc desc{};
    desc.groups = 1U << HRBFNPR_GROUP_STIPPLE;
    desc.distribution = static_cast<std::uint32_t>(settings.distribution);
    desc.seed_source = static_cast<std::uint32_t>(settings.seed_source);
    desc.box_resolution = static_cast<std::uint32_t>(settings.box_resolution);
    desc.box_jitter = settings.box_jitter;
    desc.initial_step = settings.initial_step;
    desc.projection_tolerance = settings.projection_tolerance;
    desc.random_seed = settings.random_seed;
    desc.group[HRBFNPR_GROUP_STIPPLE].levels = 4;
    desc.group[HRBFNPR_GROUP_CURVATURE].levels = 3;
    desc.group[HRBFNPR_GROUP_COMBING].levels = 3;
    desc.stroke_field = static_cast<std::uint32_t>(settings.stroke_field);
    desc.density_strength = settings.density.strength;
    return desc;
}

template <>
hrbfnpr_point_set_desc defaults() noexcept {
    hrbfnpr_point_set_desc desc{};
    desc.random_seed = 1;
    return desc;
}

namespace {

constexpr std::uint32_t all_groups = (1U << group_count) - 1;
constexpr std::uint32_t generate_flags = HRBFNPR_GENERATE_CURVATURE_OF_STIPPLES | HRBFNPR_GENERATE_CURVATURE_OF_COMBING;

// "generate_desc.group[1]"
struct GroupName {
    GroupName(const char* owner, int group) noexcept { std::snprintf(text, sizeof text, "%s.group[%d]", owner, group); }
    char text[48];
};

// Rules between a group's fields; its plain ranges have been checked.
void check_stipple_seeds(const hrbfnpr_generate_desc& desc, int group, const char* name) {
    const hrbfnpr_group_desc& wanted = desc.group[group];
    if (wanted.seeds != HRBFNPR_GROUP_SEED_STIPPLES) return;
    if (group == HRBFNPR_GROUP_STIPPLE)
        fail(Status::invalid_argument, "%s.seeds is STIPPLES; the stipples themselves start from SEEDS", name);
    if (desc.distribution != HRBFNPR_DISTRIBUTION_PAPER)
        fail(Status::invalid_argument, "%s.seeds is STIPPLES; only the PAPER distribution can start strokes there",
             name);
    const std::int32_t levels = desc.group[HRBFNPR_GROUP_STIPPLE].levels;
    if ((desc.groups & 1U << HRBFNPR_GROUP_STIPPLE) != 0 && wanted.seed_level > levels)
        fail(Status::invalid_argument, "%s.seed_level is %d, above the %d levels of the stipples", name,
             static_cast<int>(wanted.seed_level), static_cast<int>(levels));
}

sampling::GroupSettings checked_group(const hrbfnpr_generate_desc& desc, int group) {
    const hrbfnpr_group_desc& given = desc.group[group];
    sampling::GroupSettings settings;
    settings.wanted = (desc.groups >> group & 1U) != 0;
    if (!settings.wanted) return settings;
    const GroupName name("generate_desc", group);
    const Checks checks(name.text);
    checks.between("levels", given.levels, 0, sampling::most_levels);
    checks.one_of("seeds", given.seeds, HRBFNPR_GROUP_SEED_STIPPLES + 1, "HRBFNPR_GROUP_SEED_...");
    checks.between("seed_level", given.seed_level, 0, sampling::most_levels);
    checks.zero("reserved", given.reserved);
    checks.at_least("budget", static_cast<double>(given.budget), 0.0);
    check_stipple_seeds(desc, group, name.text);
    settings.levels = given.levels;
    settings.from_stipples = given.seeds == HRBFNPR_GROUP_SEED_STIPPLES;
    settings.seed_level = given.seed_level;
    settings.budget = given.budget;
    settings.with_curvature =
        group == HRBFNPR_GROUP_CURVATURE ||
        (group == HRBFNPR_GROUP_STIPPLE && (desc.flags & HRBFNPR_GENERATE_CURVATURE_OF_STIPPLES)) ||
        (group == HRBFNPR_GROUP_COMBING && (desc.flags & HRBFNPR_GENERATE_CURVATURE_OF_COMBING));
    return settings;
}

void check_numbers(const hrbfnpr_generate_desc& desc) {
    const Checks checks("generate_desc");
    checks.flags("groups", desc.groups, all_groups);
    if (desc.groups == 0)
        fail(Status::invalid_argument, "generate_desc.groups is 0; set a bit (1 << HRBFNPR_GROUP_...) at least");
    checks.one_of("distribution", desc.distribution, HRBFNPR_DISTRIBUTION_PAPER + 1, "HRBFNPR_DISTRIBUTION_...");
    checks.one_of("seed_source", desc.seed_source, HRBFNPR_SEED_POINTS + 1, "HRBFNPR_SEED_...");
    checks.flags("flags", desc.flags, generate_flags);
    checks.between("box_resolution", desc.box_resolution, 1, 256);
    checks.between("box_jitter", desc.box_jitter, 0.0, 0.5);
    checks.at_least("initial_step", desc.initial_step, 0.0);
    checks.positive("projection_tolerance", desc.projection_tolerance);
    checks.at_least("stroke_separation", desc.stroke_separation, 0.0);
    checks.at_least("stroke_step", desc.stroke_step, 0.0);
    checks.at_least("stroke_length", desc.stroke_length, 0.0);
    checks.one_of("stroke_field", desc.stroke_field, HRBFNPR_STROKE_FIELD_CROSS + 1, "HRBFNPR_STROKE_FIELD_...");
    checks.zero("reserved2", desc.reserved2);
    checks.one_of("order", desc.order, HRBFNPR_ORDER_LAYERED + 1, "HRBFNPR_ORDER_...");
    checks.at_least("shared_budget", static_cast<double>(desc.shared_budget), 0.0);
}

sampling::DensitySettings checked_density(const hrbfnpr_generate_desc& desc) {
    const Checks checks("generate_desc");
    checks.one_of("density", desc.density, HRBFNPR_DENSITY_CALLBACK + 1, "HRBFNPR_DENSITY_...");
    checks.between("density_strength", desc.density_strength, 0.0, 1.0);
    if (desc.density == HRBFNPR_DENSITY_CALLBACK) checks.given("density_function", desc.density_function != nullptr);
    return {static_cast<sampling::Density>(desc.density), desc.density_strength, desc.density_function,
            desc.density_user};
}

int group_of_layer(int layer) noexcept { return (layer + 1) / 2; }

// The layers that are made share the tones evenly in LAYERED order, but for those that say their part themselves.
void fill_layers(const hrbfnpr_generate_desc& desc, sampling::GenerateSettings& settings) {
    const auto made = [&](int layer) { return settings.group[static_cast<std::size_t>(group_of_layer(layer))].wanted; };
    double layers = 0.0;
    for (int layer = 0; layer < HRBFNPR_LAYER_COUNT; ++layer) layers += made(layer) ? 1.0 : 0.0;
    double before = 0.0;
    for (int layer = 0; layer < HRBFNPR_LAYER_COUNT; ++layer) {
        const hrbfnpr_layer& given = desc.layer[layer];
        sampling::TonePart& part = settings.layer[static_cast<std::size_t>(layer)];
        if (!(given.begin == 0.0F && given.end == 0.0F)) {
            if (!(given.begin >= 0.0F && given.begin < given.end && given.end <= 1.0F))
                fail(Status::invalid_argument,
                     "generate_desc.layer[%d] is from %g to %g; it must be 0 <= begin < end <= 1, or both 0", layer,
                     static_cast<double>(given.begin), static_cast<double>(given.end));
            part = {static_cast<double>(given.begin), static_cast<double>(given.end)};
        } else if (desc.order == HRBFNPR_ORDER_LAYERED && made(layer)) {
            part = {before / layers, (before + 1.0) / layers};
        }
        if (made(layer)) before += 1.0;
    }
}

// Each layer's marks in proportion to its part of the tones.
void share_budget(std::int64_t budget, sampling::GenerateSettings& settings) {
    if (budget == 0) return;
    std::array<double, group_count> share{};
    double all = 0.0;
    for (int layer = 0; layer < HRBFNPR_LAYER_COUNT; ++layer) {
        const auto group = static_cast<std::size_t>(group_of_layer(layer));
        if (!settings.group[group].wanted) continue;
        if (settings.group[group].budget != 0)
            fail(Status::invalid_argument,
                 "generate_desc.shared_budget is %lld and group[%d].budget is %lld: one of them must be 0",
                 static_cast<long long>(budget), static_cast<int>(group),
                 static_cast<long long>(settings.group[group].budget));
        share[group] += settings.layer[static_cast<std::size_t>(layer)].length();
        all += settings.layer[static_cast<std::size_t>(layer)].length();
    }
    for (std::size_t group = 0; group < share.size(); ++group)
        if (share[group] > 0.0)
            settings.group[group].budget =
                std::max<std::int64_t>(1, static_cast<std::int64_t>(static_cast<double>(budget) * share[group] / all));
}

sampling::GenerateSettings checked(const hrbfnpr_generate_desc& desc) {
    check_numbers(desc);
    sampling::GenerateSettings settings;
    settings.distribution = static_cast<sampling::Distribution>(desc.distribution);
    settings.seed_source = static_cast<sampling::SeedSource>(desc.seed_source);
    settings.box_resolution = static_cast<std::int32_t>(desc.box_resolution);
    settings.box_jitter = desc.box_jitter;
    settings.initial_step = desc.initial_step;
    settings.projection_tolerance = desc.projection_tolerance;
    settings.random_seed = desc.random_seed;
    settings.stroke_separation = desc.stroke_separation;
    settings.stroke_step = desc.stroke_step;
    settings.stroke_length = desc.stroke_length;
    settings.stroke_field = static_cast<sampling::StrokeField>(desc.stroke_field);
    settings.seed_points = in_view(desc.seed_points, "generate_desc.seed_points", points_type);
    if (desc.seed_source == HRBFNPR_SEED_POINTS && settings.seed_points.empty())
        fail(Status::invalid_argument,
             "generate_desc.seed_points is empty; seed_source POINTS needs one point at least");
    for (int group = 0; group < group_count; ++group)
        settings.group[static_cast<std::size_t>(group)] = checked_group(desc, group);
    settings.density = checked_density(desc);
    fill_layers(desc, settings);
    share_budget(desc.shared_budget, settings);
    return settings;
}

hrbfnpr_point_set* generate(hrbfnpr_context& context, const hrbfnpr_model& model, const hrbfnpr_generate_desc& desc,
                            hrbfnpr_operation* operation) {
    const sampling::GenerateSettings settings = checked(desc);
    const OperationUse use(operation);
    const sampling::SampleHint samples = model.samples();
    sampling::check_request(model.implicit(), settings);
    const implicit::Implicit& implicit =
        model.implicit_for(sampling::expected_evaluations(samples, settings), use.progress());
    sampling::PointSet set = sampling::generate(context.runtime, implicit, samples, settings, use.progress());
    sampling::cluster_marks(context.runtime, set, use.progress());
    use.finish();
    for (const sampling::MarkGroup& group : set.group)
        if (group.count() > 0)
            context.runtime.log(base::LogLevel::info, "generate: %lld marks in group %d in %.3f s",
                                static_cast<long long>(group.count()), static_cast<int>(&group - set.group.data()),
                                group.report.seconds);
    return make_handle<hrbfnpr_point_set>(context, std::move(set));
}

double step_patches(const hrbfnpr_context& context, const hrbfnpr_model& model, const hrbfnpr_generate_desc& desc,
                    const hrbfnpr_array_out* corners, hrbfnpr_operation* operation) {
    const sampling::GenerateSettings settings = checked(desc);
    const std::int64_t count = deref(corners, "corners").count;
    const base::OutView out = out_view(corners, "corners", {12, float_types}, count);
    const OperationUse use(operation);
    const double step =
        sampling::step_patches(context.runtime, model.implicit(), model.samples(), settings, out, use.progress());
    use.finish();
    return step;
}

sampling::GroupArrays checked(const hrbfnpr_group_arrays& arrays, int group) {
    const auto view = [&](const hrbfnpr_array& array, const char* field, ArrayType type) {
        char name[64];
        std::snprintf(name, sizeof name, "%s.%s", GroupName("point_set_desc", group).text, field);
        return in_view(array, name, type);
    };
    return {view(arrays.position, "position", points_type),   view(arrays.normal, "normal", points_type),
            view(arrays.direction, "direction", points_type), view(arrays.curvature, "curvature", points_type),
            view(arrays.rank, "rank", number_type),           view(arrays.level, "level", {1, uint8_only}),
            view(arrays.stroke, "stroke", {2, uint32_only}),  view(arrays.width, "width", number_type)};
}

hrbfnpr_point_set* from_arrays(hrbfnpr_context& context, const hrbfnpr_point_set_desc& desc) {
    Checks("point_set_desc").zero("reserved", desc.reserved);
    std::array<sampling::GroupArrays, group_count> arrays;
    for (int group = 0; group < group_count; ++group)
        arrays[static_cast<std::size_t>(group)] = checked(desc.group[group], group);
    return adopt(context, sampling::from_arrays(context.runtime, arrays, desc.random_seed));
}

} // namespace
} // namespace hrbfnpr::api

extern "C" {

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

hrbfnpr_status hrbfnpr_point_set_desc_init(hrbfnpr_point_set_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_point_set_create_from_arrays(hrbfnpr_context* context, const hrbfnpr_point_set_desc* desc,
                                                    hrbfnpr_point_set** out_point_set, hrbfnpr_error* error) {
    return api::guarded_create(out_point_set, "out_point_set", error, [&] {
        return api::from_arrays(api::deref(context, "context"), api::read_struct(desc, "point_set_desc"));
    });
}

} // extern "C"
