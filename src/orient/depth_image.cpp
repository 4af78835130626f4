// SPDX-License-Identifier: MIT
// The steps of smoothing a depth image are:
//
//   read           reads the points as 1 / z, and fits the camera: x / z is linear in the column, y / z in the row
//   small_plane    fits a plane to the 5 x 5 pixels around each pixel; the median of their errors is the noise
//   best_plane     chooses the best small plane that covers a pixel: it has no edge in it
//   plane_around   fits a plane to a disc as wide as the noise calls for, without pixels beyond an edge
//   smooth_pixel   writes the point on that plane, and its normal
#include "orient/depth_image.h"

#include "base/assert.h"
#include "base/clock.h"
#include "base/sort.h"
#include "base/status.h"
#include "geometry/long_vec_array.h"
#include "orient/tuning.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrbfnpr::orient {
namespace {

constexpr std::int64_t pixels_a_task = 1024;
constexpr std::int64_t tasks_a_band = 32;
// The amount added to a variance so that a plane fits pixels in one row, in square pixels.
constexpr double regular = 1e-9;
constexpr std::int32_t small_radius = 2; // radius of the square of pixels of a small plane
constexpr double small_count = 25.0;
constexpr double small_square = 50.0; // the sum of (column offset)^2 over the 25 pixels of a small plane
// The standard deviation of the error of rounding to whole numbers: 1 / sqrt(12).
constexpr double of_step = 0.2886751345948129;

// The least squares line y = slope x + start, and how well it fits.
class LineFit {
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
    [[nodiscard]] bool fits() const noexcept { return std::abs(xy_) > depth_tuning.in_line * std::sqrt(xx_ * yy_); }

private:
    double count_ = 0.0, mean_x_ = 0.0, mean_y_ = 0.0, xx_ = 0.0, yy_ = 0.0, xy_ = 0.0;
};

struct Camera {
    explicit Camera(base::Memory& memory) noexcept : depth(memory), error(memory) {}

    [[nodiscard]] std::int32_t column_of(std::int64_t i) const noexcept {
        return static_cast<std::int32_t>(i % depth.columns);
    }
    [[nodiscard]] std::int32_t row_of(std::int64_t i) const noexcept {
        return static_cast<std::int32_t>(i / depth.columns);
    }
    // Returns the disc radius for an inverse depth. The error of a plane's slope is the error of its depths divided by
    // the width of the disc. So the radius grows with the ratio of the noise of z to the width of a pixel on the
    // surface, z / focal_length.
    [[nodiscard]] double radius_at(double inverse_depth, double smoothing) const noexcept {
        const double wrong = noise / inverse_depth * focal_length;
        return std::clamp(smoothing * depth_tuning.widening * std::sqrt(wrong), double{Discs::least},
                          double{Discs::most});
    }

