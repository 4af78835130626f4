// SPDX-License-Identifier: MIT
#include "api/model.h"

#include "api/barrier.h"
#include "api/descriptor.h"
#include "api/fields.h"
#include "api/fit_options.h"
#include "api/model_trim.h"
#include "api/operation.h"
#include "api/orient.h"
#include "api/views.h"
#include "fit/local_factors.h"
#include "generate/find_trim.h"
#include "surface/tuning.h"

#include <algorithm>

using namespace hrbfnpr;

static_assert(static_cast<std::uint32_t>(kernel::Kind::triharmonic) == HRBFNPR_KERNEL_TRIHARMONIC);
static_assert(static_cast<std::uint32_t>(kernel::Kind::gaussian) == HRBFNPR_KERNEL_GAUSSIAN);
static_assert(static_cast<std::uint32_t>(kernel::Kind::wendland_c2) == HRBFNPR_KERNEL_WENDLAND_C2);
static_assert(static_cast<std::uint32_t>(fit::SolverKind::iterative) == HRBFNPR_SOLVER_ITERATIVE);
static_assert(static_cast<std::uint32_t>(fit::SolverReason::not_definite) == HRBFNPR_SOLVER_REASON_NOT_DEFINITE);
static_assert(static_cast<std::uint32_t>(fit::Repair::reorient) == HRBFNPR_REPAIR_REORIENT);
static_assert(static_cast<std::uint32_t>(fit::RegularizationMode::automatic) == HRBFNPR_REGULARIZATION_AUTO);

hrbfnpr_model::hrbfnpr_model(hrbfnpr_context& context, const hrbfnpr_model& of, generate::FoundTrim&& found)
    : Child(context), surface(std::in_place_type<std::monostate>), history(context.runtime.memory),
      untrimmed_(&of.untrimmed()), trim_(std::move(found)) {
    if (trim_.trim != nullptr) trimmed_.emplace(untrimmed_->implicit(), *trim_.trim);
    untrimmed_->add_reference();
}

hrbfnpr_model::~hrbfnpr_model() { api::release_handle(untrimmed_); }

const implicit::Implicit& hrbfnpr_model::trimmed(const implicit::Implicit& prepared) const {
    if (!trimmed_) return prepared;
    if (&prepared == &untrimmed_->implicit()) return *trimmed_;
    const auto is_prepared = [&](const Preparation& ready) { return ready.implicit.get() == &prepared; };
    std::size_t way = 0;
    {
        const std::scoped_lock lock(untrimmed_->preparing_);
        way = static_cast<std::size_t>(
            std::find_if(untrimmed_->preparations_.begin(), untrimmed_->preparations_.end(), is_prepared) -
            untrimmed_->preparations_.begin());
    }
    const std::scoped_lock lock(preparing_);
    if (!ready_trimmed_[way]) ready_trimmed_[way].emplace(prepared, *trim_.trim);
    return *ready_trimmed_[way];
}

std::size_t hrbfnpr_model::preparation_for(double evaluations) const noexcept {
    if (const auto* made = std::get_if<implicit::SheetTree>(&surface)) {
        const auto scope = implicit::PreparedSheetTree::pays(made->data(), evaluations);
        return scope ? static_cast<std::size_t>(*scope) : ways;
    }
    const implicit::HrbfData* const hrbf = data();
    return hrbf != nullptr && implicit::Prepared::pays(*hrbf, evaluations) ? 0 : ways;
}

std::unique_ptr<implicit::Implicit> hrbfnpr_model::prepare(std::size_t way, const base::Progress& progress) const {
    if (const auto* made = std::get_if<implicit::SheetTree>(&surface))
        return std::make_unique<implicit::PreparedSheetTree>(base::Work(runtime(), progress), *made,
                                                             static_cast<implicit::PreparedSheetTree::Scope>(way));
    return implicit::Prepared::make({runtime(), progress}, *data());
}

