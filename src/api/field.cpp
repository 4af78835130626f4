// SPDX-License-Identifier: MIT
// Makes and evaluates fields.
#include "api/field.h"

#include "api/barrier.h"
#include "api/camera.h"
#include "api/dabs.h"
#include "api/descriptor.h"
#include "api/fields.h"
#include "api/image.h"
#include "api/lists.h"
#include "api/operation.h"
#include "api/shading.h"
#include "api/views.h"
#include "frame/scene/tuning.h"

#include <glm/matrix.hpp>

#include <cmath>

using namespace hrbfnpr;

static_assert(static_cast<int>(paint::FieldKind::scalar) == HRBFNPR_FIELD_KIND_SCALAR);
static_assert(static_cast<int>(paint::FieldKind::colour) == HRBFNPR_FIELD_KIND_COLOUR);
static_assert(static_cast<int>(paint::FieldKind::direction) == HRBFNPR_FIELD_KIND_DIRECTION);

hrbfnpr_field::hrbfnpr_field(hrbfnpr_context& context, paint::Field&& made, const hrbfnpr_occluders* hiding) noexcept
    : Child(context), field(std::move(made)), occluders_(hiding) {
    if (occluders_ != nullptr) occluders_->add_reference();
}

hrbfnpr_field::~hrbfnpr_field() { api::release_handle(occluders_); }

