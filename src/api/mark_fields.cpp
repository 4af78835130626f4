// SPDX-License-Identifier: MIT
// Gives the marks of point sets values of fields.
#include "marks/fields.h"

#include "api/barrier.h"
#include "api/camera.h"
#include "api/checks.h"
#include "api/descriptor.h"
#include "api/field.h"
#include "api/layers.h"
#include "api/lists.h"
#include "api/operation.h"
#include "api/point_set.h"
#include "api/views.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace hrbfnpr;

namespace hrbfnpr::api {

template <>
hrbfnpr_mark_field defaults() noexcept {
    return {};
}

namespace {

// A field of the caller, and the matrices from the coordinates of the set to those of the field, and back.
struct GivenField {
    marks::LayerName name;
    const paint::Field* field; // null: the set loses its values of this name
    glm::dmat4 to_field;
    glm::dmat3 normal_to_field; // The length of its products does not matter.
    glm::dmat3 to_set;
};

[[nodiscard]] glm::dmat4 checked_transform(const double* given, const char* owner) {
    if (given == nullptr) return glm::dmat4(1.0);
    const glm::dmat4 m = to_matrix(given);
    for (int i = 0; i < 16; ++i)
        if (!std::isfinite(m[i / 4][i % 4]))
            fail(Status::invalid_argument, "%s.transform[%d] is %g; all 16 elements must be finite", owner, i,
                 m[i / 4][i % 4]);
    if (m[0][3] != 0.0 || m[1][3] != 0.0 || m[2][3] != 0.0 || m[3][3] != 1.0)
        fail(Status::invalid_argument, "%s.transform is not affine; elements 3, 7, 11 and 15 must be 0 0 0 1", owner);
    const double volume = std::abs(glm::determinant(glm::dmat3(m)));
    if (!(volume > 0.0 && std::isfinite(volume)))
        fail(Status::invalid_argument, "%s.transform is singular; it must be invertible", owner);
    return m;
}

[[nodiscard]] GivenField checked(const hrbfnpr_mark_field& given, const char* owner) {
    const Checks checks(owner);
    checks.zero("reserved", given.reserved);
    checks.not_null("name", given.name != nullptr);
    GivenField field{checked_name(given.name, owner), nullptr, checked_transform(given.transform, owner),
                     glm::dmat3(1.0), glm::dmat3(1.0)};
    if (given.field != nullptr) field.field = &given.field->field;
    if (given.transform != nullptr) {
        field.to_set = glm::inverse(glm::dmat3(field.to_field));
        field.normal_to_field = glm::transpose(field.to_set);
    }
    return field;
}

[[nodiscard]] float to_float(double number) noexcept {
    constexpr auto most = static_cast<double>(std::numeric_limits<float>::max());
    return static_cast<float>(std::clamp(number, -most, most));
}

[[nodiscard]] marks::MarkField values_at_marks(const base::Work& work, const marks::PointSet& set,
                                               const marks::Layer& layer, const GivenField& given) {
    const paint::Field& field = *given.field;
    const std::int64_t count = layer.count();
    const int components = field.components();
    marks::MarkField result(work.memory);
    result.name = given.name;
    result.kind = field.kind();
    result.value.resize_for_overwrite(components * count);
    result.weight.resize_for_overwrite(count);
    field.evaluate(
        work, count,
        [&](std::int64_t i) {
            const glm::dvec3 place = set.origin + glm::dvec3(marks::vector_at(layer.position, i));
            const glm::dvec3 normal = given.normal_to_field * glm::dvec3(marks::vector_at(layer.normal, i));
            return paint::Place{glm::dvec3(given.to_field * glm::dvec4(place, 1.0)), glm::normalize(normal)};
        },
        [&](std::int64_t i, const paint::Sample& sample) {
            const glm::dvec3 value =
                field.kind() == paint::FieldKind::direction ? given.to_set * sample.value : sample.value;
            for (int c = 0; c < components; ++c) result.value[components * i + c] = to_float(value[c]);
            result.weight[i] = static_cast<float>(sample.weight);
        });
    if (std::all_of(result.weight.begin(), result.weight.end(), [](float weight) { return weight == 1.0F; }))
        result.weight.release();
    return result;
}

hrbfnpr_point_set* with_fields(hrbfnpr_context& context, const hrbfnpr_point_set& base,
                               const List<hrbfnpr_mark_field>& list, hrbfnpr_operation* operation) {
    base::Memory& memory = context.runtime.memory;
    base::Array<GivenField> given(memory);
    base::Array<marks::LayerName> names(memory);
    for (std::int64_t i = 0; i < list.count(); ++i) {
        given.push_back(checked(list[i], list.name(i).text));
        const marks::LayerName& name = given.back().name;
        if (std::find(names.begin(), names.end(), name) != names.end())
            fail(Status::invalid_argument, "%s.name is \"%s\", as that of an earlier field", list.name(i).text,
                 name.data());
        names.push_back(name);
    }
    const OperationUse use(operation);
    const base::Work work{context.runtime, use.progress()};
    marks::PointSet set = marks::sharing_marks(memory, base.set, std::as_const(names).span());
    const std::int64_t fields =
        marks::field_count(set) +
        std::count_if(given.begin(), given.end(), [](const GivenField& one) { return one.field != nullptr; });
    if (fields > marks::most_fields)
        fail(Status::invalid_argument, "the set would have %lld fields; it must have at most %lld",
             static_cast<long long>(fields), static_cast<long long>(marks::most_fields));
    for (std::int64_t i = 0; i < given.size(); ++i) {
        if (given[i].field == nullptr) continue;
        const double begin = static_cast<double>(i) / static_cast<double>(given.size());
        work.update(begin);
        for (marks::Layer& layer : set.layers)
            layer.fields.add(values_at_marks(work.without_progress(), set, layer, given[i]));
    }
    return use.finish_with(make_handle<hrbfnpr_point_set>(context, std::move(set), base));
}

void view_field(const marks::PointSet& set, std::int64_t layer, const char* name, hrbfnpr_array& values,
                hrbfnpr_array* weights) {
    const marks::Layer& own = layer_of(set, layer);
    require_pointer(name, "name");
    const marks::MarkField* const any = marks::field_of(set, name);
    if (any == nullptr)
        fail(Status::invalid_argument, "the set has no field \"%.63s\"; hrbfnpr_point_set_with_fields gives it one",
             name);
    const marks::MarkField* const field = own.field_of(name);
    const base::Array<float> none(set.layers.memory());
    values = packed_view(field != nullptr ? field->value : none, HRBFNPR_SCALAR_FLOAT32,
                         static_cast<std::uint32_t>(marks::components_of(any->kind)));
    if (weights != nullptr) *weights = packed_view(field != nullptr ? field->weight : none, HRBFNPR_SCALAR_FLOAT32, 1);
}

} // namespace
} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_mark_field_init(hrbfnpr_mark_field* field, uint32_t struct_size) {
    return api::init_struct(field, struct_size);
}