const implicit::Implicit& hrbfnpr_model::implicit_for(double evaluations, const base::Progress& progress) const {
    if (untrimmed_ != nullptr) return trimmed(untrimmed_->implicit_for(evaluations, progress));
    if (const api::CsgSolid* const solid = csg()) return solid->implicit_for(evaluations, progress);
    const std::size_t way = preparation_for(evaluations);
    if (way == ways) return implicit();
    Preparation& ready = preparations_[way];
    {
        const std::scoped_lock lock(preparing_);
        if (ready.tried) return ready.implicit != nullptr ? *ready.implicit : implicit();
    }
    // No lock is held while preparing, because the caller's callbacks run here and may call this function again. If two
    // threads prepare at the same time, their results are equal, and one result is kept.
    std::unique_ptr<implicit::Implicit> made = prepare(way, progress.part(0.0, 0.0));
    const std::scoped_lock lock(preparing_);
    if (!ready.tried) ready.implicit = std::move(made);
    ready.tried = true;
    return ready.implicit != nullptr ? *ready.implicit : implicit();
}

const surface::RayCells* hrbfnpr_model::ray_cells_for(std::int64_t rays, const base::Progress& progress) const {
    if (untrimmed_ != nullptr) return untrimmed_->ray_cells_for(rays, progress);
    const implicit::HrbfData* const hrbf = data();
    if (hrbf == nullptr || !surface::RayCells::pay(*hrbf, rays)) return nullptr;
    const implicit::Implicit& prepared =
        implicit_for(surface::ray_tuning.evaluations * static_cast<double>(rays), progress);
    if (&prepared == &implicit()) return nullptr; // the prepared function would not be accurate
    {
        const std::scoped_lock lock(preparing_);
        if (ray_cells_ != nullptr) return ray_cells_.get();
    }
    // As in implicit_for(), no lock is held, because the caller's callbacks run here.
    auto made = std::make_unique<surface::RayCells>(base::Work(runtime(), progress.part(0.0, 0.0)),
                                                    static_cast<const implicit::Prepared&>(prepared), *hrbf);
    const std::scoped_lock lock(preparing_);
    if (ray_cells_ == nullptr) ray_cells_ = std::move(made);
    return ray_cells_.get();
}