namespace hrbfnpr::api {
namespace {

using FieldDesc = hrbfnpr_field_desc;

constexpr double most_points = 2e9;

[[nodiscard]] constexpr auto field_desc_fields() noexcept {
    return FieldTable{
        field("kind", &FieldDesc::kind, rule::OneOf{HRBFNPR_FIELD_KIND_DIRECTION, "HRBFNPR_FIELD_KIND_*"}),
        field("source", &FieldDesc::source, rule::OneOf{HRBFNPR_FIELD_SOURCE_IMAGE, "HRBFNPR_FIELD_SOURCE_*"}),
        field("flags", &FieldDesc::flags, rule::Zero{}),
        field("range", &FieldDesc::range, rule::IndexedNumbers{rule::Finite{}}),
        field("points", &FieldDesc::points, rule::Any{}),
        field("triangles", &FieldDesc::triangles, rule::Any{}),
        field("values", &FieldDesc::values, rule::Any{}),
        field("reach", &FieldDesc::reach, rule::not_negative),
        field("function", &FieldDesc::function, rule::Any{}),
        field("user", &FieldDesc::user, rule::Any{}),
        field("dabs", &FieldDesc::dabs, rule::Any{}),
        field("dab_count", &FieldDesc::dab_count, rule::Any{}),
        field("dab_stride", &FieldDesc::dab_stride, rule::Any{}),
        field("image", &FieldDesc::image, rule::Any{}),
        field("camera", &FieldDesc::camera, rule::Any{}),
        field("occluders", &FieldDesc::occluders, rule::Any{})};
}
static_assert(field_desc_fields().covers<FieldDesc>());

[[nodiscard]] paint::FieldKind kind_of(const FieldDesc& desc) noexcept {
    return static_cast<paint::FieldKind>(desc.kind);
}

// ---- Points

// Returns the values in the range of floats. Bytes of colours become numbers from 0 to 1.
[[nodiscard]] base::Array<double> values_of(base::Memory& memory, const FieldDesc& desc, std::int64_t points) {
    const auto components = static_cast<std::uint32_t>(paint::components_of(kind_of(desc)));
    base::Array<double> values =
        finite_numbers(memory, desc.values, "field_desc.values", {components, float_or_uint8_types});
    if (values.size() != points * components)
        fail(Status::invalid_argument, "field_desc.values has %lld elements, but there are %lld points; give one each",
             static_cast<long long>(values.size() / components), static_cast<long long>(points));
    if (desc.values.scalar == HRBFNPR_SCALAR_UINT8 && kind_of(desc) == paint::FieldKind::colour)
        for (double& value : values) value /= 255.0;
    return values;
}

[[nodiscard]] base::Array<paint::TriangleValues::Triangle> triangles_of(base::Memory& memory, const FieldDesc& desc,
                                                                        std::int64_t points) {
    const base::InView given = in_view(desc.triangles, "field_desc.triangles", {3, index_types});
    base::Array<paint::TriangleValues::Triangle> triangles(memory);
    triangles.resize_for_overwrite(given.count);
    for (std::int64_t i = 0; i < given.count; ++i)
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const std::int64_t point = given.get_integer(i, corner);
            if (point < 0 || point >= points)
                fail(Status::invalid_argument,
                     "field_desc.triangles[%lld] has the point %lld; numbers of points must be from 0 to %lld",
                     static_cast<long long>(i), static_cast<long long>(point), static_cast<long long>(points - 1));
            triangles[i][corner] = static_cast<std::int32_t>(point);
        }
    return triangles;
}

[[nodiscard]] paint::FieldSource of_points(const base::Work& work, const FieldDesc& desc) {
    const base::Array<double> numbers = finite_numbers(work.memory, desc.points, "field_desc.points", points_type);
    const std::int64_t count = numbers.size() / 3;
    if (count == 0) fail(Status::invalid_argument, "field_desc.points is empty; give at least one point");
    Checks("field_desc").between("points.count", static_cast<double>(count), 1.0, most_points);
    base::Array<double> values = values_of(work.memory, desc, count);
    auto triangles = triangles_of(work.memory, desc, count);
    const auto point_at = [&](std::int64_t i) {
        return glm::dvec3(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
    };
    if (!triangles.empty()) {
        base::Array<glm::dvec3> points(work.memory);
        points.resize_for_overwrite(count);
        for (std::int64_t i = 0; i < count; ++i) points[i] = point_at(i);
        return paint::TriangleValues(work, std::move(points), std::move(triangles), kind_of(desc), std::move(values),
                                     desc.reach);
    }
    geometry::VecArray points(work.memory, count);
    for (std::int64_t i = 0; i < count; ++i) points.set(i, point_at(i));
    return paint::PointValues(work, points, kind_of(desc), std::move(values), desc.reach);
}

// ---- Dabs

[[nodiscard]] glm::dvec3 vector_of(const double (&numbers)[3]) noexcept { return {numbers[0], numbers[1], numbers[2]}; }

[[nodiscard]] paint::FieldSource of_dabs(base::Memory& memory, const FieldDesc& desc) {
    const List<hrbfnpr_dab> list(desc.dabs, desc.dab_count, desc.dab_stride, most_dabs, "field_desc.dabs");
    base::Array<paint::Dab> dabs(memory);
    for (std::int64_t i = 0; i < list.count(); ++i) {
        const hrbfnpr_dab dab = list[i];
        dab_fields().check(list.name(i).text, dab);
        const glm::dvec3 value =
            desc.kind == HRBFNPR_FIELD_KIND_SCALAR ? glm::dvec3(dab.value, 0.0, 0.0) : vector_of(dab.direction);
        dabs.push_back({vector_of(dab.position), vector_of(dab.normal), dab.radius, dab.strength, value});
    }
    return paint::Dabs(memory, kind_of(desc), std::as_const(dabs).span());
}

// ---- Images

[[nodiscard]] paint::Pixels pixels_of(const base::Work& work, const FieldDesc& desc, const output::Image& image) {
    if (desc.kind == HRBFNPR_FIELD_KIND_DIRECTION)
        fail(Status::invalid_argument, "field_desc.kind is DIRECTION; an image gives a SCALAR or a COLOUR");
    if (image.format == output::Format::coverage8)
        fail(Status::invalid_argument, "field_desc.image.format is COVERAGE8; give a format with colours");
    paint::Pixels pixels(work.memory, kind_of(desc), image.width, image.height);
    work.for_each(image.height, [&](std::int64_t row) {
        for (std::int64_t column = 0; column < image.width; ++column) {
            const std::byte* const from =
                image.pixels + row * image.row_stride + column * output::bytes_of_pixel(image.format);
            const glm::vec4 colour = output::load_pixel(from, image.format);
            for (int c = 0; c < 4; ++c)
                if (!std::isfinite(colour[c]))
                    fail(Status::invalid_argument, "field_desc.image has a number that is not finite at (%lld, %lld)",
                         static_cast<long long>(column), static_cast<long long>(row));
            float* const to = pixels.at(column, row);
            if (desc.kind == HRBFNPR_FIELD_KIND_SCALAR)
                to[0] = 0.2126F * colour.x + 0.7152F * colour.y + 0.0722F * colour.z;
            else
                for (int c = 0; c < 3; ++c) to[c] = colour[c];
            to[pixels.channels - 1] = colour.w;
        }
    });
    return pixels;
}

[[nodiscard]] paint::Projector projector_of(const FieldDesc& desc) {
    const frame::Camera camera = to_camera(read_struct(desc.camera, "field_desc.camera"));
    frame::check(camera);
    const frame::Optics optics = frame::make_optics(camera);
    paint::Projector projector;
    projector.to_window = optics.window * camera.view;
    projector.eye = glm::inverse(camera.view) * optics.centre;
    projector.viewport = camera.viewport;
    if (desc.occluders != nullptr) {
        projector.occluders = &desc.occluders->casters.tree;
        projector.offset = frame::scene_tuning.shading_offset * desc.occluders->casters.cell;
    }
    return projector;
}

[[nodiscard]] paint::FieldSource of_image(const base::Work& work, const FieldDesc& desc) {
    const output::Image image = checked_image(read_struct(desc.image, "field_desc.image"), "field_desc.image");
    const paint::Projector projector = projector_of(desc);
    return paint::Projection(pixels_of(work, desc, image), projector);
}

// ---- Fields

[[nodiscard]] paint::FieldSource source_of(const base::Work& work, const FieldDesc& desc) {
    switch (desc.source) {
    case HRBFNPR_FIELD_SOURCE_POINTS: return of_points(work, desc);
    case HRBFNPR_FIELD_SOURCE_DABS: return of_dabs(work.memory, desc);
    case HRBFNPR_FIELD_SOURCE_IMAGE: return of_image(work, desc);
    default: Checks("field_desc").not_null("function", desc.function != nullptr);
    }
    return paint::PlaceFunction{desc.function, desc.user};
}

hrbfnpr_field* create(hrbfnpr_context& context, const FieldDesc& desc, hrbfnpr_operation* operation) {
    field_desc_fields().check("field_desc", desc);
    if (desc.range[0] == desc.range[1] && desc.range[0] != 0.0)
        fail(Status::invalid_argument, "field_desc.range is %g to %g; its ends must differ, or both be 0",
             desc.range[0], desc.range[1]);
    const OperationUse use(operation);
    const bool has_occluders = desc.source == HRBFNPR_FIELD_SOURCE_IMAGE;
    return use.finish_with(make_handle<hrbfnpr_field>(
        context,
        paint::Field(kind_of(desc), {desc.range[0], desc.range[1]}, source_of({context.runtime, use.progress()}, desc)),
        has_occluders ? desc.occluders : nullptr));
}

[[nodiscard]] glm::dvec3 finite_vector(const base::InView& view, std::int64_t i, const char* name) {
    const glm::dvec3 v(view.get(i, 0), view.get(i, 1), view.get(i, 2));
    if (!(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)))
        fail(Status::invalid_argument, "%s[%lld] is not finite", name, static_cast<long long>(i));
    return v;
}

void evaluate(const hrbfnpr_field& handle, const hrbfnpr_array& positions, const hrbfnpr_array* normals,
              const hrbfnpr_array_out* values, const hrbfnpr_array_out* weights, hrbfnpr_operation* operation) {
    const paint::Field& given = handle.field;
    const base::InView position = in_view(positions, "positions", points_type);
    const base::InView normal =
        normals != nullptr ? in_view(*normals, "normals", points_type, position.count) : base::InView{};
    if (given.needs_normals() && normal.count != position.count)
        fail(Status::invalid_argument, "normals are not given; this field depends on them");
    const auto components = static_cast<std::uint32_t>(given.components());
    const base::OutView value = out_view(values, "values", {components, float_types}, position.count);
    const base::OutView weight = out_view(weights, "weights", number_type, position.count);
    const OperationUse use(operation);
    given.evaluate(
        {handle.runtime(), use.progress()}, position.count,
        [&](std::int64_t i) {
            return paint::Place{finite_vector(position, i, "positions"),
                                normal.empty() ? glm::dvec3(0.0) : finite_vector(normal, i, "normals")};
        },
        [&](std::int64_t i, const paint::Sample& sample) {
            for (std::uint32_t c = 0; value && c < components; ++c) value.set(i, c, sample.value[static_cast<int>(c)]);
            if (weight) weight.set(i, 0, sample.weight);
        });
    use.finish();
}

} // namespace

