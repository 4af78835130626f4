// SPDX-License-Identifier: MIT
// Models, marks and line sets that are made once and used by harnesses on any thread.
#pragma once

#include "fuzz.h"
#include "input.h"

#include <mutex>

namespace fuzz {

// The context of all scenes. Neither the context nor the scenes are ever released.
Context& scene_context();

// Calls make(which) once, and returns this result every time.
template <std::size_t count, class T>
class Once {
public:
    const T* operator()(std::size_t which, const T* (*make)(std::size_t)) {
        std::call_once(flags_[which], [&] { made_[which] = make(which); });
        return made_[which];
    }

private:
    std::array<std::once_flag, count> flags_;
    std::array<const T*, count> made_{};
};

constexpr std::size_t model_count = 5;
// Fits of a sphere, a torus, a trimmed sheet, two spheres and one sample.
const hrbfnpr_model* scene_model(std::size_t which);

constexpr std::size_t set_count = 5;
// A few hundred marks: stipples and hatching; two layers of hatching; marks of the published method; a few marks of the
// caller's; one mark.
const hrbfnpr_point_set* scene_set(std::size_t which);

constexpr std::size_t line_set_count = 3;
// Line sets of the torus with lines of all kinds, of the sheet with its border, and of two spheres.
const hrbfnpr_line_set* scene_lines(std::size_t which);

// A caller's function, often an awkward one, which fails after a number of points.
class Custom {
public:
    explicit Custom(Input& input);
    // Returns NULL if the function is refused.
    hrbfnpr_model* create(Context& context, Input& input);

private:
    enum class Shape { sphere, torus, plane, waves, crease, step, constant, flat_top, not_finite_beyond, count };

    static std::int32_t evaluate(void* user, std::int64_t count, const double* points, double* value, double* gradient,
                                 double* hessian);
    [[nodiscard]] double value(const double* point) const;

    Shape shape_;
    double scale_;
    double size_; // size of the surface, in units of the bounds
    std::int64_t left_;
};

// Makes a tree of a few nodes, some of which are scene models. Returns NULL if the tree is refused.
hrbfnpr_model* create_csg(Context& context, Input& input);

} // namespace fuzz