namespace hrbfnpr::api {

namespace {

using Fit = hrbfnpr_fit_desc;
using Custom = hrbfnpr_custom_desc;

struct Degree {
    void operator()(const Checks& /*checks*/, const char* field, std::int32_t value) const {
        if (value < -1 || value > 3)
            fail(Status::invalid_argument, "fit_desc.%s is %d; it must be -1, 0, 1, 2 or 3", field,
                 static_cast<int>(value));
    }
};

constexpr auto fit_fields() noexcept {
    using fit::FitInput;
    return FieldTable{
        field("kernel", &Fit::kernel, &FitInput::kernel, rule::OneOf{HRBFNPR_KERNEL_WENDLAND_C2, "HRBFNPR_KERNEL_*"}),
        field("points", &Fit::points, rule::Any{}),
        field("normals", &Fit::normals, rule::Any{}),
        field("kernel_radius", &Fit::kernel_radius, &FitInput::kernel_radius, rule::not_negative),
        field("polynomial_degree", &Fit::polynomial_degree, &FitInput::polynomial_degree, Degree{}),
        field("regularization_mode", &Fit::regularization_mode, &FitInput::regularization_mode,
              rule::OneOf{HRBFNPR_REGULARIZATION_AUTO, "HRBFNPR_REGULARIZATION_*"}),
        field("regularization", &Fit::regularization, &FitInput::regularization, rule::not_negative),
        field("outliers", &Fit::outliers, &FitInput::outliers,
              rule::OneOf{HRBFNPR_REPAIR_DROP, "HRBFNPR_REPAIR_KEEP and _DROP"}),
        field("flipped_normals", &Fit::flipped_normals, &FitInput::flipped_normals,
              rule::OneOf{HRBFNPR_REPAIR_REORIENT, "HRBFNPR_REPAIR_*"}),
        field("tolerance", &Fit::tolerance, &FitInput::tolerance, rule::not_negative),
        field("maximum_centres", &Fit::maximum_centres, &FitInput::maximum_centres, rule::not_negative),
        field("solver", &Fit::solver, &FitInput::solver, rule::OneOf{HRBFNPR_SOLVER_ITERATIVE, "HRBFNPR_SOLVER_*"}),
        field("refinement_steps", &Fit::refinement_steps, &FitInput::refinement_steps, rule::Between{0.0, 20.0}),
        field("solver_tolerance", &Fit::solver_tolerance, &FitInput::solver_tolerance, rule::Between{0.0, 0.1}),
        field("iteration_limit", &Fit::iteration_limit, &FitInput::iteration_limit, rule::Between{1.0, 1000000.0}),
        field("preconditioner_neighbours", &Fit::preconditioner_neighbours, &FitInput::preconditioner_neighbours,
              rule::Between{0.0, fit::LocalSystems::largest_set - 1}),
        field("normal_mode", &Fit::normal_mode, rule::OneOf{HRBFNPR_NORMALS_AUTO, "HRBFNPR_NORMALS_*"}),
        field("trim", &Fit::trim, rule::OneOf{HRBFNPR_TRIM_AUTO, "HRBFNPR_TRIM_NEVER and _AUTO"})};
}
static_assert(fit_fields().covers<Fit>());

constexpr auto custom_fields() noexcept {
    return FieldTable{
        field("flags", &Custom::flags,
              rule::Flags{HRBFNPR_CUSTOM_HAS_GRADIENT | HRBFNPR_CUSTOM_HAS_HESSIAN | HRBFNPR_CUSTOM_THREAD_SAFE}),
        field("function", &Custom::function, &implicit::CustomFunction::function, rule::NotNull{}),
        field("user", &Custom::user, &implicit::CustomFunction::user, rule::Any{}),
        field("release", &Custom::release, &implicit::CustomFunction::release, rule::Any{}),
        field("bounds_min", &Custom::bounds_min, rule::AllNumbers{rule::Finite{}}),
        field("bounds_max", &Custom::bounds_max, rule::AllNumbers{rule::Finite{}}),
        field("difference_step", &Custom::difference_step, &implicit::CustomFunction::difference_step,
              rule::not_negative)};
}
static_assert(custom_fields().covers<Custom>());

} // namespace

template <>
hrbfnpr_fit_desc defaults() noexcept {
    hrbfnpr_fit_desc desc{};
    fit_fields().set_defaults(fit::FitInput{}, desc);
    desc.trim = HRBFNPR_TRIM_AUTO;
    return desc;
}

template <>
hrbfnpr_custom_desc defaults() noexcept {
    return {};
}

template <>
hrbfnpr_model_info defaults() noexcept {
    return {};
}

namespace {

// The smallest diagonal of a box, as for fits. It keeps squares and cubes of lengths inside the range of a double.
constexpr double smallest_fit_box = 1e-100;
// The shares of the progress at which the fit ends, and at which the search for the box ends. The trim follows.
constexpr double end_of_fit = 0.9;
constexpr double end_of_bounds = 0.91;

fit::FitInput checked(const hrbfnpr_fit_desc& desc) {
    fit::FitInput input;
    input.points = in_view(desc.points, "fit_desc.points", points_type);
    if (input.points.empty()) fail(Status::invalid_argument, "fit_desc.points is empty; give at least one sample");
    input.normals = in_view(desc.normals, "fit_desc.normals", points_type);
    fit_fields().check("fit_desc", desc);
    const bool none = input.normals.empty() && may_lack_normals(desc.normal_mode);
    if (input.normals.count != input.points.count && !none)
        fail(Status::invalid_argument,
             "fit_desc.normals has %lld elements, but points has %lld; give one normal for each point, or none with "
             "normal_mode HRBFNPR_NORMALS_NONE",
             static_cast<long long>(input.normals.count), static_cast<long long>(input.points.count));
    if (desc.regularization_mode == HRBFNPR_REGULARIZATION_AUTO && desc.regularization != 0.0)
        fail(Status::invalid_argument,
             "fit_desc.regularization is %g, but regularization_mode is AUTO; set it to 0, or the mode to "
             "HRBFNPR_REGULARIZATION_GIVEN",
             desc.regularization);
    fit_fields().copy(desc, input);
    return input;
}

void log_choice(const base::Runtime& runtime, const fit::FitInput& input, const fit::FitReport& report,
                std::int64_t centres) {
    if (report.choice_rounds == 0) return;
    runtime.log(base::LogLevel::info, "fit: %lld centres in %d rounds, all samples within %.3g of the surface",
                static_cast<long long>(centres), static_cast<int>(report.choice_rounds), report.input_distance_max);
    if (input.tolerance > 0.0 && report.input_distance_max > input.tolerance)
        runtime.log(
            base::LogLevel::warning,
            "fit: %.2f %% of the samples are within the tolerance, %g, of the surface; the farthest is %.3g away",
            100.0 * report.input_share_within, input.tolerance, report.input_distance_max);
}

void log_fit(const base::Runtime& runtime, const fit::FitReport& report) {
    runtime.log(base::LogLevel::info,
                "fit: %lld samples in %.3f s, largest residual %.2g of f and %.2g of its gradient",
                static_cast<long long>(report.samples), report.seconds_total, report.value_residual_max,
                report.gradient_residual_max);
    if (report.merged_samples > 0)
        runtime.log(base::LogLevel::warning, "fit: %lld samples coincide with others and were merged",
                    static_cast<long long>(report.merged_samples));
    if (report.near_duplicates > 0)
        runtime.log(base::LogLevel::warning, "fit: %lld samples nearly coincide with others and were merged",
                    static_cast<long long>(report.near_duplicates));
    if (report.outliers_found > 0)
        runtime.log(base::LogLevel::warning, "fit: %lld samples look like outliers; %lld were dropped",
                    static_cast<long long>(report.outliers_found), static_cast<long long>(report.outliers_dropped));
    if (report.flipped_found > 0)
        runtime.log(base::LogLevel::warning, "fit: %lld normals oppose those of their neighbours; %lld were repaired",
                    static_cast<long long>(report.flipped_found), static_cast<long long>(report.flipped_repaired));
    if (report.rescaled_normals > 0)
        runtime.log(base::LogLevel::warning, "fit: %lld normals were not of unit length and were normalised",
                    static_cast<long long>(report.rescaled_normals));
}

// Returns the fitted model with a larger box, if samples lie along curves, or are few. The box then also contains the
// surface that closes around these samples.
hrbfnpr_model* with_closed_bounds(hrbfnpr_model* fitted, const geometry::VecArray& samples,
                                  const base::Progress& progress) {
    const HandleHold<hrbfnpr_model> whole(fitted); // This object now owns the model.
    release_handle(fitted);
    auto& surface = *std::get_if<implicit::Hrbf>(&fitted->surface);
    surface.set_bounds(generate::closed_bounds({fitted->runtime(), progress}, surface, samples));
    fitted->add_reference();
    return fitted;
}

hrbfnpr_model* fit_model(hrbfnpr_context& context, const hrbfnpr_fit_desc& desc, hrbfnpr_operation* operation) {
    fit::FitInput input = checked(desc);
    const OperationUse use(operation);
    const NormalsOfFit normals({context.runtime, use.progress()}, desc.normal_mode, input);
    const base::Progress progress = normals.rest(use.progress());
    fit::FitResult result = fit::fit({context.runtime, progress.part(0.0, end_of_fit)}, input);
    normals.report(result.report);
    log_fit(context.runtime, result.report);
    log_choice(context.runtime, input, result.report, result.data.count());
    const std::optional<fit::Samples> samples = std::exchange(result.samples, std::nullopt);
    generate::TrimSettings settings;
    settings.off = result.report.input_distance_max;
    hrbfnpr_model* const fitted = with_closed_bounds(make_handle<hrbfnpr_model>(context, std::move(result)),
                                                     samples->position, progress.part(end_of_fit, end_of_bounds));
    if (desc.trim != HRBFNPR_TRIM_NEVER)
        return ended_model(fitted, samples->position, samples->normal, settings, progress.part(end_of_bounds, 1.0));
    use.finish();
    return fitted;
}

implicit::CustomFunction checked(const hrbfnpr_custom_desc& desc) {
    custom_fields().check("custom_desc", desc);
    for (int axis = 0; axis < 3; ++axis)
        if (desc.bounds_min[axis] > desc.bounds_max[axis])
            fail(Status::invalid_argument,
                 "custom_desc.bounds_min[%d] is %g, above bounds_max[%d], which is %g; swap them", axis,
                 desc.bounds_min[axis], axis, desc.bounds_max[axis]);
    implicit::CustomFunction custom;
    custom_fields().copy(desc, custom);
    custom.has_gradient = (desc.flags & HRBFNPR_CUSTOM_HAS_GRADIENT) != 0;
    custom.has_hessian = (desc.flags & HRBFNPR_CUSTOM_HAS_HESSIAN) != 0;
    custom.thread_safe = (desc.flags & HRBFNPR_CUSTOM_THREAD_SAFE) != 0;
    assign_field(custom.bounds.min, desc.bounds_min);
    assign_field(custom.bounds.max, desc.bounds_max);
    const double diagonal = custom.bounds.diagonal();
    if (!(diagonal >= smallest_fit_box && diagonal <= 1.0 / smallest_fit_box))
        fail(Status::invalid_argument,
             "custom_desc.bounds_min and bounds_max give a box with the diagonal %g; it must be from %g to %g: scale "
             "the function",
             diagonal, smallest_fit_box, 1.0 / smallest_fit_box);
    return custom;
}

void set_box(double* low, double* high, const geometry::Bounds& bounds) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = bounds.min[axis];
        high[axis] = bounds.max[axis];
    }
}

