// Making point sets: by generation on a model, or from the caller's arrays.
#include "generate/generate.h"

#include "api/barrier.h"
#include "api/checks.h"
#include "api/descriptor.h"
#include "api/model.h"
#include "api/operation.h"
#include "api/point_set.h"
#include "api/views.h"
#include "marks/cluster_marks.h"
#include "marks/from_arrays.h"

#include <algorithm>
#include <array>
#include <cstdio>

using namespace hrbfnpr;
using marks::group_count;

static_assert(static_cast<int>(marks::Group::stipple) == HRBFNPR_GROUP_STIPPLE);
static_assert(static_cast<int>(marks::Group::curvature) == HRBFNPR_GROUP_CURVATURE);
static_assert(static_cast<int>(marks::Group::combing) == HRBFNPR_GROUP_COMBING);
static_assert(group_count == HRBFNPR_GROUP_COUNT);
static_assert(static_cast<int>(marks::Distribution::blue_noise) == HRBFNPR_DISTRIBUTION_BLUE_NOISE);
static_assert(static_cast<int>(marks::Distribution::published) == HRBFNPR_DISTRIBUTION_PAPER);
static_assert(static_cast<int>(marks::StrokeField::line) == HRBFNPR_STROKE_FIELD_LINE);
static_assert(static_cast<int>(marks::StrokeField::cross) == HRBFNPR_STROKE_FIELD_CROSS);
static_assert(static_cast<int>(stipples::Density::uniform) == HRBFNPR_DENSITY_UNIFORM);
static_assert(static_cast<int>(stipples::Density::curvature) == HRBFNPR_DENSITY_CURVATURE);
static_assert(static_cast<int>(stipples::Density::callback) == HRBFNPR_DENSITY_CALLBACK);
static_assert(generate::layer_count == HRBFNPR_LAYER_COUNT);
static_assert(static_cast<int>(marks::SeedSource::automatic) == HRBFNPR_SEED_AUTO);
static_assert(static_cast<int>(marks::SeedSource::samples) == HRBFNPR_SEED_SAMPLES);
static_assert(static_cast<int>(marks::SeedSource::box) == HRBFNPR_SEED_BOX);
static_assert(static_cast<int>(marks::SeedSource::points) == HRBFNPR_SEED_POINTS);