    InverseDepth depth;        // in a unit that makes the median of z 1
    base::Array<double> error; // The error of the small plane around each pixel; infinite if there is no small plane.
    LineFit across, down;      // x / z as a linear function of the column, and y / z as one of the row
    std::int64_t seen = 0;
    double sign = 0.0; // the sign of z
    double unit = 1.0; // the median of z
    double focal_length = 0.0;
    double noise = 0.0; // in the unit of `depth`
};

[[nodiscard]] glm::dvec3 given_point(const DepthImageInput& input, std::int64_t i) noexcept {
    return {input.points.get(i, 0), input.points.get(i, 1), input.points.get(i, 2)};
}

// Returns the median. The values are reordered.
[[nodiscard]] double median(base::Array<double>& values, const base::Progress& progress) {
    if (values.empty()) return 0.0;
    progress.check();
    double* const middle = values.begin() + values.size() / 2;
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

[[nodiscard]] base::Array<double> values_if(const base::Array<double>& from, bool (*wanted)(double),
                                            const base::Progress& progress) {
    base::Array<double> some(from.memory());
    for (const std::int64_t i : progress.over(from.size())) {
        if (wanted(from[i])) some.push_back(from[i]);
    }
    return some;
}

void require_camera(const Camera& camera) {
    if (camera.seen < depth_tuning.least_seen)
        fail(Status::invalid_argument,
             "depth_image_desc.points has %lld points with a z that is finite and not 0; give at least %lld",
             static_cast<long long>(camera.seen), static_cast<long long>(depth_tuning.least_seen));
    if (camera.across.fits() && camera.down.fits()) return;
    fail(Status::invalid_argument,
         "depth_image_desc.points are not an image of a camera at the origin that looks along z: %s; give them row by "
         "row, in camera coordinates",
         camera.across.fits() ? "y / z does not change linearly with the row"
                              : "x / z does not change linearly with the column");
}

// Returns the step between consecutive values of 1 / z, or 0 if 1 / z has too many different values to have steps.
[[nodiscard]] double depth_step(const base::Array<double>& depth, const base::Progress& progress) {
    base::Array<double> values = values_if(
        depth, [](double x) { return !std::isnan(x); }, progress);
    base::sort_long(values.begin(), values.end(), std::less<>(), progress);
    base::Array<double> gaps(depth.memory());
    for (std::int64_t i = 1; i < values.size(); ++i)
        if (values[i] > values[i - 1]) gaps.push_back(values[i] - values[i - 1]);
    return depth_tuning.same_steps * (gaps.size() + 1) > values.size() ? 0.0 : median(gaps, progress);
}

// Reads z of one pixel into `camera.depth`, and adds the pixel to the camera's two lines.
void read_pixel(const DepthImageInput& input, std::int64_t i, Camera& camera) {
    const glm::dvec3 p = given_point(input, i);
    camera.depth.value[i] = std::numeric_limits<double>::quiet_NaN();
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z) || p.z == 0.0) return;
    if (camera.sign == 0.0) camera.sign = p.z > 0.0 ? 1.0 : -1.0;
    if (camera.sign * p.z < 0.0)
        fail(Status::invalid_argument,
             "depth_image_desc.points[%lld] has z = %g, but others have the opposite sign; give points in front of a "
             "camera at the origin",
             static_cast<long long>(i), p.z);
    camera.depth.value[i] = std::abs(p.z);
    ++camera.seen;
    camera.across.add(camera.column_of(i), p.x / p.z);
    camera.down.add(camera.row_of(i), p.y / p.z);
}

[[nodiscard]] Camera read(const base::Work& work, const DepthImageInput& input) {
    Camera camera(work.memory);
    InverseDepth& depth = camera.depth;
    depth.columns = input.columns;
    depth.rows = input.rows;
    depth.value.resize_for_overwrite(depth.size());
    for (const std::int64_t i : work.over(depth.size())) {
        read_pixel(input, i, camera);
    }
    require_camera(camera);
    camera.focal_length = 1.0 / std::sqrt(std::abs(camera.across.slope() * camera.down.slope()));
    base::Array<double> seen = values_if(
        depth.value, [](double x) { return !std::isnan(x); }, work);
    camera.unit = median(seen, work);
    for (const std::int64_t i : work.over(depth.size())) {
        depth.value[i] = camera.unit / depth.value[i];
    }
    base::resize_long(camera.error, depth.size(), work);
    work.for_chunks(depth.size(), pixels_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const auto plane = small_plane(depth, camera.column_of(i), camera.row_of(i));
            camera.error[i] = plane ? plane->error : std::numeric_limits<double>::infinity();
        }
    });
    if (input.noise > 0.0) {
        camera.noise = input.noise * camera.unit;
    } else {
        base::Array<double> errors = values_if(
            camera.error, [](double x) { return std::isfinite(x); }, work);
        camera.noise = std::max(median(errors, work), of_step * depth_step(depth.value, work));
    }
    return camera;
}

// Returns the plane with which the fit at a pixel starts. The plane passes through the depth of the pixel, and has the
// slope of the best small plane that covers the pixel. Its error is the error that nearby pixels may have, by noise or
// by curvature.
[[nodiscard]] SmallPlane best_plane(const Camera& camera, std::int64_t i) noexcept {
    const InverseDepth& depth = camera.depth;
    const std::int32_t column = camera.column_of(i);
    const std::int32_t row = camera.row_of(i);
    const double here = depth.value[i];
    std::int64_t best = i;
    for (std::int32_t y = std::max(row - small_radius, 0); y <= std::min(row + small_radius, depth.rows - 1); ++y)
        for (std::int32_t x = std::max(column - small_radius, 0);
             x <= std::min(column + small_radius, depth.columns - 1); ++x) {
            const std::int64_t at = std::int64_t{y} * depth.columns + x;
            if (camera.error[at] < camera.error[best]) best = at;
        }
    SmallPlane plane{{here, 0.0, 0.0}, std::max(camera.noise, depth_tuning.rounding * here)};
    if (const auto found = small_plane(depth, camera.column_of(best), camera.row_of(best))) {
        plane.plane = {here, found->plane.across, found->plane.down};
        plane.error = std::max(plane.error, std::min(found->error, depth_tuning.most_curved * here));
    }
    return plane;
}