void describe_fit(hrbfnpr_model_info& info, const fit::FitReport& report) noexcept {
    info.choice_rounds = report.choice_rounds;
    info.samples = report.samples;
    info.merged_samples = report.merged_samples;
    info.near_duplicates = report.near_duplicates;
    info.rescaled_normals = report.rescaled_normals;
    info.outliers_found = report.outliers_found;
    info.outliers_dropped = report.outliers_dropped;
    info.flipped_found = report.flipped_found;
    info.flipped_repaired = report.flipped_repaired;
    info.kernel_radius = report.kernel_radius;
    info.regularization = report.regularization;
    info.noise_estimate = report.noise_estimate;
    info.value_residual_max = report.value_residual_max;
    info.value_residual_rms = report.value_residual_rms;
    info.gradient_residual_max = report.gradient_residual_max;
    info.gradient_residual_rms = report.gradient_residual_rms;
    info.input_distance_max = report.input_distance_max;
    info.input_distance_rms = report.input_distance_rms;
    info.input_share_within = report.input_share_within;
    info.solver = static_cast<std::uint32_t>(report.solver);
    info.solver_reason = static_cast<std::uint32_t>(report.solver_reason);
    info.iterations = report.iterations;
    info.fallback = report.fallback ? 1 : 0;
    info.solver_residual = report.solver_residual;
    info.condition_estimate = report.condition_estimate;
    info.seconds_clean = report.seconds_clean;
    info.seconds_choose = report.seconds_choose;
    info.seconds_assemble = report.seconds_assemble;
    info.seconds_precondition = report.seconds_precondition;
    info.seconds_solve = report.seconds_solve;
    info.seconds_total = report.seconds_total;
    info.peak_bytes = report.peak_bytes;
    info.normals_found = report.normals_found;
    info.normals_inward = report.normals_inward ? 1 : 0;
    info.normals_turned = report.normals_turned;
    info.normals_confidence = report.normals_confidence;
    info.seconds_orient = report.seconds_orient;
}