namespace hrbfnpr::api {

template <>
hrbfnpr_generate_desc defaults() noexcept {
    const generate::Settings settings;
    hrbfnpr_generate_desc desc{};
    desc.groups = 1U << HRBFNPR_GROUP_STIPPLE;
    desc.distribution = static_cast<std::uint32_t>(settings.distribution);
    desc.seed_source = static_cast<std::uint32_t>(settings.seeds.source);
    desc.box_resolution = static_cast<std::uint32_t>(settings.seeds.box_resolution);
    desc.box_jitter = settings.seeds.box_jitter;
    desc.initial_step = settings.seeds.initial_step;
    desc.projection_tolerance = settings.projection_tolerance;
    desc.random_seed = settings.random_seed;
    desc.group[HRBFNPR_GROUP_STIPPLE].levels = 4;
    desc.group[HRBFNPR_GROUP_CURVATURE].levels = 3;
    desc.group[HRBFNPR_GROUP_COMBING].levels = 3;
    desc.stroke_field = static_cast<std::uint32_t>(settings.strokes.field);
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

generate::GroupSettings checked_group(const hrbfnpr_generate_desc& desc, int group) {
    const hrbfnpr_group_desc& given = desc.group[group];
    generate::GroupSettings settings;
    settings.wanted = (desc.groups >> group & 1U) != 0;
    if (!settings.wanted) return settings;
    const GroupName name("generate_desc", group);
    const Checks checks(name.text);
    checks.between("levels", given.levels, 0, marks::most_levels);
    checks.one_of("seeds", given.seeds, HRBFNPR_GROUP_SEED_STIPPLES + 1, "HRBFNPR_GROUP_SEED_...");
    checks.between("seed_level", given.seed_level, 0, marks::most_levels);
    checks.zero("reserved", given.reserved);
    checks.at_least("budget", static_cast<double>(given.budget), 0.0);
    check_stipple_seeds(desc, group, name.text);
    settings.published.levels = given.levels;
    settings.published.from_stipples = given.seeds == HRBFNPR_GROUP_SEED_STIPPLES;
    settings.published.seed_level = given.seed_level;
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

stipples::DensitySettings checked_density(const hrbfnpr_generate_desc& desc) {
    const Checks checks("generate_desc");
    checks.one_of("density", desc.density, HRBFNPR_DENSITY_CALLBACK + 1, "HRBFNPR_DENSITY_...");
    checks.between("density_strength", desc.density_strength, 0.0, 1.0);
    if (desc.density == HRBFNPR_DENSITY_CALLBACK) checks.given("density_function", desc.density_function != nullptr);
    return {static_cast<stipples::Density>(desc.density), desc.density_strength, desc.density_function,
            desc.density_user};
}

int group_of_layer(int layer) noexcept { return (layer + 1) / 2; }

// The layers that are made share the tones evenly in LAYERED order, but for those that say their part themselves.
void fill_layers(const hrbfnpr_generate_desc& desc, generate::Settings& settings) {
    const auto made = [&](int layer) { return settings.group[static_cast<std::size_t>(group_of_layer(layer))].wanted; };
    double layers = 0.0;
    for (int layer = 0; layer < HRBFNPR_LAYER_COUNT; ++layer) layers += made(layer) ? 1.0 : 0.0;
    double before = 0.0;
    for (int layer = 0; layer < HRBFNPR_LAYER_COUNT; ++layer) {
        const hrbfnpr_layer& given = desc.layer[layer];
        marks::TonePart& part = settings.layer[static_cast<std::size_t>(layer)];
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
void share_budget(std::int64_t budget, generate::Settings& settings) {
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

generate::Settings checked(const hrbfnpr_generate_desc& desc) {
    check_numbers(desc);
    generate::Settings settings;
    settings.distribution = static_cast<marks::Distribution>(desc.distribution);
    settings.seeds.source = static_cast<marks::SeedSource>(desc.seed_source);
    settings.seeds.box_resolution = static_cast<std::int32_t>(desc.box_resolution);
    settings.seeds.box_jitter = desc.box_jitter;
    settings.seeds.initial_step = desc.initial_step;
    settings.projection_tolerance = desc.projection_tolerance;
    settings.random_seed = desc.random_seed;
    settings.strokes.separation = desc.stroke_separation;
    settings.strokes.step = desc.stroke_step;
    settings.strokes.longest = desc.stroke_length;
    settings.strokes.field = static_cast<marks::StrokeField>(desc.stroke_field);
    settings.seeds.points = in_view(desc.seed_points, "generate_desc.seed_points", points_type);
    if (desc.seed_source == HRBFNPR_SEED_POINTS && settings.seeds.points.empty())
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
    const generate::Settings settings = checked(desc);
    const OperationUse use(operation);
    const generate::SampleHint samples = model.samples();
    generate::check_request(model.implicit(), settings);
    const implicit::Implicit& implicit =
        model.implicit_for(generate::expected_evaluations(samples, settings), use.progress());
    marks::PointSet set = generate::generate(context.runtime, implicit, samples, settings, use.progress());
    marks::cluster_marks(context.runtime, set, use.progress());
    use.finish();
    for (const marks::MarkGroup& group : set.group)
        if (group.count() > 0)
            context.runtime.log(base::LogLevel::info, "generate: %lld marks in group %d in %.3f s",
                                static_cast<long long>(group.count()), static_cast<int>(&group - set.group.data()),
                                group.report.seconds);
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

marks::GroupArrays checked(const hrbfnpr_group_arrays& arrays, int group) {
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
    std::array<marks::GroupArrays, group_count> arrays;
    for (int group = 0; group < group_count; ++group)
        arrays[static_cast<std::size_t>(group)] = checked(desc.group[group], group);
    return adopt(context, marks::from_arrays(context.runtime, arrays, desc.random_seed));
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
