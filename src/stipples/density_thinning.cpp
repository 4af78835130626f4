// SPDX-License-Identifier: MIT
#include "stipples/density_thinning.h"

#include "base/sort.h"
#include "marks/marks.h"
#include "surface/curvature.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace hrbfnpr::stipples {
namespace {

// Marks that tell the density's mean.
constexpr std::int64_t probes = 2048;
// An even order of more than this many times the marks that remain is not made.
constexpr double most_excess = 16.0;
// The mean is known to a few hundredths.
constexpr double margin = 1.06;
constexpr std::int64_t call_size = 4096;
constexpr std::int64_t marks_a_look = 16384;

class Densities {
public:
    Densities(const marks::Site& site, const DensitySettings& settings) noexcept
        : site_(site), settings_(settings), packed_(site.memory()) {}

    // At the marks; the first call settles the mean curvature.
    base::Array<double> at(const EvenMarks& marks, const base::Progress& progress) {
        base::Array<double> density(site_.memory(), marks.position.size());
        if (settings_.kind == Density::curvature)
            by_curvature(marks, density, progress);
        else
            by_function(marks, density, progress);
        return density;
    }

private:
    void by_curvature(const EvenMarks& marks, base::Array<double>& density, const base::Progress& progress) {
        base::Array<surface::Curvature> curvature(site_.memory());
        surface::principal_curvatures(site_.runtime, site_.implicit, marks.position, curvature, progress);
        const auto bend = [&](std::int64_t i) {
            const double root =
                std::sqrt(0.5 * (curvature[i].k1 * curvature[i].k1 + curvature[i].k2 * curvature[i].k2));
            return std::isfinite(root) ? root : 0.0;
        };
        if (mean_bend_ < 0.0) {
            mean_bend_ = 0.0;
            for (std::int64_t i = 0; i < density.size(); ++i)
                mean_bend_ += bend(i) / static_cast<double>(density.size());
        }
        for (std::int64_t i = 0; i < density.size(); ++i) {
            if (i % marks_a_look == 0) progress.check();
            const double relative = mean_bend_ > 0.0 ? bend(i) / (bend(i) + mean_bend_) : 0.5;
            density[i] = 1.0 - settings_.strength + settings_.strength * relative;
        }
    }

    void by_function(const EvenMarks& marks, base::Array<double>& density, const base::Progress& progress) {
        for (std::int64_t begin = 0; begin < density.size(); begin += call_size) {
            progress.check();
            const std::int64_t count = std::min(call_size, density.size() - begin);
            packed_.resize(6 * count);
            for (std::int64_t i = 0; i < count; ++i)
                for (int c = 0; c < 3; ++c) {
                    packed_[3 * i + c] = site_.unit * marks.position[begin + i][c];
                    packed_[3 * (count + i) + c] = marks.normal[begin + i][c];
                }
            const std::int32_t result = settings_.function(settings_.user, count, packed_.data(),
                                                           packed_.data() + 3 * count, density.data() + begin);
            if (result != 0)
                fail(Status::callback, "density_function returned %d; it must return 0 unless it failed",
                     static_cast<int>(result));
        }
        for (std::int64_t i = 0; i < density.size(); ++i) {
            if (!(density[i] >= 0.0))
                fail(Status::callback, "density_function gave %g as a density; it must be a number from 0 to 1",
                     density[i]);
            density[i] = std::min(density[i], 1.0);
        }
    }

    const marks::Site& site_;
    const DensitySettings& settings_;
    double mean_bend_ = -1.0;
    base::Array<double> packed_;
};

double mean_of(const base::Array<double>& numbers) noexcept {
    double sum = 0.0;
    for (const double number : numbers) sum += number;
    return numbers.empty() ? 0.0 : sum / static_cast<double>(numbers.size());
}

struct Place {
    double key; // place in the even order over the density
    std::int64_t mark;
    [[nodiscard]] bool operator<(const Place& other) const noexcept {
        return key != other.key ? key < other.key : mark < other.mark;
    }
};

} // namespace

EvenMarks spread_by_density(const marks::Site& site, const SurfaceCells& cells, std::int64_t wanted,
                            const DensitySettings& density, const base::Progress& progress) {
    if (density.kind == Density::uniform) return spread_evenly(site, cells, wanted, marks::Kind::stipples, progress);
    Densities densities(site, density);
    const EvenMarks probe = spread_evenly(site, cells, probes, marks::Kind::stipples, progress.part(0.0, 0.1));
    const double mean = mean_of(densities.at(probe, progress.part(0.1, 0.15)));
    if (!(mean > 0.0))
        fail(Status::invalid_argument, "the density is 0 at all of %lld places on the surface: no mark can be made",
             static_cast<long long>(probe.position.size()));
    // About as many as remain of the most that are made.
    const double remain = std::min(static_cast<double>(wanted), most_excess * static_cast<double>(wanted) * mean);
    if (remain < 0.5)
        fail(Status::invalid_argument,
             "the density is %.3g on average, which leaves none of %lld marks: it is 1 where marks are to be densest",
             mean, static_cast<long long>(wanted));
    const double all = std::min(margin * static_cast<double>(wanted) / std::max(mean, 1.0 / most_excess),
                                static_cast<double>(marks::most_even_marks));
    const EvenMarks even =
        spread_evenly(site, cells, static_cast<std::int64_t>(all), marks::Kind::stipples, progress.part(0.15, 0.9));
    const base::Array<double> at = densities.at(even, progress.part(0.9, 1.0));
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
