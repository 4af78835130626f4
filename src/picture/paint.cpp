// SPDX-License-Identifier: MIT
#include "picture/paint.h"

#include "base/assert.h"
#include "picture/make.h"

#include <algorithm>

namespace hrbfnpr::picture {
namespace {

// The values and weights of a field at many places.
struct FieldValues {
    FieldValues(std::size_t count, std::size_t components, Pool& pool)
        : values(count * components, 0.0, &pool), weights(count, 0.0, &pool) {}

    Vector<double> values;
    Vector<double> weights;
};

hrbfnpr_array vectors_view(const double* first, std::int64_t count) noexcept {
    return {first, count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
}

// Evaluates a field. Where it is null, all weights are 0.
FieldValues values_at(const Field& field, std::size_t components, std::int64_t count, const double* positions,
                      const double* normals, Pool& pool) {
    FieldValues found(static_cast<std::size_t>(count), components, pool);
    if (!field) return found;
    const hrbfnpr_array places = vectors_view(positions, count);
    const hrbfnpr_array facing = vectors_view(normals, count);
    const hrbfnpr_array_out values{found.values.data(), count, 0, HRBFNPR_SCALAR_FLOAT64,
                                   static_cast<std::uint32_t>(components)};
    const hrbfnpr_array_out weights{found.weights.data(), count, 0, HRBFNPR_SCALAR_FLOAT64, 1};
    call([&](hrbfnpr_error* error) {
        return hrbfnpr_field_evaluate(field.get(), &places, &facing, &values, &weights, nullptr, error);
    });
    return found;
}

std::uint32_t kind_of_map(std::uint32_t map) noexcept {
    return map == HRBFNPR_DAB_DIRECTION ? HRBFNPR_FIELD_KIND_DIRECTION : HRBFNPR_FIELD_KIND_SCALAR;
}

std::shared_ptr<const HeldField> held_over(const Call& call, const Field& below, const Field& above,
                                           bool is_direction) {
    auto held = std::make_shared<HeldField>(FieldOver{&call.pool.memory(), below, above, is_direction});
    auto desc = defaults<hrbfnpr_field_desc>(hrbfnpr_field_desc_init);
    desc.kind = is_direction ? HRBFNPR_FIELD_KIND_DIRECTION : HRBFNPR_FIELD_KIND_SCALAR;
    desc.source = HRBFNPR_FIELD_SOURCE_FUNCTION;
    desc.function = values_over;
    desc.user = &held->over;
    held->field = make<Field>([&](hrbfnpr_field** made, hrbfnpr_error* error) {
        return hrbfnpr_field_create(&call.context, &desc, nullptr, made, error);
    });
    return held;
}

} // namespace

std::int32_t values_over(void* user, std::int64_t count, const double* positions, const double* normals, double* values,
                         double* weights) noexcept {
    HRBFNPR_ASSERT(user != nullptr && count >= 0);
    const auto& over = *static_cast<const FieldOver*>(user);
    const std::size_t components = over.is_direction ? 3 : 1;
    try {
        Pool pool(*over.memory);
        const FieldValues below = values_at(over.below, components, count, positions, normals, pool);
        const FieldValues above = values_at(over.above, components, count, positions, normals, pool);
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            const double* const upper = above.values.data() + components * i;
            const double* const lower = below.values.data() + components * i;
            const double share = over.is_direction && above.weights[i] > 0.0 ? 1.0 : above.weights[i];
            const double rest = (1.0 - share) * below.weights[i];
            weights[i] = std::min(1.0, share + rest);
            for (std::size_t k = 0; k < components; ++k)
                values[components * i + k] =
                    share + rest > 0.0 ? (share * upper[k] + rest * lower[k]) / (share + rest) : 0.0;
        }
    } catch (...) {
        return 1;
    }
    return 0;
}

Field field_of_dabs(const Call& call, std::uint32_t map) {
    Vector<hrbfnpr_dab> dabs(&call.pool);
    std::copy_if(call.options.dabs.begin(), call.options.dabs.end(), std::back_inserter(dabs),
                 [&](const hrbfnpr_dab& dab) { return dab.map == map; });
    if (dabs.empty()) return {};
    auto desc = defaults<hrbfnpr_field_desc>(hrbfnpr_field_desc_init);
    desc.kind = kind_of_map(map);
    desc.source = HRBFNPR_FIELD_SOURCE_DABS;
    desc.dabs = dabs.data();
    desc.dab_count = static_cast<std::int64_t>(dabs.size());
    desc.dab_stride = sizeof(hrbfnpr_dab);
    return make<Field>([&](hrbfnpr_field** made, hrbfnpr_error* error) {
        return hrbfnpr_field_create(&call.context, &desc, nullptr, made, error);
    });
}

std::shared_ptr<const HeldField> numbers_over(const Call& call, const Field& below, const Field& above) {
    return held_over(call, below, above, false);
}

std::shared_ptr<const HeldField> directions_over(const Call& call, const Field& below, const Field& above) {
    return held_over(call, below, above, true);
}

void set_paint(const Call& call, Marks& marks) {
    const Field density = field_of_dabs(call, HRBFNPR_DAB_DENSITY);
    const Field direction = field_of_dabs(call, HRBFNPR_DAB_DIRECTION);
    if (!density && !direction) return;
    for (const hrbfnpr_dab& dab : call.options.dabs)
        if (dab.map != HRBFNPR_DAB_TONE) marks.dabs.push_back(dab);
    if (density) {
        marks.hold(std::make_shared<Field>(density));
        for (hrbfnpr_layer_desc& layer : marks.layers) {
            if (layer.kind != HRBFNPR_LAYER_KIND_STIPPLES) continue;
            layer.density = HRBFNPR_DENSITY_FIELD;
            layer.density_field = density.get();
        }
    }
    if (direction) {
        const auto held = directions_over(call, {}, direction);
        marks.hold(held);
        for (hrbfnpr_layer_desc& layer : marks.layers)
            if (layer.kind == HRBFNPR_LAYER_KIND_HATCH) layer.direction_field = held->field.get();
    }
}

} // namespace hrbfnpr::picture