template <>
hrbfnpr_field_desc defaults() noexcept {
    return {};
}

template <>
hrbfnpr_dab defaults() noexcept {
    hrbfnpr_dab dab{};
    dab.strength = 1.0;
    return dab;
}

} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_dab_init(hrbfnpr_dab* dab, uint32_t struct_size) { return api::init_struct(dab, struct_size); }

hrbfnpr_status hrbfnpr_field_desc_init(hrbfnpr_field_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_field_create(hrbfnpr_context* context, const hrbfnpr_field_desc* desc,
                                    hrbfnpr_operation* operation, hrbfnpr_field** out_field, hrbfnpr_error* error) {
    return api::guarded_create(out_field, "out_field", error, [&] {
        return api::create(api::deref(context, "context"), api::read_struct(desc, "field_desc"), operation);
    });
}

void hrbfnpr_field_retain(const hrbfnpr_field* field) {
    if (field != nullptr) field->add_reference();
}

void hrbfnpr_field_release(const hrbfnpr_field* field) { api::release_handle(field); }

hrbfnpr_status hrbfnpr_field_evaluate(const hrbfnpr_field* field, const hrbfnpr_array* positions,
                                      const hrbfnpr_array* normals, const hrbfnpr_array_out* values,
                                      const hrbfnpr_array_out* weights, hrbfnpr_operation* operation,
                                      hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        api::evaluate(api::deref(field, "field"), api::deref(positions, "positions"), normals, values, weights,
                      operation);
    });
}

} // extern "C"