hrbfnpr_model_info describe(const hrbfnpr_model& model) noexcept {
    hrbfnpr_model_info info{};
    const CsgSolid* const solid = model.untrimmed().csg();
    info.kernel = solid != nullptr ? HRBFNPR_KERNEL_CSG : HRBFNPR_KERNEL_CUSTOM;
    info.polynomial_degree = -1;
    info.bytes = static_cast<std::int64_t>(sizeof(hrbfnpr_model)) + (solid != nullptr ? solid->bytes() : 0);
    set_box(info.bounds_min, info.bounds_max, model.implicit().bounds());
    if (const implicit::SheetTreeData* pieces = model.pieces()) {
        describe_fit(info, model.untrimmed().report);
        info.kernel = static_cast<std::uint32_t>(pieces->sheet[0].kernel);
        info.polynomial_degree = pieces->sheet[0].polynomial_degree;
        info.centres = pieces->centres();
        info.spacing = pieces->spacing;
        info.bytes += pieces->bytes();
    }
    const implicit::HrbfData* data = model.data();
    if (data == nullptr) return info;
    describe_fit(info, model.untrimmed().report);
    info.kernel = static_cast<std::uint32_t>(data->kernel);
    info.polynomial_degree = data->polynomial_degree;
    info.centres = data->count();
    info.spacing = data->spacing;
    info.bytes += data->bytes();
    return info;
}

