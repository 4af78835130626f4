// SPDX-License-Identifier: MIT
// The points or vectors of a query on a model. They are checked at the beginning and read in blocks, so a call needs
// little working memory.
#pragma once

#include "api/barrier.h"
#include "api/views.h"
#include "base/operation.h"
#include "base/runtime.h"
#include "base/status.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrbfnpr::api {

inline constexpr std::int64_t copy_grain = 4096;
// The largest distance of a query from the bounds of the model, in diagonals.
inline constexpr double farthest_query = 1e50;

class Queries {
public:
    // `name` is the name of the argument, for messages. It must outlive this object.
    Queries(const base::Runtime& runtime, const hrbfnpr_array* array, const char* name)
        : runtime_(runtime), view_(in_view(deref(array, name), name, points_type)), name_(name) {}

    [[nodiscard]] std::int64_t count() const noexcept { return view_.count; }

    // Checks that the points are finite and near enough to the model for f and its derivatives to be finite. Call this
    // after the checks of all other arguments, because it reads all points.
    void check_near(const implicit::Implicit& implicit) const {
        // Bounds from a file may be smaller than the rounding errors of the coordinates.
        const geometry::Bounds& bounds = implicit.bounds();
        const double rounding = 1e-9 * std::max(glm::length(bounds.min), glm::length(bounds.max));
        const geometry::Bounds near = bounds.grown(std::max(farthest_query * implicit.diagonal(), rounding));
        check([&](std::int64_t i) {
            const glm::dvec3 p(view_.get(i, 0), view_.get(i, 1), view_.get(i, 2));
            if (near.contains(p)) return;
            require_finite(i);
            fail(Status::invalid_argument,
                 "%s[%lld] is more than %g diagonals away from the model's bounding box, whose diagonal is %.3g; "
                 "remove it",
                 name_, static_cast<long long>(i), farthest_query, implicit.diagonal());
        });
    }
    void check_finite() const {
        check([&](std::int64_t i) { require_finite(i); });
    }
    void check_not_zero() const {
        check([&](std::int64_t i) {
            if (view_.get(i, 0) == 0.0 && view_.get(i, 1) == 0.0 && view_.get(i, 2) == 0.0)
                fail(Status::invalid_argument, "%s[%lld] is zero; all %s must have a length above 0", name_,
                     static_cast<long long>(i), name_);
        });
    }

    void read(std::int64_t begin, std::int64_t end, geometry::VecArray& block) const {
        block.resize(end - begin);
        runtime_.parallel.for_chunks(end - begin, copy_grain, [&](std::int64_t from, std::int64_t to) {
            for (std::int64_t i = from; i < to; ++i)
                block.set(i, {view_.get(begin + i, 0), view_.get(begin + i, 1), view_.get(begin + i, 2)});
        });
    }

private:
    void require_finite(std::int64_t i) const {
        for (std::uint32_t axis = 0; axis < 3; ++axis)
            if (!std::isfinite(view_.get(i, axis)))
                fail(Status::invalid_argument, "%s[%lld] is NaN or infinite; all %s must be finite", name_,
                     static_cast<long long>(i), name_);
    }
    template <class F>
    void check(F&& look_at) const {
        runtime_.parallel.for_chunks(view_.count, copy_grain, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) look_at(i);
        });
    }

    const base::Runtime& runtime_;
    base::InView view_;
    const char* name_;
};

// Calls work(begin, end, progress) for consecutive blocks of [0, count).
template <class F>
void for_blocks(std::int64_t count, std::int64_t block_size, const base::Progress& progress, F&& work) {
    const auto share = [&](std::int64_t i) { return static_cast<double>(i) / static_cast<double>(count); };
    for (std::int64_t begin = 0; begin < count; begin += block_size) {
        const std::int64_t end = std::min(count, begin + block_size);
        work(begin, end, progress.part(share(begin), share(end)));
    }
}

// Writes a number. Throws if it is finite, but too large for the caller's floats.
class CheckedOutput {
public:
    explicit CheckedOutput(const char* name) noexcept : name_(name) {}

    void set(const base::OutView& out, std::int64_t i, std::uint32_t component, double number) const {
        if (out.scalar == base::Scalar::float32 && std::abs(number) > most && std::isfinite(number))
            fail(Status::invalid_argument, "%s[%lld] is %.3g, too large for FLOAT32; give a FLOAT64 array", name_,
                 static_cast<long long>(i), number);
        out.set(i, component, number);
    }
    void set(const base::OutView& out, std::int64_t i, const glm::dvec3& v, std::uint32_t first_component = 0) const {
        for (std::uint32_t axis = 0; axis < 3; ++axis)
            set(out, i, first_component + axis, v[static_cast<glm::length_t>(axis)]);
    }

private:
    static constexpr double most = std::numeric_limits<float>::max();
    const char* name_;
};

inline void set_vector(const base::OutView& out, std::int64_t i, const glm::dvec3& v,
                       std::uint32_t first_component = 0) noexcept {
    for (std::uint32_t axis = 0; axis < 3; ++axis)
        out.set(i, first_component + axis, v[static_cast<glm::length_t>(axis)]);
}

// Throws if a number does not fit into the output. It must be called before any output is written.
inline void check_fits(double number, std::int64_t element, const base::OutView& to, const char* name) {
    constexpr double most = 3.4028234663852886e38;
    if (to.scalar == base::Scalar::float32 && std::isfinite(number) && std::abs(number) > most)
        fail(Status::invalid_argument, "%s[%lld] is %g, too large for FLOAT32; give a FLOAT64 array", name,
             static_cast<long long>(element), number);
}

inline void check_fits(const geometry::VecArray& from, const base::OutView& to, const char* name) {
    if (!to || to.scalar != base::Scalar::float32) return;
    for (std::int64_t i = 0; i < from.size(); ++i)
        for (glm::length_t c = 0; c < 3; ++c) check_fits(from[i][c], i, to, name);
}

inline void write_vectors(const base::Runtime& runtime, const geometry::VecArray& from, const base::OutView& to) {
    if (!to) return;
    runtime.parallel.for_chunks(from.size(), copy_grain, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
            for (std::uint32_t c = 0; c < 3; ++c) to.set(i, c, from[i][static_cast<glm::length_t>(c)]);
    });
}

} // namespace hrbfnpr::api
