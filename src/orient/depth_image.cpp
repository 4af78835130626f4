// SPDX-License-Identifier: MIT
#include "orient/depth_image.h"

#include "base/clock.h"
#include "base/sort.h"
#include "base/status.h"
#include "geometry/long_vec_array.h"
#include "orient/depth_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrbfnpr::orient {
namespace {

constexpr std::int64_t pixels_a_task = 1024;
constexpr std::int64_t tasks_a_band = 32;
constexpr std::int64_t least_seen = 64;
constexpr double in_line = 0.99; // correlation of directions and pixels
// Standard deviations of depth, seen from the side as wide as so many pixels, that a disc of one pixel is for.
constexpr double widening = 12.0;
constexpr std::int64_t same_steps = 8; // pixels for each value of 1 / z, at least, of a camera with depth steps
// Shares of 1 / z: what is off a plane at a pixel is no less, as most images come in single precision, and no more,
// where it is not noise.
constexpr double rounding = 1e-6;
constexpr double most_curved = 5e-3;
constexpr double even = 3.0; // standard deviations: a small plane with a larger error has an edge in it
constexpr double of_step = 0.2886751345948129; // standard deviation of what is rounded to steps of 1: 1 / sqrt(12)

// y = slope x + start, of all of them.
class Line {
public:
    void add(double x, double y) noexcept {
        ++count_;
        const double dx = x - mean_x_;
        const double dy = y - mean_y_;
        mean_x_ += dx / count_;
        mean_y_ += dy / count_;
        xx_ += dx * (x - mean_x_);
        yy_ += dy * (y - mean_y_);
        xy_ += dx * (y - mean_y_);
    }
    [[nodiscard]] double slope() const noexcept { return xy_ / xx_; }
    [[nodiscard]] double at(double x) const noexcept { return mean_y_ + slope() * (x - mean_x_); }
    [[nodiscard]] bool is_one() const noexcept { return std::abs(xy_) > in_line * std::sqrt(xx_ * yy_); }

private:
    double count_ = 0.0, mean_x_ = 0.0, mean_y_ = 0.0, xx_ = 0.0, yy_ = 0.0, xy_ = 0.0;
};

// The middle one; changes the order.
[[nodiscard]] double median(base::Array<double>& values, const base::Progress& progress) {
    if (values.empty()) return 0.0;
    progress.check();
    double* const middle = values.begin() + values.size() / 2;
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

class Smoothing {
public:
    Smoothing(const base::Runtime& runtime, const DepthImageInput& input)
        : runtime_(runtime), input_(input), depth_(runtime.memory), error_(runtime.memory), discs_(runtime.memory) {}

    DepthImage run(const base::Progress& progress) {
        read(progress.part(0.0, 0.05));
        DepthImage image(runtime_.memory);
        image.report = report_;
        image.report.noise = noise_ / unit_;
        geometry::resize_long(image.point, depth_.size(), progress);
        geometry::resize_long(image.normal, depth_.size(), progress);
        const std::int64_t tasks = (depth_.size() + pixels_a_task - 1) / pixels_a_task;
        base::Array<std::int64_t> left_out(runtime_.memory);
        left_out.resize(tasks);
        const base::Progress smoothing = progress.part(0.05, 1.0);
        for (std::int64_t from = 0; from < tasks; from += tasks_a_band) {
            const std::int64_t count = std::min(tasks_a_band, tasks - from);
            runtime_.parallel.for_each(count, smoothing, [&](std::int64_t task) {
                const std::int64_t begin = (from + task) * pixels_a_task;
                for (std::int64_t i = begin; i < std::min(begin + pixels_a_task, depth_.size()); ++i)
                    left_out[from + task] += smooth(i, image) ? 0 : 1;
            });
            smoothing.update(static_cast<double>(from + count) / static_cast<double>(tasks));
        }
        for (const std::int64_t count : left_out) image.report.left_out += count;
        return image;
    }

private:
    [[nodiscard]] glm::dvec3 given(std::int64_t i) const noexcept {
        return {input_.points.get(i, 0), input_.points.get(i, 1), input_.points.get(i, 2)};
    }

    // 1 / z, in units in which the median is 1, and the camera.
    void read(const base::Progress& progress) {
        depth_.columns = input_.columns;
        depth_.rows = input_.rows;
        depth_.value.resize_for_overwrite(depth_.size());
        base::Array<double> seen(runtime_.memory);
        seen.reserve(depth_.size());
        Line across;
        Line down;
        for (std::int32_t row = 0; row < input_.rows; ++row) {
            progress.check();
            for (std::int32_t column = 0; column < input_.columns; ++column)
                read_pixel(column, row, across, down, seen);
        }
        report_.seen = seen.size();
        require_camera(across, down);
        across_ = across;
        down_ = down;
        report_.focal_length = 1.0 / std::sqrt(std::abs(across.slope() * down.slope()));
        unit_ = median(seen, progress);
        report_.depth = unit_;
        for (std::int64_t i = 0; i < depth_.size(); ++i) {
            if (i % pixels_a_task == 0) progress.check();
            depth_.value[i] = unit_ / depth_.value[i];
        }
        measure_errors(progress);
        noise_ = input_.noise > 0.0 ? input_.noise * unit_ : measured_noise(progress);
        report_.radius = radius_at(1.0);
    }

    void read_pixel(std::int32_t column, std::int32_t row, Line& across, Line& down, base::Array<double>& seen) {
        const std::int64_t i = std::int64_t{row} * input_.columns + column;
        const glm::dvec3 p = given(i);
        depth_.value[i] = std::numeric_limits<double>::quiet_NaN();
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z) || p.z == 0.0) return;
        if (sign_ == 0.0) sign_ = p.z > 0.0 ? 1.0 : -1.0;
        if (sign_ * p.z < 0.0)
            fail(Status::invalid_argument,
                 "depth_image_desc.points[%lld] has z = %g, others have the other sign: a camera in the origin "
                 "sees to one side; move the points to where it stood",
                 static_cast<long long>(i), p.z);
        depth_.value[i] = std::abs(p.z);
        seen.push_back(std::abs(p.z));
        across.add(column, p.x / p.z);
        down.add(row, p.y / p.z);
    }

