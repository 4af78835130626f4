// SPDX-License-Identifier: MIT
// Stages of fields and of point sets that have their values.
#include "stages/stages.h"

#include <array>
#include <cmath>

namespace api_test {
namespace {

using hrbfnpr::test::Field;

std::int32_t waves(void* /*user*/, std::int64_t count, const double* positions, const double* normals, double* values,
                   double* weights) {
    for (std::int64_t i = 0; i < count; ++i) {
        values[i] = 0.5 + 0.5 * std::sin(9.0 * positions[3 * i]);
        weights[i] = std::abs(normals[3 * i + 1]);
    }
    return 0;
}

void append_values(Bytes& bytes, const PointSet& set, const char* name) {
    Error error;
    hrbfnpr_array values{}, weights{};
    for (std::int64_t layer = 0; layer < info_of(set).layers; ++layer) {
        EXPECT_OK(hrbfnpr_point_set_view_field(set.get(), layer, name, &values, &weights, error));
        append(bytes, elements<float>(values));
        append(bytes, elements<float>(weights));
    }
}

} // namespace

// A field of the mesh's vertices, with triangles or without.
hrbfnpr_field_desc Stages::vertex_field_desc(bool with_triangles) const {
    auto desc = made(hrbfnpr_field_desc_init);
    desc.kind = HRBFNPR_FIELD_KIND_DIRECTION;
    desc.points = desc.values = in(triangles_.vertices);
    if (with_triangles) desc.triangles = in(triangles_.triangles);
    return desc;
}

// A field of dabs that overlap.
hrbfnpr_field_desc Stages::dab_field_desc() {
    for (std::size_t i = 0; i < dabs_.size(); ++i) {
        dabs_[i] = made(hrbfnpr_dab_init);
        dabs_[i].position[0] = dabs_[i].normal[0] = 1.0;
        dabs_[i].radius = 0.6 + 0.3 * static_cast<double>(i);
        dabs_[i].strength = dabs_[i].value = 0.5;
    }
    auto desc = made(hrbfnpr_field_desc_init);
    desc.source = HRBFNPR_FIELD_SOURCE_DABS;
    desc.dabs = dabs_.data();
    desc.dab_count = static_cast<std::int64_t>(dabs_.size());
    return desc;
}

// A field of an image that falls on what its camera sees of the surfaces that cast shadows.
hrbfnpr_field_desc Stages::image_field_desc() {
    constexpr std::int32_t side = 32;
    for (int i = 0; i < 4 * side * side; ++i) pixels_.push_back(static_cast<std::uint8_t>(7 * i));
    image_ = made(hrbfnpr_image_init);
    image_.format = HRBFNPR_FORMAT_RGBA8;
    image_.width = image_.height = side;
    image_.pixels = pixels_.data();
    image_camera_ = camera();
    auto desc = made(hrbfnpr_field_desc_init);
    desc.source = HRBFNPR_FIELD_SOURCE_IMAGE;
    desc.image = &image_;
    desc.camera = &image_camera_;
    desc.occluders = occluders_.get();
    return desc;
}

void Stages::add_field(std::vector<Stage>& stages, const char* name, const hrbfnpr_field_desc& desc) {
    add(stages, name, [this, desc](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        hrbfnpr_field* field = nullptr;
        auto status =
            attempt([&] { return hrbfnpr_field_create(context_.get(), &desc, attempt.operation, &field, error); });
        EXPECT_EQ(field != nullptr, status == HRBFNPR_STATUS_OK);
        const Field owned(field);
        if (!owned) return status;
        const std::size_t count = places_.size() / 3;
        const std::uint32_t components = desc.kind == HRBFNPR_FIELD_KIND_SCALAR ? 1 : 3;
        std::vector<double> value(components * count), weight(count);
        const hrbfnpr_array from = in(places_), normals = in(places_); // The places lie on a ball around 0.
        const hrbfnpr_array_out values = out(value, components), weights = out(weight, 1);
        const Operation operation = make_operation(context_);
        EXPECT_EQ(hrbfnpr_field_evaluate(field, &from, &normals, &values, &weights, operation.get(), nullptr),
                  HRBFNPR_STATUS_OK);
        append(bytes, value);
        append(bytes, weight);
        return status;
    });
}

void Stages::add_fields(std::vector<Stage>& stages) {
    add_field(stages, "field.triangles", vertex_field_desc(true));
    add_field(stages, "field.points", vertex_field_desc(false));
    add_field(stages, "field.dabs", dab_field_desc());
    add_field(stages, "field.image", image_field_desc());
    hrbfnpr_field* made_field = nullptr;
    auto desc = vertex_field_desc(true);
    EXPECT_EQ(hrbfnpr_field_create(context_.get(), &desc, nullptr, &made_field, nullptr), HRBFNPR_STATUS_OK);
    ways_.reset(made_field);
    desc = made(hrbfnpr_field_desc_init);
    desc.source = HRBFNPR_FIELD_SOURCE_FUNCTION;
    desc.function = waves;
    EXPECT_EQ(hrbfnpr_field_create(context_.get(), &desc, nullptr, &made_field, nullptr), HRBFNPR_STATUS_OK);
    waves_.reset(made_field);
    add(stages, "field.evaluate", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        std::vector<double> value(places_.size()), weight(places_.size() / 3);
        const hrbfnpr_array from = in(places_);
        const hrbfnpr_array_out values = out(value), weights = out(weight, 1);
        const auto status = attempt([&] {
            return hrbfnpr_field_evaluate(ways_.get(), &from, nullptr, &values, &weights, attempt.operation, error);
        });
        if (status == HRBFNPR_STATUS_OK) append(bytes, value), append(bytes, weight);
        return status;
    });
    add(stages, "field.marks", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        std::array<hrbfnpr_mark_field, 2> fields{made(hrbfnpr_mark_field_init), made(hrbfnpr_mark_field_init)};
        fields[0].name = "ways";
        fields[0].field = ways_.get();
        fields[1].name = "waves";
        fields[1].field = waves_.get();
        hrbfnpr_point_set* set = nullptr;
        const auto status = attempt([&] {
            return hrbfnpr_point_set_with_fields(context_.get(), set_.get(), fields.data(), 2, 0, attempt.operation,
                                                 &set, error);
        });
        EXPECT_EQ(set != nullptr, status == HRBFNPR_STATUS_OK);
        const PointSet owned(set);
        if (!owned) return status;
        append(bytes, owned);
        for (const hrbfnpr_mark_field& field : fields) append_values(bytes, owned, field.name);
        return status;
    });
}

} // namespace api_test
