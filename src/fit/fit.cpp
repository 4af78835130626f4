#include "fit/fit.h"

#include "base/clock.h"
#include "fit/local_factors.h"
#include "fit/samples.h"
#include "fit/solve.h"
#include "fit/system.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::fit {
namespace {

// Kernel radii where the caller gives none, from fits of a sphere, a torus, a bumpy ball and scans
// (256 to 1024 samples).
// Gaussian, in mean spacings: the error at the surface falls fast with sigma (torus of 512 samples:
// 7e-4 at 0.8, 1e-4 at 0.9, 2e-5 at 1), but the condition grows ten times with every tenth, and on
// uneven samples (bunny of 256) the sign beside the surface begins to fail from 1 on.
constexpr double automatic_gaussian = 0.9;
// Wendland, in mean spacings: the error falls by (radius)^-3 and the condition grows only by
// (radius)^3 (1e5 at 10).  A support that does not reach the middle of the shape leaves the
// polynomial alone there, whose sign is wrong inside; so at least half a diagonal.
constexpr double automatic_wendland = 10.0;
constexpr double automatic_wendland_diagonals = 0.5;

// Beyond these (in spacings) powers of the radius leave a double's range.
constexpr double radius_limit = 1e30;

void check(const FitInput& input) {
    if (!(input.kernel_radius >= 0.0) || std::isinf(input.kernel_radius))
        fail(Status::invalid_argument, "kernel_radius is %g; it must be finite and >= 0 (0 = automatic)",
             input.kernel_radius);
    if (!(input.regularization >= 0.0) || std::isinf(input.regularization))
        fail(Status::invalid_argument, "regularization is %g; it must be finite and >= 0", input.regularization);
    if (input.polynomial_degree < -1 || input.polynomial_degree > 3)
        fail(Status::invalid_argument, "polynomial_degree is %d; it must be -1 (none) to 3",
             static_cast<int>(input.polynomial_degree));
    if (input.iteration_limit < 0)
        fail(Status::invalid_argument, "iteration_limit is %d; it must be >= 0",
             static_cast<int>(input.iteration_limit));
    if (input.preconditioner_neighbours >= static_cast<std::uint32_t>(LocalSystems::largest_set))
        fail(Status::invalid_argument, "preconditioner_neighbours is %u; it must be 0 (automatic) to %d",
             static_cast<unsigned>(input.preconditioner_neighbours), static_cast<int>(LocalSystems::largest_set - 1));
    if (input.points.count < 1 || input.points.count != input.normals.count)
        fail(Status::invalid_argument, "points has %lld and normals %lld elements; they must be as many, and not empty",
             static_cast<long long>(input.points.count), static_cast<long long>(input.normals.count));
}

// The radius in normalised coordinates.
[[nodiscard]] double normalised_radius(const FitInput& input, const implicit::HrbfData& data) {
    if (input.kernel == kernel::Kind::triharmonic) return 0.0;
    if (input.kernel_radius == 0.0)
        return input.kernel == kernel::Kind::gaussian
                   ? automatic_gaussian
                   : std::max(automatic_wendland, automatic_wendland_diagonals * data.bounds.diagonal() / data.scale);
    const double radius = input.kernel_radius / data.scale;
    if (!(radius > 1.0 / radius_limit && radius < radius_limit))
        fail(Status::invalid_argument, "kernel_radius is %g, %g times the mean spacing of the samples; 0 chooses it",
             input.kernel_radius, radius);
    return radius;
}

// Regularization is defined in coordinates whose diagonal is 1.  From there to normalised ones,
// k times as large, alpha's row and column scale by k^(m/2) each and beta's by k^(m/2 - 1), where
// phi scales as k^m.
[[nodiscard]] HermiteSystem::Options system_options(const FitInput& input, const implicit::HrbfData& data) {
    const double diagonal = data.bounds.diagonal();
    const double k = diagonal > 0.0 ? diagonal / data.scale : 1.0;
    const int m = kernel::homogeneity(input.kernel);
    return {input.kernel, data.kernel_radius, input.polynomial_degree, input.regularization * std::pow(k, m),
            input.regularization * std::pow(k, m - 2)};
}

[[nodiscard]] implicit::HrbfData normalise(const base::Runtime& runtime, const FitInput& input,
                                           const Samples& samples) {
    const std::int64_t count = samples.position.size();
    implicit::HrbfData data(runtime.memory);
    data.kernel = input.kernel;
    data.polynomial_degree = input.polynomial_degree;
    data.bounds = samples.bounds;
    data.spacing = samples.spacing;
    data.centre = samples.bounds.centre();
    data.scale = count > 1 ? samples.spacing : 1.0;
    data.kernel_radius = normalised_radius(input, data);
    data.sample_position.resize(3 * count);
    data.sample_normal.resize(3 * count);
    data.centre_position.resize(count);
    for (std::int64_t i = 0; i < count; ++i) {
        const glm::dvec3 p = samples.position[i];
        const glm::dvec3 n = samples.normal[i];
        for (glm::length_t c = 0; c < 3; ++c) {
            data.sample_position[3 * i + c] = p[c];
            data.sample_normal[3 * i + c] = n[c];
        }
        data.centre_position.set(i, {implicit::normalised(p.x, data.centre.x, data.scale),
                                     implicit::normalised(p.y, data.centre.y, data.scale),
                                     implicit::normalised(p.z, data.centre.z, data.scale)});
    }
    return data;
}

// f(x_i) = 0, grad f(x_i) = n_i; normals are the same in normalised coordinates.
[[nodiscard]] base::Array<double> right_hand_side(base::Memory& memory, const HermiteSystem& system,
                                                  const geometry::VecArray& normal) {
    base::Array<double> rhs(memory, system.unknowns());
    for (std::int64_t i = 0; i < normal.size(); ++i)
        for (glm::length_t c = 0; c < 3; ++c) rhs[4 * i + 1 + c] = normal[i][c];
    return rhs;
}

[[nodiscard]] SolveOptions solve_options(const FitInput& input) noexcept {
    SolveOptions options;
    options.solver = input.solver;
    options.refinement_steps = input.iteration_limit;
    options.neighbours = static_cast<std::int32_t>(input.preconditioner_neighbours);
    if (input.solver_tolerance > 0.0) options.tolerance = options.acceptable = input.solver_tolerance;
    if (input.solver_iterations > 0) options.iterations = input.solver_iterations;
    return options;
}

void store(const Solution& solution, implicit::HrbfData& data) {
    const std::int64_t count = data.centre_position.size();
    data.alpha.resize(count);
    data.beta.resize(count);
    for (std::int64_t i = 0; i < count; ++i) {
        const double* w = solution.x.data() + 4 * i;
        data.alpha[i] = w[0];
        data.beta.set(i, {w[1], w[2], w[3]});
    }
    const std::int64_t terms = solution.x.size() - 4 * count;
    data.polynomial.resize(terms);
    std::copy_n(solution.x.data() + 4 * count, terms, data.polynomial.data());
}

// f(x_i) and grad f(x_i) - n_i, 4 numbers a sample, of the finished function, f in normalised units.
[[nodiscard]] base::Array<double> evaluate_misfit(const base::Runtime& runtime, const implicit::HrbfData& data,
                                                  const Samples& samples, const base::Progress& progress) {
    const std::int64_t count = data.count();
    const implicit::PointBatch points{samples.position.x.data(), samples.position.y.data(), samples.position.z.data(),
                                      count};
    base::Array<double> misfit(runtime.memory, 4 * count);
    base::Array<double> value(runtime.memory, count);
    geometry::VecArray gradient(runtime.memory, count);
    const implicit::FieldBatch fields{value.data(), {gradient.x.data(), gradient.y.data(), gradient.z.data()}, {}};
    runtime.parallel.for_chunks(count, implicit::batch_size, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        implicit::evaluate(data, implicit::slice(points, begin, end), fields.from(begin));
        for (std::int64_t i = begin; i < end; ++i) {
            misfit[4 * i] = value[i] / data.scale;
            const glm::dvec3 off = gradient[i] - samples.normal[i];
            for (glm::length_t c = 0; c < 3; ++c) misfit[4 * i + 1 + c] = off[c];
        }
    });
    return misfit;
}

