// SPDX-License-Identifier: MIT
// The library's handles as shared pointers, its failures as exceptions, and its descriptors with every default.
#pragma once

#include <hrbfnpr.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace viewer {

using Vec = std::array<double, 3>;

inline Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vec operator*(double s, const Vec& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double length(const Vec& a) { return std::sqrt(dot(a, a)); }
inline Vec cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vec unit(const Vec& a) {
    const double size = length(a);
    return size > 0 ? (1 / size) * a : Vec{0, 0, 1};
}

// A call that failed, or a file that cannot be used.
struct Failure : std::runtime_error {
    explicit Failure(const std::string& what, hrbfnpr_status code = HRBFNPR_STATUS_INVALID_ARGUMENT)
        : std::runtime_error(what), status(code) {}
    hrbfnpr_status status;
};

// The error argument of a call. check() turns a failed status into an exception.
class Error {
public:
    Error() { hrbfnpr_error_init(&error_, sizeof error_); }
    operator hrbfnpr_error*() { return &error_; }
    void check(hrbfnpr_status status) const {
        if (status != HRBFNPR_STATUS_OK) throw Failure(error_.message, status);
    }

private:
    hrbfnpr_error error_;
};

// Runs call(&error), which returns a status, and throws if it failed.
template <class Call>
void checked(Call&& call) {
    Error error;
    error.check(call(static_cast<hrbfnpr_error*>(error)));
}

// Runs call(&handle, &error) and owns the handle that it makes.
template <class Handle, class Release, class Call>
std::shared_ptr<Handle> make(Release release, Call&& call) {
    Handle* handle = nullptr;
    checked([&](hrbfnpr_error* error) { return call(&handle, error); });
    return std::shared_ptr<Handle>(handle, release);
}

template <class Struct, class Init>
Struct defaults(Init init) {
    Struct result;
    if (init(&result, sizeof result) != HRBFNPR_STATUS_OK)
        throw Failure("the library is older than this program; install a newer one");
    return result;
}

using Context = std::shared_ptr<hrbfnpr_context>;
using Operation = std::shared_ptr<hrbfnpr_operation>;
using Model = std::shared_ptr<hrbfnpr_model>;
using PointSet = std::shared_ptr<hrbfnpr_point_set>;
using Picture = std::shared_ptr<hrbfnpr_picture>;
using Drawing = std::shared_ptr<hrbfnpr_drawing>;

inline hrbfnpr_array view_of(const std::vector<Vec>& points) {
    return {points.data(), static_cast<std::int64_t>(points.size()), 0, HRBFNPR_SCALAR_FLOAT64, 3};
}

} // namespace viewer