hrbfnpr_status hrbfnpr_point_set_with_fields(hrbfnpr_context* context, const hrbfnpr_point_set* set,
                                             const hrbfnpr_mark_field* fields, int64_t field_count,
                                             int64_t field_stride, hrbfnpr_operation* operation,
                                             hrbfnpr_point_set** out_point_set, hrbfnpr_error* error) {
    return api::guarded_create(out_point_set, "out_point_set", error, [&] {
        return api::with_fields(api::deref(context, "context"), api::deref(set, "set"),
                                {fields, field_count, field_stride, marks::most_fields, "fields"}, operation);
    });
}

hrbfnpr_status hrbfnpr_point_set_get_field(const hrbfnpr_point_set* set, int64_t number, const char** name,
                                           uint32_t* kind, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const marks::PointSet& own = api::deref(set, "set").set;
        const marks::MarkField* const field = number >= 0 ? marks::field_at(own, number) : nullptr;
        if (field == nullptr)
            fail(Status::invalid_argument, "number is %lld; it must be at least 0 and below the number of fields, %lld",
                 static_cast<long long>(number), static_cast<long long>(marks::field_count(own)));
        if (name != nullptr) *name = field->name.data();
        if (kind != nullptr) *kind = static_cast<std::uint32_t>(field->kind);
    });
}

hrbfnpr_status hrbfnpr_point_set_view_field(const hrbfnpr_point_set* set, int64_t layer, const char* name,
                                            hrbfnpr_array* values, hrbfnpr_array* weights, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        api::view_field(api::deref(set, "set").set, layer, name, api::deref(values, "values"), weights);
    });
}

} // extern "C"
