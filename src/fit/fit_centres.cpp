// SPDX-License-Identifier: MIT
#include "fit/fit_centres.h"

#include "base/clock.h"
#include "fit/solve.h"
#include "fit/system.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::fit {
namespace {

// The automatic radius of the Gaussian kernel, in mean spacings. With a larger radius the error at the surface falls
// fast, but the condition number grows tenfold with every 0.1. From a radius of 1 on, the sign of f beside the surface
// may be wrong where samples are uneven. Set on fits of a sphere, a torus, a bumpy ball and scans (256 to 1024
// samples).
constexpr double automatic_gaussian = 0.9;
// The automatic radius of Wendland's kernel, in mean spacings. The error falls as radius^-3, and the condition number
// grows as radius^3. The radius is at least half a diagonal: where no kernel reaches the middle of the shape, only the
// polynomial is left, and its sign is wrong there.
constexpr double automatic_wendland = 10.0;
constexpr double automatic_wendland_diagonals = 0.5;

// The largest radius of a kernel, in spacings. The smallest radius is its reciprocal. Powers of other radii leave the
// range of a double, so they are refused.
constexpr double radius_limit = 1e30;

[[nodiscard]] double normalised_radius(const FitInput& input, const implicit::HrbfData& data) {
    if (input.kernel == kernel::Kind::triharmonic) return 0.0;
    if (input.kernel_radius == 0.0)
        return input.kernel == kernel::Kind::gaussian
                   ? automatic_gaussian
                   : std::max(automatic_wendland, automatic_wendland_diagonals * data.bounds.diagonal() / data.scale);
    const double radius = input.kernel_radius / data.scale;
    if (!(radius > 1.0 / radius_limit && radius < radius_limit))
        fail(
            Status::invalid_argument,
            "kernel_radius is %g, which is %g times the mean spacing of the samples; use another one, or 0 (automatic)",
            input.kernel_radius, radius);
    return radius;
}

// Returns k, the ratio of normalised coordinates to coordinates with a diagonal of 1, which regularization is defined
// for. phi scales as k^m, the row and column of alpha as k^(m/2) each, and those of beta as k^(m/2 - 1).
[[nodiscard]] double scale_to_unit_diagonal(const implicit::HrbfData& data) {
    const double diagonal = data.bounds.diagonal();
    return diagonal > 0.0 ? diagonal / data.scale : 1.0;
}

[[nodiscard]] HermiteSystem::Options system_options(const FitInput& input, const Smoothing& smoothing,
                                                    const implicit::HrbfData& data) {
    const double k = scale_to_unit_diagonal(data);
    const int m = kernel::homogeneity(input.kernel);
    return {input.kernel, data.kernel_radius, input.polynomial_degree, smoothing.value * std::pow(k, m),
            smoothing.gradient * std::pow(k, m - 2)};
}

// Computes CentreFit::variance: h^T K^-1 h = w . h, divided by the degrees of freedom, which are the rows of the system
// minus the coefficients of the polynomial. The result is converted to coordinates with a diagonal of 1.
[[nodiscard]] double variance(const HermiteSystem& system, const double* rhs, const Solution& solution,
                              const implicit::HrbfData& data) {
    double energy = 0.0;
    for (std::int64_t i = 0; i < system.rows(); ++i) energy += rhs[i] * solution.x[i];
    const auto freedom = static_cast<double>(std::max<std::int64_t>(system.rows() - system.terms(), 1));
    return std::max(0.0,
                    energy / freedom * std::pow(scale_to_unit_diagonal(data), kernel::homogeneity(data.kernel) - 2));
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

// The conditions are f(x_i) = 0, or f(x_i) = value_i, and grad f(x_i) = n_i. Normalising coordinates leaves the normals
// unchanged.
[[nodiscard]] base::Array<double> right_hand_side(base::Memory& memory, const HermiteSystem& system,
                                                  const Samples& centres, double scale) {
    base::Array<double> rhs(memory, system.unknowns());
    for (std::int64_t i = 0; i < centres.normal.size(); ++i)
        for (glm::length_t c = 0; c < 3; ++c) rhs[4 * i + 1 + c] = centres.normal[i][c];
    for (std::int64_t i = 0; i < centres.value.size(); ++i) rhs[4 * i] = centres.value[i] / scale;
    return rhs;
}

// Returns the weights of an earlier fit as weights of the new one, 4 for each centre, or nothing if the kernel's radius
// may have changed. If coordinates are multiplied by k, then f is, too, and phi(k r) = k^3 phi(r).
[[nodiscard]] base::Array<double> weights_of(base::Memory& memory, const EarlierFit& earlier,
                                             const implicit::HrbfData& data) {
    base::Array<double> weights(memory);
    if (earlier.data == nullptr || data.kernel != kernel::Kind::triharmonic) return weights;
    const implicit::HrbfData& from = *earlier.data;
    const double k = from.scale / data.scale;
    const std::int64_t count = data.centre_position.size();
    weights.resize(4 * count);
    for (std::int64_t i = 0; i < count; ++i) {
        const std::int64_t j = earlier.index != nullptr ? (*earlier.index)[i] : i;
        if (j < 0) continue;
        weights[4 * i] = from.alpha[j] / (k * k);
        for (glm::length_t c = 0; c < 3; ++c) weights[4 * i + 1 + c] = from.beta[j][c] / k;
    }
    return weights;
}

[[nodiscard]] SolveOptions solve_options(const FitInput& input) noexcept {
    SolveOptions options;
    options.solver = input.solver;
    options.refinement_steps = input.refinement_steps;
    options.neighbours = static_cast<std::int32_t>(input.preconditioner_neighbours);
    // Chosen centres are judged by the distances of all samples from the surface, not by the residual.
    if (input.tolerance > 0.0 || input.maximum_centres > 0) options.acceptable = 1e-3;
    options.tolerance = input.automatic_tolerance;
    if (input.solver_tolerance > 0.0) options.tolerance = options.acceptable = input.solver_tolerance;
    options.iterations = input.iteration_limit;
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

void report_solution(const Solution& solution, FitReport& report) noexcept {
    report.solver = solution.solver;
    report.solver_reason = solution.reason;
    report.solver_residual = solution.residual;
    report.condition_estimate = solution.condition;
    report.iterations = solution.iterations;
    report.fallback = solution.fallback;
    report.seconds_precondition = solution.seconds_precondition;
    report.seconds_solve = solution.seconds_solve;
}

} // namespace

CentreFit fit_centres(const base::Work& work, const FitInput& input, const Samples& centres, const Smoothing& smoothing,
                      const EarlierFit& earlier) {
    const base::Stopwatch watch;
    CentreFit fit{
        {normalise(work, input, centres), {}, base::Array<double>(work.memory)}, base::Array<double>(work.memory), 0.0};
    implicit::HrbfData& data = fit.result.data;
    work.check();
    const HermiteSystem system(data.centre_position, system_options(input, smoothing, data));
    const base::Array<double> rhs = right_hand_side(work.memory, system, centres, data.scale);
    const double seconds_before = watch.seconds();
    work.check();
    SolveOptions options = solve_options(input);
    const base::Array<double> start = weights_of(work.memory, earlier, data);
    if (!start.empty()) options.start = start.data();
    Solution solution = solve(work, system, rhs.data(), options);
    work.check();
    store(solution, data);
    work.check();
    fit.variance = variance(system, rhs.data(), solution, data);
    work.check();
    report_solution(solution, fit.result.report);
    fit.misfit = std::move(solution.misfit);
    fit.result.history = std::move(solution.history);
    fit.result.report.kernel_radius = data.kernel_radius * data.scale;
    fit.result.report.regularization =
        smoothing.value +
        solution.value_diagonal / std::pow(scale_to_unit_diagonal(data), kernel::homogeneity(data.kernel));
    fit.result.report.seconds_assemble = seconds_before + solution.seconds_assemble;
    return fit;
}

} // namespace hrbfnpr::fit