// Writes one pixel of the image. Returns false if its point is left out.
bool smooth_pixel(const Camera& camera, const DepthImageInput& input, const Discs& discs, std::int64_t i,
                  DepthImage& image) noexcept {
    image.point.set(i, glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
    const double here = camera.depth.value[i];
    if (std::isnan(here)) return true;
    const std::int32_t column = camera.column_of(i);
    const std::int32_t row = camera.row_of(i);
    const auto radius = static_cast<std::int32_t>(std::lround(camera.radius_at(here, input.smoothing)));
    const auto plane = plane_around(camera.depth, column, row, discs.of(radius), best_plane(camera, i));
    if (!plane || !(plane->value > 0.0)) return false;
    const glm::dvec3 seen = given_point(input, i);
    const double nx = plane->across / camera.across.slope();
    const double ny = plane->down / camera.down.slope();
    const glm::dvec3 normal(nx, ny, plane->value - nx * camera.across.at(column) - ny * camera.down.at(row));
    // The normal points to the camera, against the direction (u, v, 1) of points with z > 0.
    image.normal.set(i, -camera.sign * glm::normalize(normal));
    image.point.set(i, input.keep_points ? seen : seen * (here / plane->value));
    return true;
}

[[nodiscard]] double weight_of(double square) noexcept { return 1.0 - (1.0 - depth_tuning.least_weight) * square; }

void add_whole_disc(std::int32_t radius, base::Array<Tap>& taps) {
    const double square = (radius + 0.5) * (radius + 0.5);
    for (std::int32_t down = -radius; down <= radius; ++down)
        for (std::int32_t across = -radius; across <= radius; ++across) {
            const double away = (static_cast<double>(across) * across + static_cast<double>(down) * down) / square;
            if (away <= 1.0) taps.push_back({across, down, weight_of(away)});
        }
}

// Adds the middle pixel, and rings of pixels around it. The first ring has 6 pixels, and each further ring has 6 pixels
// more than the previous ring.
void add_ringed_disc(std::int32_t radius, base::Array<Tap>& taps) {
    taps.push_back({0, 0, 1.0});
    constexpr int rings = depth_tuning.rings;
    for (int ring = 1; ring <= rings; ++ring)
        for (int k = 0; k < 6 * ring; ++k) {
            const double angle = (k + 0.5 * (ring % 2)) / (6 * ring) * 6.283185307179586;
            const double away = static_cast<double>(ring) / rings;
            taps.push_back({static_cast<std::int32_t>(std::lround(away * radius * std::cos(angle))),
                            static_cast<std::int32_t>(std::lround(away * radius * std::sin(angle))),
                            weight_of(away * away)});
        }
}

// The sums of a plane's weighted least squares.
struct Sums {
    double weight = 0.0;
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
    double d = 0.0, dx = 0.0, dy = 0.0;

    void add(const Tap& tap, double depth) noexcept {
        const double w = tap.weight;
        const double wx = w * tap.across;
        const double wy = w * tap.down;
        weight += w;
        x += wx;
        y += wy;
        xx += wx * tap.across;
        xy += wx * tap.down;
        yy += wy * tap.down;
        d += w * depth;
        dx += wx * depth;
        dy += wy * depth;
    }

    [[nodiscard]] DepthPlane plane() const noexcept {
        const double mx = x / weight;
        const double my = y / weight;
        const double cxx = xx - mx * x + regular * weight;
        const double cxy = xy - mx * y;
        const double cyy = yy - my * y + regular * weight;
        const double bx = dx - mx * d;
        const double by = dy - my * d;
        const double determinant = cxx * cyy - cxy * cxy;
        DepthPlane plane;
        plane.across = (cyy * bx - cxy * by) / determinant;
        plane.down = (cxx * by - cxy * bx) / determinant;
        plane.value = d / weight - plane.across * mx - plane.down * my;
        return plane;
    }
};

} // namespace