void report_misfit(const base::Array<double>& misfit, double scale, FitReport& report) {
    const std::int64_t count = misfit.size() / 4;
    double value_sum = 0.0;
    double gradient_sum = 0.0;
    for (std::int64_t i = 0; i < count; ++i) {
        const double value = std::abs(misfit[4 * i]);
        const double off = glm::length(glm::dvec3(misfit[4 * i + 1], misfit[4 * i + 2], misfit[4 * i + 3]));
        report.value_residual_max = std::max(report.value_residual_max, scale * value);
        report.gradient_residual_max = std::max(report.gradient_residual_max, off);
        value_sum += value * value;
        gradient_sum += off * off;
    }
    report.value_residual_rms = scale * std::sqrt(value_sum / static_cast<double>(count));
    report.gradient_residual_rms = std::sqrt(gradient_sum / static_cast<double>(count));
}

} // namespace

FitResult fit(const base::Runtime& runtime, const FitInput& input, const base::Progress& progress) {
    const base::Stopwatch watch;
    check(input);
    const Samples samples = read_samples(runtime, input.points, input.normals, progress.part(0.0, 0.03));
    if (input.maximum_centres > 0 && samples.position.size() > input.maximum_centres)
        fail(Status::invalid_argument, "points: %lld samples are left after merging, more than maximum_centres, %lld",
             static_cast<long long>(samples.position.size()), static_cast<long long>(input.maximum_centres));
    FitResult result{normalise(runtime, input, samples), {}};
    implicit::HrbfData& data = result.data;
    FitReport& report = result.report;

    const HermiteSystem system(data.centre_position, system_options(input, data));
    const base::Array<double> rhs = right_hand_side(runtime.memory, system, samples.normal);
    const double seconds_before = watch.seconds();
    const Solution solution = solve(runtime, system, rhs.data(), solve_options(input), progress.part(0.03, 0.98));
    store(solution, data);
    if (solution.misfit.empty())
        report_misfit(evaluate_misfit(runtime, data, samples, progress), data.scale, report);
    else
        report_misfit(solution.misfit, data.scale, report);

    report.samples = input.points.count;
    report.merged_samples = samples.merged;
    report.rescaled_normals = samples.rescaled_normals;
    report.kernel_radius = data.kernel_radius * data.scale;
    report.regularization = input.regularization;
    report.solver_residual = solution.residual;
    report.condition_estimate = solution.condition;
    report.iterations = solution.iterations;
    report.fallback = solution.fallback;
    report.seconds_assemble = seconds_before + solution.seconds_assemble;
    report.seconds_solve = solution.seconds_solve;
    report.seconds_precondition = solution.seconds_precondition;
    report.solver = solution.solver;
    report.solver_reason = solution.reason;
    report.peak_bytes = runtime.memory.bytes_peak();
    report.seconds_total = watch.seconds();
    progress.update(1.0);
    return result;
}

} // namespace hrbfnpr::fit
