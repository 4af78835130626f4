// SPDX-License-Identifier: MIT
// A field gives each place of a surface a value and a weight. The weight is 0 where the field says nothing, and 1 where
// the value counts fully.
//
//   points.h        values at points, or at the corners of triangles → the values of the nearest place
//   dabs.h          dabs of a brush, one over the other
//   projection.h    an image, projected onto the surface along a camera
//   PlaceFunction   a function of the caller
//   Field           one of these, whose numbers are brought into a range
#pragma once

#include "base/assert.h"
#include "base/work.h"
#include "paint/dabs.h"
#include "paint/kind.h"
#include "paint/points.h"
#include "paint/projection.h"

#include <array>
#include <utility>
#include <variant>

namespace hrbfnpr::paint {

// A function of the caller. It fills `values` and `weights` for many places. The weights are 1 before the call.
struct PlaceFunction {
    using Fn = std::int32_t (*)(void* user, std::int64_t count, const double* positions, const double* normals,
                                double* values, double* weights);
    Fn function = nullptr;
    void* user = nullptr;
};

using FieldSource = std::variant<PointValues, TriangleValues, PlaceFunction, Dabs, Projection>;

class Field {
public:
    // The numbers of a scalar field are mapped so that range[0] becomes 0 and range[1] becomes 1, and clamped. If both
    // are 0, numbers stay as they are. Colours are clamped to 0 and 1.
    Field(FieldKind kind, const std::array<double, 2>& range, FieldSource&& source)
        : kind_(kind), range_(range), source_(std::move(source)) {
        HRBFNPR_ASSERT(range == (std::array<double, 2>{}) || range[0] != range[1]);
    }

    [[nodiscard]] FieldKind kind() const noexcept { return kind_; }
    [[nodiscard]] int components() const noexcept { return components_of(kind_); }
    // Returns whether values depend on the normals of places.
    [[nodiscard]] bool needs_normals() const noexcept {
        return !std::holds_alternative<PointValues>(source_) && !std::holds_alternative<TriangleValues>(source_);
    }

    // Calls write(i, sample) with the sample at read(i), a Place, for each i from 0 to count - 1. Both run on
    // all threads, except that places of a function are read and written on the calling thread. Throws Error{callback}
    // if the function fails.
    template <class Read, class Write>
    void evaluate(const base::Work& work, std::int64_t count, Read&& read, Write&& write) const {
        if (const auto* const function = std::get_if<PlaceFunction>(&source_)) {
            evaluate_function(work, *function, count, read, write);
            return;
        }
        constexpr std::int64_t places_a_task = 1024;
        work.for_chunks(count, places_a_task, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) write(i, finished(at(read(i))));
        });
    }

private:
    // Places in the arrays that a function of the caller reads and fills.
    struct Call {
        Call(base::Memory& memory, std::int64_t most, int components)
            : position(memory, 3 * most), normal(memory, 3 * most), value(memory, components * most),
              weight(memory, most) {}

        base::Array<double> position, normal, value, weight;
    };

    [[nodiscard]] Sample at(const Place& place) const noexcept;
    [[nodiscard]] Sample finished(Sample sample) const noexcept;
    // Calls the function for the first `count` places of `call`, and checks the numbers that it fills in.
    void call_function(const PlaceFunction& function, std::int64_t count, Call& call) const;
    [[nodiscard]] Sample sample_of(const Call& call, std::int64_t i) const noexcept;

    template <class Read, class Write>
    void evaluate_function(const base::Work& work, const PlaceFunction& function, std::int64_t count, Read&& read,
                           Write&& write) const {
        constexpr std::int64_t places_a_call = 4096;
        Call call(work.memory, std::min(count, places_a_call), components());
        for (std::int64_t begin = 0; begin < count; begin += places_a_call) {
            work.update(static_cast<double>(begin) / static_cast<double>(count));
            const std::int64_t now = std::min(places_a_call, count - begin);
            for (std::int64_t i = 0; i < now; ++i) {
                const Place place = read(begin + i);
                for (int c = 0; c < 3; ++c) {
                    call.position[3 * i + c] = place.position[c];
                    call.normal[3 * i + c] = place.normal[c];
                }
            }
            call_function(function, now, call);
            for (std::int64_t i = 0; i < now; ++i) write(begin + i, finished(sample_of(call, i)));
        }
    }

    FieldKind kind_;
    std::array<double, 2> range_;
    FieldSource source_;
};

} // namespace hrbfnpr::paint
