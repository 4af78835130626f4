// SPDX-License-Identifier: MIT
#include "stipples/density.h"

#include "base/sort.h"
#include "marks/marks.h"
#include "stipples/tuning.h"
#include "surface/curvature.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace hrbfnpr::stipples {
namespace {

// The densities at marks. `mean_bend` is the mean over all marks of the first call, which sets it.
[[nodiscard]] base::Array<double> densities_by_curvature(const marks::Site& site, const EvenMarks& marks,
                                                         double strength, std::optional<double>& mean_bend,
                                                         const base::Progress& progress) {
    HRBFNPR_ASSERT(strength >= 0.0 && strength <= 1.0);
    base::Array<surface::Curvature> curvature(site.memory());
    surface::principal_curvatures(site.runtime, site.implicit, marks.position, curvature, progress);
    base::Array<double> density(site.memory(), marks.position.size());
    for (std::int64_t i = 0; i < density.size(); ++i) {
        const double bend = std::sqrt(0.5 * (curvature[i].k1 * curvature[i].k1 + curvature[i].k2 * curvature[i].k2));
        density[i] = std::isfinite(bend) ? bend : 0.0;
    }
    if (!mean_bend) {
        mean_bend = 0.0;
        for (const double bend : density) *mean_bend += bend / static_cast<double>(density.size());
    }
    for (std::int64_t i = 0; i < density.size(); ++i) {
        if (i % marks_a_look == 0) progress.check();
        const double relative = *mean_bend > 0.0 ? density[i] / (density[i] + *mean_bend) : 0.5;
        density[i] = 1.0 - strength + strength * relative;
    }
    return density;
}

[[nodiscard]] base::Array<double> densities_by_function(const marks::Site& site, const EvenMarks& marks,
                                                        const DensitySettings& settings,
                                                        const base::Progress& progress) {
    base::Array<double> density(site.memory(), marks.position.size());
    base::Array<double> packed(site.memory()); // positions, then normals
    for (std::int64_t begin = 0; begin < density.size(); begin += points_a_task) {
        progress.check();
        const std::int64_t count = std::min(points_a_task, density.size() - begin);
        packed.resize(6 * count);
        for (std::int64_t i = 0; i < count; ++i)
            for (int c = 0; c < 3; ++c) {
                packed[3 * i + c] = site.unit * marks.position[begin + i][c];
                packed[3 * (count + i) + c] = marks.normal[begin + i][c];
            }
        const std::int32_t result =
            settings.function(settings.user, count, packed.data(), packed.data() + 3 * count, density.data() + begin);
        if (result != 0)
            fail(Status::callback, "density_function returned %d; it must return 0 unless it failed",
                 static_cast<int>(result));
    }
    for (double& number : density) {
        if (!(number >= 0.0))
            fail(Status::callback, "density_function gave %g as a density; it must be a number from 0 to 1", number);
        number = std::min(number, 1.0);
    }
    return density;
}

} // namespace

EvenMarks spread_by_density(const marks::Site& site, const SurfaceCells& cells, std::int64_t wanted,
                            const DensitySettings& density, const base::Progress& progress) {
    if (density.kind == Density::uniform) return spread_evenly(site, cells, wanted, marks::Kind::stipples, progress);
    std::optional<double> mean_bend;
    const auto densities = [&](const EvenMarks& marks, const base::Progress& part) {
        return density.kind == Density::curvature
                   ? densities_by_curvature(site, marks, density.strength, mean_bend, part)
                   : densities_by_function(site, marks, density, part);
    };
    const EvenMarks probe =
        spread_evenly(site, cells, stipple_tuning.probes, marks::Kind::stipples, progress.part(0.0, 0.1));
    double mean = 0.0;
    for (const double number : densities(probe, progress.part(0.1, 0.15))) mean += number;
    mean /= static_cast<double>(probe.position.size());
    if (!(mean > 0.0))
        fail(Status::invalid_argument, "the density is 0 at all of %lld places on the surface: no mark can be made",
             static_cast<long long>(probe.position.size()));
    // About as many as remain of the most that are made.
    const double most = stipple_tuning.most_excess * static_cast<double>(wanted);
    if (std::min(static_cast<double>(wanted), most * mean) < 0.5)
        fail(Status::invalid_argument,
             "the density is %.3g on average, which leaves none of %lld marks: it is 1 where marks are to be densest",
             mean, static_cast<long long>(wanted));
    const double all = std::min(stipple_tuning.mean_error * static_cast<double>(wanted) /
                                    std::max(mean, 1.0 / stipple_tuning.most_excess),
                                static_cast<double>(marks::most_even_marks));
    const EvenMarks even =
        spread_evenly(site, cells, static_cast<std::int64_t>(all), marks::Kind::stipples, progress.part(0.15, 0.9));
    const base::Array<double> at = densities(even, progress.part(0.9, 1.0));
    struct Place {
        double key; // place in the even order over the density
        std::int64_t mark;
        [[nodiscard]] bool operator<(const Place& other) const noexcept {
            return key != other.key ? key < other.key : mark < other.mark;
        }
    };
    base::Array<Place> places(site.memory());
    for (std::int64_t i = 0; i < at.size(); ++i) {
        if (i % marks_a_look == 0) progress.check();
        const double key = (static_cast<double>(i) + 0.5) / at[i]; // infinite where the density is 0
        if (key < static_cast<double>(at.size())) places.push_back({key, i});
    }
    base::sort_long(places.begin(), places.end(), std::less<>(), progress);
    const std::int64_t kept = std::min(wanted, places.size());
    if (kept == 0)
        fail(Status::invalid_argument,
             "the density leaves none of %lld marks where it was asked for: it is 1 where marks are to be densest",
             static_cast<long long>(at.size()));
    EvenMarks marks(site.memory());
    marks.area = even.area;
    marks.report = even.report;
    for (std::int64_t i = 0; i < kept; ++i) {
        if (i % marks_a_look == 0) progress.check();
        marks.position.push_back(even.position[places[i].mark]);
        marks.normal.push_back(even.normal[places[i].mark]);
    }
    marks.report.placed = kept;
    marks.report.dropped_budget += even.position.size() - kept;
    return marks;
}

} // namespace hrbfnpr::stipples