std::optional<SmallPlane> small_plane(const InverseDepth& depth, std::int32_t column, std::int32_t row) noexcept {
    HRBFNPR_ASSERT(column >= 0 && column < depth.columns && row >= 0 && row < depth.rows);
    constexpr std::int32_t r = small_radius;
    if (column < r || row < r || column >= depth.columns - r || row >= depth.rows - r) return std::nullopt;
    const double here = depth.at(column, row); // Subtracting the depth of this pixel keeps the sums of squares exact.
    double sum = 0.0;
    double across = 0.0;
    double down = 0.0;
    double squares = 0.0;
    for (std::int32_t y = -r; y <= r; ++y)
        for (std::int32_t x = -r; x <= r; ++x) {
            const double d = depth.at(column + x, row + y) - here;
            sum += d;
            across += x * d;
            down += y * d;
            squares += d * d;
        }
    if (!std::isfinite(squares)) return std::nullopt;
    const double off = squares - sum * sum / small_count - (across * across + down * down) / small_square;
    return SmallPlane{{here + sum / small_count, across / small_square, down / small_square},
                      std::sqrt(std::max(off, 0.0) / (small_count - 3.0))};
}

Discs::Discs(base::Memory& memory) : taps_(memory) {
    for (std::int32_t radius = least; radius <= most; ++radius) {
        if (radius <= depth_tuning.all_pixels_up_to)
            add_whole_disc(radius, taps_);
        else
            add_ringed_disc(radius, taps_);
        start_[static_cast<std::size_t>(radius - least) + 1] = taps_.size();
    }
}

std::optional<DepthPlane> plane_around(const InverseDepth& depth, std::int32_t column, std::int32_t row,
                                       std::span<const Tap> disc, const SmallPlane& first) noexcept {
    HRBFNPR_ASSERT(column >= 0 && column < depth.columns && row >= 0 && row < depth.rows);
    HRBFNPR_ASSERT(!disc.empty() && first.error >= 0.0);
    const double here = depth.at(column, row);
    const double limit = depth_tuning.gate * first.error;
    DepthPlane plane = first.plane;
    double whole = 0.0;
    for (const Tap& tap : disc) whole += tap.weight;
    for (int round = 0; round < depth_tuning.plane_rounds; ++round) {
        Sums sums;
        for (const Tap& tap : disc) {
            const std::int32_t x = column + tap.across;
            const std::int32_t y = row + tap.down;
            if (x < 0 || y < 0 || x >= depth.columns || y >= depth.rows) continue;
            const double d = depth.at(x, y);
            const double off = d - (plane.value + plane.across * tap.across + plane.down * tap.down);
            if (std::abs(off) <= limit) sums.add(tap, d - here);
        }
        if (!(sums.weight >= depth_tuning.least_part * whole)) return std::nullopt;
        plane = sums.plane();
        plane.value += here;
    }
    return std::abs(plane.value - here) <= limit ? std::optional(plane) : std::nullopt;
}

DepthImage smooth_depth_image(const base::Work& work, const DepthImageInput& input) {
    HRBFNPR_ASSERT(input.points.count == std::int64_t{input.columns} * input.rows && input.smoothing > 0.0);
    const base::Stopwatch watch;
    const Camera camera = read(work.part(0.0, 0.05), input);
    const Discs discs(work.memory);
    const std::int64_t pixels = camera.depth.size();
    DepthImage image(work.memory);
    geometry::resize_long(image.point, pixels, work);
    geometry::resize_long(image.normal, pixels, work);
    const std::int64_t tasks = (pixels + pixels_a_task - 1) / pixels_a_task;
    base::Array<std::int64_t> left_out(work.memory, tasks);
    const base::Work smoothing = work.part(0.05, 1.0);
    for (std::int64_t from = 0; from < tasks; from += tasks_a_band) {
        const std::int64_t count = std::min(tasks_a_band, tasks - from);
        smoothing.for_each(count, [&](std::int64_t task) {
            const std::int64_t begin = (from + task) * pixels_a_task;
            for (std::int64_t i = begin; i < std::min(begin + pixels_a_task, pixels); ++i)
                left_out[from + task] += smooth_pixel(camera, input, discs, i, image) ? 0 : 1;
        });
        smoothing.update(static_cast<double>(from + count) / static_cast<double>(tasks));
    }
    DepthImageReport& report = image.report;
    report.seen = camera.seen;
    for (const std::int64_t count : left_out) report.left_out += count;
    report.noise = camera.noise / camera.unit;
    report.focal_length = camera.focal_length;
    report.depth = camera.unit;
    report.radius = camera.radius_at(1.0, input.smoothing);
    report.seconds = watch.seconds();
    work.runtime().log(
        base::LogLevel::info, "depth image: %lld points smoothed over %.1f pixels in %.2f s; %lld left out",
        static_cast<long long>(report.seen), report.radius, report.seconds, static_cast<long long>(report.left_out));
    work.update(1.0);
    return image;
}

} // namespace hrbfnpr::orient
