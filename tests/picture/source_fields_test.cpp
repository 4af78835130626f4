// SPDX-License-Identifier: MIT
#include "picture/source_fields.h"

#include "picture/make.h"
#include "planned_call.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

namespace picture_tests::source_fields_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// A square of two triangles, from (0, 0) to (2, 2), with values at its corners.
class SourceFieldsTest : public testing::Test {
protected:
    PlannedCall given;
    Call call = given.call();
    std::vector<double> quality{1.0, 3.0, 5.0, not_a_number};
    std::vector<std::uint8_t> colour{255, 0, 0, 0, 255, 0, 0, 0, 255, 51, 102, 153};

    [[nodiscard]] Shape square() {
        Shape shape(call.pool);
        for (const glm::dvec3& corner :
             {glm::dvec3(0, 0, 0), glm::dvec3(2, 0, 0), glm::dvec3(2, 2, 0), glm::dvec3(0, 2, 0)})
            shape.points.push_back(corner);
        shape.triangles.push_back({0, 1, 2});
        shape.triangles.push_back({0, 2, 3});
        return shape;
    }
    [[nodiscard]] std::vector<hrbfnpr_source_field> two_fields() const {
        std::vector<hrbfnpr_source_field> fields(2, defaults<hrbfnpr_source_field>(hrbfnpr_source_field_init));
        fields[0].name = "Quality";
        fields[0].values = {quality.data(), 4, 0, HRBFNPR_SCALAR_FLOAT64, 1};
        fields[1].name = "rgb";
        fields[1].kind = HRBFNPR_FIELD_KIND_COLOUR;
        fields[1].values = {colour.data(), 4, 0, HRBFNPR_SCALAR_UINT8, 3};
        return fields;
    }
    [[nodiscard]] SourceValues read(const std::vector<hrbfnpr_source_field>& fields) {
        auto source = defaults<hrbfnpr_picture_source>(hrbfnpr_picture_source_init);
        source.fields = fields.data();
        source.field_count = static_cast<std::int64_t>(fields.size());
        return read_source_values(source, square(), "picture_source", call.pool);
    }
    template <class F>
    [[nodiscard]] static std::string message_of(F&& f) {
        try {
            f();
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }
    // Returns the value of a field at a place of the square, or NaN where it has none.
    [[nodiscard]] static double value_at(const Field& field, const glm::dvec3& place) {
        const glm::dvec3 up(0.0, 0.0, 1.0);
        double value = 0.0, weight = 0.0;
        const hrbfnpr_array at{&place.x, 1, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        const hrbfnpr_array facing{&up.x, 1, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        const hrbfnpr_array_out to{&value, 1, 0, HRBFNPR_SCALAR_FLOAT64, 1};
        const hrbfnpr_array_out weights{&weight, 1, 0, HRBFNPR_SCALAR_FLOAT64, 1};
        picture::call([&](hrbfnpr_error* error) {
            return hrbfnpr_field_evaluate(field.get(), &at, &facing, &to, &weights, nullptr, error);
        });
        return weight > 0.0 ? value : not_a_number;
    }
};

TEST_F(SourceFieldsTest, NamesAreTakenApart) {
    const auto same = [](const char* text, const char* name, bool is_reversed, double low, double high) {
        const FieldSpec spec = field_spec_of(text);
        EXPECT_EQ(spec.name, name) << text;
        EXPECT_EQ(spec.is_reversed, is_reversed) << text;
        EXPECT_EQ(spec.range.has_value(), low != high) << text;
        EXPECT_EQ(spec.range.value_or(std::array{0.0, 0.0}),
                  low != high ? (std::array{low, high}) : (std::array{0.0, 0.0}));
    };
    same("quality", "quality", false, 0, 0);
    same("-quality", "quality", true, 0, 0);
    same("quality:0.25..0.75", "quality", false, 0.25, 0.75);
    same("-a:b:5..-1e3", "a:b", true, 5, -1000);
    same("quality:1..1", "quality:1..1", false, 0, 0);
    same("quality:low..high", "quality:low..high", false, 0, 0);
    same("-", "-", false, 0, 0);
    same(":0..1", ":0..1", false, 0, 0);
}

TEST_F(SourceFieldsTest, WrongFieldsAreNamed) {
    auto fields = two_fields();
    fields[1].name = nullptr;
    EXPECT_EQ(message_of([&] { static_cast<void>(read(fields)); }), "picture_source.fields[1].name is NULL");
    fields[1].name = "Quality";
    EXPECT_NE(message_of([&] { static_cast<void>(read(fields)); }).find("as that of another field"), std::string::npos);
    fields = two_fields();
    fields[0].values.count = 3;
    EXPECT_NE(message_of([&] { static_cast<void>(read(fields)); }).find("fields[0].values has 3 elements"),
              std::string::npos);
    fields = two_fields();
    fields[0].kind = 3;
    EXPECT_NE(message_of([&] { static_cast<void>(read(fields)); }).find("fields[0].kind is 3"), std::string::npos);
}

TEST_F(SourceFieldsTest, TextsFindValues) {
    SourceFields sources(call.pool);
    sources.add(read(two_fields()));
    EXPECT_FALSE(sources.empty());
    const WantedField usual = sources.find(call, "quality", FieldUse::number);
    EXPECT_EQ(usual.name, "Quality");
    EXPECT_EQ(usual.range, (std::array{1.0, 5.0}));
    EXPECT_EQ(usual.key, "quality");
    EXPECT_EQ(sources.find(call, "-Quality", FieldUse::number).range, (std::array{5.0, 1.0}));
    EXPECT_EQ(sources.find(call, "-Quality:0..2", FieldUse::number).range, (std::array{2.0, 0.0}));
    EXPECT_EQ(sources.find(call, "colour", FieldUse::colour).name, "rgb");
    const WantedField light = sources.find(call, "rgb", FieldUse::number);
    EXPECT_TRUE(light.is_luminance);
    EXPECT_EQ(light.key, "luminance of rgb");
    EXPECT_EQ(light.range, (std::array{0.0, 0.0}));
    EXPECT_EQ(sources.find(call, "-rgb", FieldUse::number).range, (std::array{1.0, 0.0}));
}

TEST_F(SourceFieldsTest, OutliersAreOutsideOfTheRange) {
    const auto range_of = [this](const std::vector<double>& numbers) {
        Shape shape(call.pool);
        for (std::size_t i = 0; i < numbers.size(); ++i) shape.points.push_back({static_cast<double>(i), 0.0, 0.0});
        auto field = defaults<hrbfnpr_source_field>(hrbfnpr_source_field_init);
        field.name = "intensity";
        field.values = {numbers.data(), static_cast<std::int64_t>(numbers.size()), 0, HRBFNPR_SCALAR_FLOAT64, 1};
        auto source = defaults<hrbfnpr_picture_source>(hrbfnpr_picture_source_init);
        source.fields = &field;
        source.field_count = 1;
        SourceFields sources(call.pool);
        sources.add(read_source_values(source, shape, "picture_source", call.pool));
        return sources.find(call, "intensity", FieldUse::number).range;
    };
    std::vector<double> even(101);
    for (std::size_t i = 0; i < even.size(); ++i) even[i] = static_cast<double>(i);
    EXPECT_EQ(range_of(even), (std::array{0.0, 100.0}));
    std::vector<double> mirrored = even;
    mirrored.insert(mirrored.end(), {-9000.0, 65535.0, 65535.0, not_a_number});
    EXPECT_EQ(range_of(mirrored), (std::array{0.0, 100.0}));
    std::vector<double> rare(1000, 2.0); // A mask has few values of its own.
    rare[500] = 3.0;
    EXPECT_EQ(range_of(rare), (std::array{2.0, 3.0}));
    EXPECT_EQ(range_of(std::vector<double>(10, 2.0)), (std::array{0.0, 0.0}));
}

TEST_F(SourceFieldsTest, TextsThatFindNothingAreRefused) {
    SourceFields sources(call.pool);
    const auto refusal = [&](const char* text, FieldUse use) {
        return message_of([&] { static_cast<void>(sources.find(call, text, use)); });
    };
    EXPECT_EQ(refusal("quality", FieldUse::number),
              "--field names quality, but the source has no values at its points");
    sources.add(read(two_fields()));
    EXPECT_EQ(refusal("qualty", FieldUse::number),
              "--field names qualty, which the source does not have; it has Quality, rgb");
    EXPECT_EQ(refusal("quality", FieldUse::colour),
              "--field names quality, which holds numbers; this use needs colours");
    EXPECT_EQ(refusal("rgb", FieldUse::direction), "--field names rgb, which holds colours; this use needs directions");
    EXPECT_EQ(refusal("rgb:0..1", FieldUse::colour), "--field gives rgb a range, but it does not hold numbers");
}

TEST_F(SourceFieldsTest, FieldsInterpolateBetweenCorners) {
    SourceFields sources(call.pool);
    sources.add(read(two_fields()));
    sources.add(SourceValues(call.pool));
    const WantedField wanted = sources.find(call, "quality", FieldUse::number);
    const Field field = sources.make_field(call, wanted, 0);
    // At (1.5, 0.5) the triangle 0, 1, 2 has the weights 1/4, 1/2, 1/4.
    EXPECT_NEAR(value_at(field, {1.5, 0.5, 0.1}), ((1.0 + 2.0 * 3.0 + 5.0) / 4.0 - 1.0) / 4.0, 1e-6);
    // The corner at (0, 2) has no number, so the nearest place of the other triangle counts, which is (1, 1).
    EXPECT_NEAR(value_at(field, {0.0, 2.0, 0.0}), (3.0 - 1.0) / 4.0, 1e-6);
    EXPECT_EQ(sources.make_field(call, wanted, 0).get(), field.get()); // It is made once.
    EXPECT_FALSE(sources.make_field(call, wanted, 1));                 // The second source has no values.
    const Field light = sources.make_field(call, sources.find(call, "rgb", FieldUse::number), 0);
    EXPECT_NEAR(value_at(light, {2.0, 0.0, 0.0}), 0.7152, 1e-6);
    EXPECT_NEAR(value_at(light, {0.0, 2.0, 0.0}), 0.2126 * 0.2 + 0.7152 * 0.4 + 0.0722 * 0.6, 1e-6);
}

TEST_F(SourceFieldsTest, TrianglesWithACornerWithoutAValueAreLeftOut) {
    Shape shape = square();
    shape.points.push_back({4, 0, 0});
    shape.points.push_back({4, 2, 0});
    shape.triangles.push_back({4, 5, 3}); // The corner 3 has no number.
    quality.insert(quality.end(), {3.0, 3.0});
    auto field = defaults<hrbfnpr_source_field>(hrbfnpr_source_field_init);
    field.name = "quality";
    field.values = {quality.data(), 6, 0, HRBFNPR_SCALAR_FLOAT64, 1};
    auto source = defaults<hrbfnpr_picture_source>(hrbfnpr_picture_source_init);
    source.fields = &field;
    source.field_count = 1;
    SourceFields sources(call.pool);
    sources.add(read_source_values(source, shape, "picture_source", call.pool));
    const Field made = sources.make_field(call, sources.find(call, "quality", FieldUse::number), 0);
    // The nearest place of the triangle 0, 1, 2 is (2, 1), with the value 4.
    EXPECT_NEAR(value_at(made, {3.5, 1.0, 0.0}), (4.0 - 1.0) / 4.0, 1e-6);
}

TEST_F(SourceFieldsTest, PointsWithoutAPlaceAreLeftOut) {
    SourceValues values = read(two_fields());
    values.triangles.clear();
    values.points[1].x = not_a_number;
    SourceFields sources(call.pool);
    sources.add(std::move(values));
    const Field field = sources.make_field(call, sources.find(call, "quality:0..5", FieldUse::number), 0);
    EXPECT_NEAR(value_at(field, {0.9, 0.1, 0.0}), 0.2, 1e-6); // the corner at (0, 0), with the value 1 of 5
    EXPECT_NEAR(value_at(field, {2.0, 1.9, 0.0}), 1.0, 1e-6);
}

} // namespace
} // namespace picture_tests::source_fields_test