hrbfnpr_array view_of(const hrbfnpr_model& model, std::uint32_t attribute) {
    if (attribute > HRBFNPR_MODEL_ATTRIBUTE_RESIDUAL_HISTORY)
        fail(Status::invalid_argument, "attribute is %u; it must be one of HRBFNPR_MODEL_ATTRIBUTE_* (0 to 2)",
             attribute);
    if (attribute == HRBFNPR_MODEL_ATTRIBUTE_RESIDUAL_HISTORY)
        return {model.untrimmed().history.data(), model.untrimmed().history.size(), sizeof(double),
                HRBFNPR_SCALAR_FLOAT64, 1};
    hrbfnpr_array view{nullptr, 0, 3 * sizeof(double), HRBFNPR_SCALAR_FLOAT64, 3};
    const std::span<const double> samples =
        attribute == HRBFNPR_MODEL_ATTRIBUTE_POSITION ? model.samples().position : model.sample_normals();
    if (samples.empty()) return view;
    view.data = samples.data();
    view.count = static_cast<std::int64_t>(samples.size() / 3);
    return view;
}

} // namespace

fit::FitInput checked_options(const hrbfnpr_fit_desc& desc) {
    if (desc.points.count != 0 || desc.normals.count != 0)
        fail(Status::invalid_argument,
             "fit_desc.points and normals must be empty, because the samples are taken from the mesh");
    if (desc.tolerance != 0.0 || desc.maximum_centres != 0)
        fail(Status::invalid_argument, "fit_desc.tolerance and maximum_centres must be 0; set those of mesh_fit_desc");
    if (desc.regularization_mode != HRBFNPR_REGULARIZATION_GIVEN || desc.outliers != HRBFNPR_REPAIR_KEEP ||
        desc.flipped_normals != HRBFNPR_REPAIR_KEEP)
        fail(Status::invalid_argument,
             "fit_desc.regularization_mode, outliers and flipped_normals must be 0, because a mesh has no noise");
    fit_fields().check("fit_desc", desc);
    fit::FitInput input;
    fit_fields().copy(desc, input);
    return input;
}

} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_fit_desc_init(hrbfnpr_fit_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_model_fit(hrbfnpr_context* context, const hrbfnpr_fit_desc* desc, hrbfnpr_operation* operation,
                                 hrbfnpr_model** out_model, hrbfnpr_error* error) {
    return api::guarded_create(out_model, "out_model", error, [&] {
        return api::fit_model(api::deref(context, "context"), api::read_struct(desc, "fit_desc"), operation);
    });
}

hrbfnpr_status hrbfnpr_custom_desc_init(hrbfnpr_custom_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_model_create_custom(hrbfnpr_context* context, const hrbfnpr_custom_desc* desc,
                                           hrbfnpr_model** out_model, hrbfnpr_error* error) {
    return api::guarded_create(out_model, "out_model", error, [&] {
        auto& parent = api::deref(context, "context");
        const implicit::CustomFunction custom = api::checked(api::read_struct(desc, "custom_desc"));
        return api::make_handle<hrbfnpr_model>(parent, custom);
    });
}

void hrbfnpr_model_retain(const hrbfnpr_model* model) {
    if (model != nullptr) model->add_reference();
}

void hrbfnpr_model_release(const hrbfnpr_model* model) { api::release_handle(model); }

hrbfnpr_status hrbfnpr_model_info_init(hrbfnpr_model_info* info, uint32_t struct_size) {
    return api::init_struct(info, struct_size);
}

hrbfnpr_status hrbfnpr_model_get_info(const hrbfnpr_model* model, hrbfnpr_model_info* info, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(model, "model");
        api::check_output_struct(info, "model_info");
        api::write_struct(info, api::describe(handle));
    });
}

hrbfnpr_status hrbfnpr_model_view(const hrbfnpr_model* model, uint32_t attribute, hrbfnpr_array* out_view,
                                  hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(model, "model");
        api::require_pointer(out_view, "out_view");
        *out_view = api::view_of(handle, attribute);
    });
}

} // extern "C"