    void require_camera(const Line& across, const Line& down) const {
        if (report_.seen < least_seen)
            fail(Status::invalid_argument,
                 "depth_image_desc.points has %lld points with a z that is finite and not 0; give at least %lld",
                 static_cast<long long>(report_.seen), static_cast<long long>(least_seen));
        if (across.is_one() && down.is_one()) return;
        fail(Status::invalid_argument,
             "depth_image_desc.points are no image of a camera in the origin that looks along z: %s; give them "
             "row by row, in the camera's coordinates",
             across.is_one() ? "y / z does not go with the row" : "x / z does not go with the column");
    }

    // Of the small plane around each pixel; infinite where there is none.
    void measure_errors(const base::Progress& progress) {
        base::resize_long(error_, depth_.size(), progress);
        runtime_.parallel.for_chunks(depth_.size(), pixels_a_task, progress, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) {
                const auto plane = small_plane(depth_, column_of(i), row_of(i));
                error_[i] = plane ? plane->error : std::numeric_limits<double>::infinity();
            }
        });
    }

    [[nodiscard]] double measured_noise(const base::Progress& progress) const {
        base::Array<double> errors(runtime_.memory);
        for (std::int64_t i = 0; i < error_.size(); ++i) {
            if (i % pixels_a_task == 0) progress.check();
            if (std::isfinite(error_[i])) errors.push_back(error_[i]);
        }
        return std::max(median(errors, progress), of_step * step(progress));
    }

    // Of the small planes over a pixel the best one, which has no edge in it: its slope, and what is seen off it, noise
    // or curvature.
    [[nodiscard]] SmallPlane best_plane(std::int64_t i) const noexcept {
        const std::int32_t column = column_of(i);
        const std::int32_t row = row_of(i);
        const double here = depth_.value[i];
        std::int64_t best = i;
        for (std::int32_t y = std::max(row - 2, 0); y <= std::min(row + 2, depth_.rows - 1); ++y)
            for (std::int32_t x = std::max(column - 2, 0); x <= std::min(column + 2, depth_.columns - 1); ++x) {
                const std::int64_t at = std::int64_t{y} * depth_.columns + x;
                if (error_[at] < error_[best]) best = at;
            }
        SmallPlane plane{{here, 0.0, 0.0}, std::max(noise_, rounding * here)};
        if (const auto found = small_plane(depth_, column_of(best), row_of(best))) {
            if (found->error <= even * noise_ || found->error <= most_curved * here)
                plane.plane = {here, found->plane.across, found->plane.down};
            plane.error = std::max(plane.error, std::min(found->error, most_curved * here));
        }
        return plane;
    }

    // Between the values of 1 / z; 0 if there are too many different ones.
    [[nodiscard]] double step(const base::Progress& progress) const {
        base::Array<double> values(runtime_.memory);
        for (std::int64_t i = 0; i < depth_.size(); ++i) {
            if (i % pixels_a_task == 0) progress.check();
            if (!std::isnan(depth_.value[i])) values.push_back(depth_.value[i]);
        }
        base::sort_long(values.begin(), values.end(), std::less<>(), progress);
        base::Array<double> gaps(runtime_.memory);
        for (std::int64_t i = 1; i < values.size(); ++i)
            if (values[i] > values[i - 1]) gaps.push_back(values[i] - values[i - 1]);
        return same_steps * (gaps.size() + 1) > values.size() ? 0.0 : median(gaps, progress);
    }

    // The slope of a plane is as wrong as its depths are, over the disc's width: noise of z, over z / focal_length for
    // each pixel.
    [[nodiscard]] double radius_at(double inverse_depth) const noexcept {
        const double wrong = noise_ / inverse_depth * report_.focal_length;
        return std::clamp(input_.smoothing * widening * std::sqrt(wrong), static_cast<double>(Discs::least),
                          static_cast<double>(Discs::most));
    }

    // False if what was seen is left out.
    bool smooth(std::int64_t i, DepthImage& image) const noexcept {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        image.point.set(i, glm::dvec3(nan));
        const double here = depth_.value[i];
        if (std::isnan(here)) return true;
        const std::int32_t column = column_of(i);
        const std::int32_t row = row_of(i);
        const auto radius = static_cast<std::int32_t>(std::lround(radius_at(here)));
        const auto plane = plane_around(depth_, column, row, discs_.of(radius), best_plane(i));
        if (!plane || !(plane->value > 0.0)) return false;
        const glm::dvec3 seen = given(i);
        const double u = across_.at(column);
        const double v = down_.at(row);
        const double nx = plane->across / across_.slope();
        const double ny = plane->down / down_.slope();
        const glm::dvec3 normal(nx, ny, plane->value - nx * u - ny * v);
        // To the camera: against the direction (u, v, 1) of what has a z above 0.
        image.normal.set(i, -sign_ * glm::normalize(normal));
        image.point.set(i, input_.keep_points ? seen : seen * (here / plane->value));
        return true;
    }

    [[nodiscard]] std::int32_t column_of(std::int64_t i) const noexcept {
        return static_cast<std::int32_t>(i % depth_.columns);
    }
    [[nodiscard]] std::int32_t row_of(std::int64_t i) const noexcept {
        return static_cast<std::int32_t>(i / depth_.columns);
    }

    const base::Runtime& runtime_;
    const DepthImageInput& input_;
    InverseDepth depth_;
    base::Array<double> error_;
    Discs discs_;
    Line across_, down_;
    DepthImageReport report_;
    double sign_ = 0.0; // of z
    double unit_ = 1.0;
    double noise_ = 0.0;
};

} // namespace

DepthImage smooth_depth_image(const base::Runtime& runtime, const DepthImageInput& input,
                              const base::Progress& progress) {
    const base::Stopwatch watch;
    DepthImage image = Smoothing(runtime, input).run(progress);
    image.report.seconds = watch.seconds();
    const DepthImageReport& report = image.report;
    runtime.log(base::LogLevel::info, "depth image: %lld points smoothed over %.1f pixels in %.2f s, %lld left out",
                static_cast<long long>(report.seen), report.radius, report.seconds,
                static_cast<long long>(report.left_out));
    progress.update(1.0);
    return image;
}

} // namespace hrbfnpr::orient
