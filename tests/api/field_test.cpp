// SPDX-License-Identifier: MIT
// Fields, and their values in point sets, by the C interface.
#include "fixture.h"
#include "support/meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace api_test::field_test {
namespace {

using hrbfnpr::test::Field;

using Function = std::function<std::int32_t(std::int64_t, const double*, const double*, double*, double*)>;

std::int32_t call_function(void* user, std::int64_t count, const double* positions, const double* normals,
                           double* values, double* weights) {
    return (*static_cast<Function*>(user))(count, positions, normals, values, weights);
}

// A unit ball with stipples and hatching.
class Fields : public testing::Test {
protected:
    Fields() : model(custom_sphere(context, sphere)) {
        Generation desc;
        desc.add(HRBFNPR_LAYER_KIND_STIPPLES, 3000);
        desc.add(HRBFNPR_LAYER_KIND_HATCH, 2000);
        set = generate(context, model, desc);
    }

    hrbfnpr_status create(const hrbfnpr_field_desc& desc, Field& field) {
        hrbfnpr_field* made_field = nullptr;
        const hrbfnpr_status status = hrbfnpr_field_create(context.get(), &desc, nullptr, &made_field, error);
        EXPECT_EQ(made_field != nullptr, status == HRBFNPR_STATUS_OK);
        field.reset(made_field);
        return status;
    }
    Field field_of(const hrbfnpr_field_desc& desc) {
        Field field;
        EXPECT_OK(create(desc, field));
        return field;
    }
    Field function_field(std::uint32_t kind, Function& function) {
        auto desc = made(hrbfnpr_field_desc_init);
        desc.kind = kind;
        desc.source = HRBFNPR_FIELD_SOURCE_FUNCTION;
        desc.function = call_function;
        desc.user = &function;
        return field_of(desc);
    }
    // A scalar field that is the same everywhere.
    Field constant(double value) {
        auto desc = made(hrbfnpr_field_desc_init);
        const std::vector<double> point{0.0, 0.0, 0.0}, values{value};
        desc.points = in(point);
        desc.values = in(values, 1);
        return field_of(desc);
    }
    hrbfnpr_status with_fields(const PointSet& base, std::vector<hrbfnpr_mark_field> fields, PointSet& to) {
        hrbfnpr_point_set* made_set = nullptr;
        const hrbfnpr_status status =
            hrbfnpr_point_set_with_fields(context.get(), base.get(), fields.data(),
                                          static_cast<std::int64_t>(fields.size()), 0, nullptr, &made_set, error);
        EXPECT_EQ(made_set != nullptr, status == HRBFNPR_STATUS_OK);
        to.reset(made_set);
        return status;
    }
    PointSet with_field(const PointSet& base, const char* name, const Field& field) {
        PointSet to;
        EXPECT_OK(with_fields(base, {named(name, field)}, to));
        return to;
    }
    static hrbfnpr_mark_field named(const char* name, const Field& field) {
        auto named_field = made(hrbfnpr_mark_field_init);
        named_field.name = name;
        named_field.field = field.get();
        return named_field;
    }
    std::vector<float> values_of(const PointSet& of, std::int64_t layer, const char* name,
                                 std::vector<float>* weights = nullptr) {
        hrbfnpr_array values{}, its_weights{};
        EXPECT_OK(hrbfnpr_point_set_view_field(of.get(), layer, name, &values, &its_weights, error));
        if (weights != nullptr) *weights = elements<float>(its_weights);
        return elements<float>(values);
    }
    static std::vector<float> places(const PointSet& of, std::int64_t layer) {
        const hrbfnpr_point_set_info info = info_of(of);
        std::vector<float> all = attribute<float>(of, layer, HRBFNPR_MARK_ATTRIBUTE_POSITION);
        for (std::size_t i = 0; i < all.size(); ++i) all[i] += static_cast<float>(info.origin[i % 3]);
        return all;
    }

    Error error;
    Context context = make_context();
    Sphere sphere;
    Model model;
    PointSet set;
};

TEST_F(Fields, OfAMeshReachTheMarks) {
    const hrbfnpr::test::Triangles ball = hrbfnpr::test::icosphere(4);
    auto desc = made(hrbfnpr_field_desc_init);
    desc.kind = HRBFNPR_FIELD_KIND_COLOUR;
    desc.points = in(ball.vertices);
    desc.triangles = in(ball.triangles);
    std::vector<std::uint8_t> colours;
    for (const double c : ball.vertices) colours.push_back(static_cast<std::uint8_t>(127.5 + 127.5 * c));
    desc.values = in(colours);
    const PointSet coloured = with_field(set, "rgb", field_of(desc));
    EXPECT_EQ(info_of(set).field_count, 0);
    ASSERT_EQ(info_of(coloured).field_count, 1);
    const char* name = nullptr;
    std::uint32_t kind = 99;
    EXPECT_OK(hrbfnpr_point_set_get_field(coloured.get(), 0, &name, &kind, error));
    EXPECT_STREQ(name, "rgb");
    EXPECT_EQ(kind, HRBFNPR_FIELD_KIND_COLOUR);
    for (std::int64_t layer = 0; layer < 2; ++layer) {
        std::vector<float> weights;
        const std::vector<float> values = values_of(coloured, layer, "rgb", &weights);
        const std::vector<float> at = places(coloured, layer);
        ASSERT_EQ(values.size(), at.size());
        EXPECT_TRUE(weights.empty()) << "all are 1";
        for (std::size_t i = 0; i < at.size(); ++i) ASSERT_NEAR(values[i], 0.5F + 0.5F * at[i], 0.01F);
    }
}

TEST_F(Fields, ShareTheMarksOfTheSet) {
    const std::vector<std::uint8_t> whole = saved(set);
    PointSet other = with_field(set, "a", constant(1.0));
    hrbfnpr_array before{}, after{};
    EXPECT_OK(hrbfnpr_point_set_view(set.get(), 0, HRBFNPR_MARK_ATTRIBUTE_POSITION, &before, error));
    EXPECT_OK(hrbfnpr_point_set_view(other.get(), 0, HRBFNPR_MARK_ATTRIBUTE_POSITION, &after, error));
    EXPECT_EQ(before.data, after.data);
    const auto pixels = draw(make_renderer(context), set);
    set.reset(); // the marks stay as long as a set has them
    EXPECT_EQ(draw(make_renderer(context), other), pixels);
    other = with_field(other, "a", constant(2.0));
    EXPECT_EQ(values_of(other, 0, "a")[0], 2.0F);
    other = [&] {
        PointSet without;
        EXPECT_OK(with_fields(other, {named("a", nullptr)}, without));
        return without;
    }();
    EXPECT_EQ(info_of(other).field_count, 0);
    EXPECT_EQ(saved(other), whole);
}

TEST_F(Fields, AreReplacedByName) {
    PointSet two;
    EXPECT_OK(with_fields(set, {named("a", constant(1.0)), named("b", constant(2.0))}, two));
    PointSet changed;
    EXPECT_OK(with_fields(two, {named("b", constant(3.0)), named("c", constant(4.0))}, changed));
    EXPECT_EQ(info_of(changed).field_count, 3);
    EXPECT_EQ(values_of(changed, 1, "a")[5], 1.0F);
    EXPECT_EQ(values_of(changed, 1, "b")[5], 3.0F);
    EXPECT_EQ(values_of(changed, 1, "c")[5], 4.0F);
    EXPECT_EQ(values_of(two, 1, "b")[5], 2.0F) << "sets never change";
    EXPECT_FAILS(with_fields(set, {named("a", constant(1.0)), named("a", constant(2.0))}, changed),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "fields[1].name is \"a\"");
    std::vector<std::string> names;
    for (int i = 0; i < 64; ++i) names.push_back("field " + std::to_string(i));
    std::vector<hrbfnpr_mark_field> many;
    const Field one = constant(1.0);
    for (const std::string& name : names) many.push_back(named(name.c_str(), one));
    PointSet full;
    EXPECT_OK(with_fields(set, many, full));
    EXPECT_EQ(info_of(full).field_count, 64);
    EXPECT_FAILS(with_fields(full, {named("one more", one)}, changed), HRBFNPR_STATUS_INVALID_ARGUMENT, "65 fields");
}

TEST_F(Fields, AreSavedWithTheSet) {
    Function function = [](std::int64_t count, const double* positions, const double*, double* values,
                           double* weights) {
        for (std::int64_t i = 0; i < count; ++i) {
            for (int c = 0; c < 3; ++c) values[3 * i + c] = positions[3 * i + c] * positions[3 * i];
            weights[i] = std::abs(positions[3 * i + 1]);
        }
        return 0;
    };
    PointSet base;
    EXPECT_OK(with_fields(
        set, {named("tone", constant(0.25)), named("way", function_field(HRBFNPR_FIELD_KIND_DIRECTION, function))},
        base));
    const std::vector<std::uint8_t> bytes = saved(base);
    EXPECT_EQ(saved(set)[12], 3) << "the format version of sets without fields";
    EXPECT_EQ(bytes[12], 4);
    hrbfnpr_point_set* loaded = nullptr;
    ASSERT_OK(hrbfnpr_point_set_load_memory(context.get(), bytes.data(), static_cast<std::int64_t>(bytes.size()),
                                            &loaded, error));
    const PointSet copy(loaded);
    EXPECT_EQ(saved(copy), bytes);
    EXPECT_EQ(info_of(copy).field_count, 2);
    for (std::int64_t layer = 0; layer < 2; ++layer) {
        std::vector<float> weights, own_weights;
        EXPECT_EQ(values_of(copy, layer, "tone"), values_of(base, layer, "tone"));
        EXPECT_EQ(values_of(copy, layer, "way", &weights), values_of(base, layer, "way", &own_weights));
        EXPECT_EQ(weights, own_weights);
        EXPECT_FALSE(weights.empty());
    }
}

TEST_F(Fields, OfOldLayersStayWhenLayersAreAdded) {
    const PointSet base = with_field(set, "a", constant(0.5));
    const std::vector<double> position{2.0, 0.0, 0.0, 0.0, 2.0, 0.0};
    auto arrays = made(hrbfnpr_layer_arrays_init);
    arrays.position = arrays.normal = in(position);
    auto desc = made(hrbfnpr_point_set_desc_init);
    desc.base = base.get();
    desc.layers = &arrays;
    desc.layer_count = 1;
    hrbfnpr_point_set* made_set = nullptr;
    ASSERT_OK(hrbfnpr_point_set_create(context.get(), &desc, &made_set, error));
    const PointSet more(made_set);
    EXPECT_EQ(info_of(more).field_count, 1);
    EXPECT_EQ(values_of(more, 0, "a"), values_of(base, 0, "a"));
    EXPECT_TRUE(values_of(more, 2, "a").empty());
    const std::vector<std::uint8_t> bytes = saved(more);
    hrbfnpr_point_set* loaded = nullptr;
    ASSERT_OK(hrbfnpr_point_set_load_memory(context.get(), bytes.data(), static_cast<std::int64_t>(bytes.size()),
                                            &loaded, error));
    EXPECT_EQ(saved(PointSet(loaded)), bytes);
}

// The field lies elsewhere, is twice as large and turned by a quarter about z.
TEST_F(Fields, AreFoundThroughATransform) {
    Function function = [](std::int64_t count, const double* positions, const double* normals, double* values,
                           double*) {
        for (std::int64_t i = 0; i < count; ++i) {
            const double* const p = positions + 3 * i;
            const double* const n = normals + 3 * i;
            double away = 0.0;
            for (int c = 0; c < 3; ++c) away += std::abs(p[c] - (c == 0 ? 5.0 : 0.0) - 2.0 * n[c]);
            EXPECT_LT(away, 1e-4);
            values[3 * i] = p[0] - 5.0; // from the middle outward
            values[3 * i + 1] = p[1];
            values[3 * i + 2] = p[2];
        }
        return 0;
    };
    const Field field = function_field(HRBFNPR_FIELD_KIND_DIRECTION, function);
    hrbfnpr_mark_field moved = named("outward", field);
    const double transform[16] = {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 5, 0, 0, 1};
    moved.transform = transform;
    PointSet to;
    ASSERT_OK(with_fields(set, {moved}, to));
    const std::vector<float> values = values_of(to, 0, "outward");
    const std::vector<float> at = places(to, 0);
    for (std::size_t i = 0; i < at.size(); ++i) ASSERT_NEAR(values[i], at[i], 1e-5F) << i;
    const double singular[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    moved.transform = singular;
    EXPECT_FAILS(with_fields(set, {moved}, to), HRBFNPR_STATUS_INVALID_ARGUMENT, "fields[0].transform is singular");
}

TEST_F(Fields, ReportFunctionsThatFail) {
    PointSet to;
    Function function = [](auto, auto, auto, auto, auto) { return 7; };
    const Field field = function_field(HRBFNPR_FIELD_KIND_SCALAR, function);
    EXPECT_FAILS(with_fields(set, {named("a", field)}, to), HRBFNPR_STATUS_CALLBACK, "returned 7");
    function = [](std::int64_t, auto, auto, double* values, auto) {
        values[0] = std::nan("");
        return 0;
    };
    EXPECT_FAILS(with_fields(set, {named("a", field)}, to), HRBFNPR_STATUS_CALLBACK, "not finite");
    function = [](std::int64_t, auto, auto, auto, double* weights) {
        weights[0] = 1.5;
        return 0;
    };
    EXPECT_FAILS(with_fields(set, {named("a", field)}, to), HRBFNPR_STATUS_CALLBACK, "weight 1.5");
    function = [](std::int64_t count, auto, auto, double* values, double* weights) {
        for (std::int64_t i = 0; i < count; ++i) {
            weights[i] = 0.0;
            values[i] = std::nan("");
        }
        return 0;
    };
    EXPECT_OK(with_fields(set, {named("a", field)}, to));
    EXPECT_EQ(values_of(to, 0, "a")[0], 0.0F);
}

TEST_F(Fields, OfAnImageFallOnWhatTheCameraSees) {
    const hrbfnpr_camera camera = front_camera(128);
    constexpr std::int32_t size = 64;
    std::vector<float> pixels;
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column)
            for (const double c : {(column + 0.5) / size, (row + 0.5) / size, 0.0, 1.0})
                pixels.push_back(static_cast<float>(c));
    auto image = made(hrbfnpr_image_init);
    image.format = HRBFNPR_FORMAT_RGBA32F;
    image.width = image.height = size;
    image.pixels = pixels.data();
    auto desc = made(hrbfnpr_field_desc_init);
    desc.kind = HRBFNPR_FIELD_KIND_COLOUR;
    desc.source = HRBFNPR_FIELD_SOURCE_IMAGE;
    desc.image = &image;
    desc.camera = &camera;
    const Field field = field_of(desc);
    pixels.clear(); // it was copied
    const PointSet to = with_field(set, "photo", field);
    std::vector<float> weights;
    const std::vector<float> values = values_of(to, 0, "photo", &weights);
    const std::vector<float> at = places(to, 0);
    const auto product = [](const double* m, const std::array<double, 4>& v) {
        std::array<double, 4> result{};
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t column = 0; column < 4; ++column) result[row] += m[4 * column + row] * v[column];
        return result;
    };
    int seen = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const std::array<double, 4> eye = product(camera.view, {at[3 * i], at[3 * i + 1], at[3 * i + 2], 1.0});
        const std::array<double, 4> centre = product(camera.view, {0.0, 0.0, 0.0, 1.0});
        double facing = 0.0;
        for (std::size_t c = 0; c < 3; ++c) facing -= (eye[c] - centre[c]) * eye[c];
        if (std::abs(facing) < 1e-3) continue;
        ASSERT_EQ(weights[i], facing > 0.0 ? 1.0F : 0.0F) << i;
        if (facing < 0.0) continue;
        const std::array<double, 4> clip = product(camera.projection, eye);
        ASSERT_NEAR(values[3 * i], 0.5 + 0.5 * clip[0] / clip[3], 1e-5);
        ASSERT_NEAR(values[3 * i + 1], 0.5 - 0.5 * clip[1] / clip[3], 1e-5);
        ++seen;
    }
    EXPECT_GT(seen, 1000);
}

TEST_F(Fields, OfAnImageDoNotReachWhatOccludersHide) {
    auto line_desc = made(hrbfnpr_line_set_desc_init);
    hrbfnpr_line_set* raw_lines = nullptr;
    ASSERT_OK(hrbfnpr_line_set_create(context.get(), model.get(), &line_desc, nullptr, &raw_lines, error));
    const hrbfnpr::test::LineSet lines(raw_lines);
    std::array<hrbfnpr_item, 2> items{item_of(set), item_of(set)};
    items[0].line_set = items[1].line_set = lines.get();
    items[1].transform[14] = 2.5; // nearer to the eye
    hrbfnpr_occluders* raw_occluders = nullptr;
    ASSERT_OK(hrbfnpr_occluders_create(context.get(), items.data(), 2, 0, nullptr, &raw_occluders, error));
    hrbfnpr::test::Occluders occluders(raw_occluders);
    auto camera = made(hrbfnpr_camera_init);
    const double eye[3] = {0.0, 0.0, 10.0}, target[3] = {0.0, 0.0, 0.0}, up[3] = {0.0, 1.0, 0.0};
    ASSERT_OK(hrbfnpr_camera_look_at(&camera, eye, target, up, error));
    ASSERT_OK(hrbfnpr_camera_orthographic(&camera, 3.0, 32, 32, 0.1, 100.0, error));
    std::vector<std::uint8_t> pixels;
    const hrbfnpr_image image = image_of(pixels, 8);
    std::fill(pixels.begin(), pixels.end(), std::uint8_t{255});
    auto desc = made(hrbfnpr_field_desc_init);
    desc.source = HRBFNPR_FIELD_SOURCE_IMAGE;
    desc.image = &image;
    desc.camera = &camera;
    desc.occluders = occluders.get();
    const Field hidden = field_of(desc);
    desc.occluders = nullptr;
    const Field seen = field_of(desc);
    occluders.reset(); // the field keeps them
    std::vector<float> weights;
    values_of(with_field(set, "a", seen), 0, "a", &weights);
    EXPECT_GT(std::count(weights.begin(), weights.end(), 1.0F), 1000);
    values_of(with_field(set, "a", hidden), 0, "a", &weights);
    const std::vector<float> at = places(set, 0);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (std::hypot(at[3 * i], at[3 * i + 1]) > 0.9F) continue; // rays begin above the surface, and may pass by
        ASSERT_EQ(weights[i], 0.0F) << "the nearer ball hides all of it";
    }
    hrbfnpr_mark_field nearer = named("a", hidden);
    nearer.transform = items[1].transform;
    PointSet to;
    ASSERT_OK(with_fields(set, {nearer}, to));
    const std::vector<float> values = values_of(to, 0, "a", &weights);
    EXPECT_GT(std::count(weights.begin(), weights.end(), 1.0F), 1000);
    EXPECT_NEAR(*std::max_element(values.begin(), values.end()), 1.0F, 1e-6F) << "the luminance of white";
}

TEST_F(Fields, SetTheDensityOfStipples) {
    Function function = [](std::int64_t count, const double* positions, const double*, double* values, double*) {
        for (std::int64_t i = 0; i < count; ++i) values[i] = positions[3 * i] < 0.0 ? 0.0 : 7.0;
        return 0;
    };
    const Field field = function_field(HRBFNPR_FIELD_KIND_SCALAR, function);
    Generation desc;
    desc.add(HRBFNPR_LAYER_KIND_STIPPLES, 2000);
    desc.layer[0].density = HRBFNPR_DENSITY_FIELD;
    desc.layer[0].density_field = field.get();
    const std::vector<float> at = places(generate(context, model, desc), 0);
    EXPECT_GT(at.size(), 3000U);
    for (std::size_t i = 0; i < at.size(); i += 3) ASSERT_GE(at[i], -1e-6F);
    desc.layer[0].density_field = nullptr;
    hrbfnpr_point_set* none = nullptr;
    EXPECT_FAILS(hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), nullptr, &none, error),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "layers[0].density_field is NULL");
}

TEST_F(Fields, SetTheDirectionsOfHatching) {
    auto field_desc = made(hrbfnpr_field_desc_init);
    field_desc.kind = HRBFNPR_FIELD_KIND_DIRECTION;
    const std::vector<double> point{0.0, 0.0, 0.0}, upward{0.0, 0.0, -3.0};
    field_desc.points = in(point);
    field_desc.values = in(upward);
    const Field field = field_of(field_desc);
    Generation desc;
    desc.add(HRBFNPR_LAYER_KIND_HATCH, 2000);
    desc.layer[0].direction_field = field.get();
    const PointSet hatched = generate(context, model, desc);
    const std::vector<float> along = attribute<float>(hatched, 0, HRBFNPR_MARK_ATTRIBUTE_DIRECTION);
    const std::vector<float> at = places(hatched, 0);
    int count = 0;
    for (std::size_t i = 0; i < at.size(); i += 3) {
        if (std::abs(at[i + 2]) > 0.5F) continue; // the directions turn fast near the poles
        ++count;
        ASSERT_GT(std::abs(along[i + 2]), 0.95F * std::sqrt(1.0F - at[i + 2] * at[i + 2])) << i;
    }
    EXPECT_GT(count, 500);
    hrbfnpr_point_set* none = nullptr;
    desc.layer[0].direction_function = [](void*, std::int64_t, const double*, const double*, double*) { return 0; };
    EXPECT_FAILS(hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), nullptr, &none, error),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "direction_field and a direction_function");
    desc.layer[0].direction_function = nullptr;
    const Field scalar = constant(1.0);
    desc.layer[0].direction_field = scalar.get();
    EXPECT_FAILS(hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), nullptr, &none, error),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "direction_field is a field of kind SCALAR");
}

TEST_F(Fields, AreAtMost64) {
    const Field field = constant(1.0);
    std::vector<std::string> names;
    std::vector<hrbfnpr_mark_field> fields;
    for (int i = 0; i < 65; ++i) names.push_back("f" + std::to_string(i));
    for (const std::string& name : names) fields.push_back(named(name.c_str(), field));
    const std::vector<hrbfnpr_mark_field> first(fields.begin(), fields.begin() + 40),
        rest(fields.begin() + 39, fields.end());
    PointSet some, more;
    ASSERT_OK(with_fields(set, first, some));
    EXPECT_FAILS(with_fields(some, rest, more), HRBFNPR_STATUS_INVALID_ARGUMENT, "the set would have 65 fields");
    // One is replaced, and one is removed.
    fields[0].field = nullptr;
    std::vector<hrbfnpr_mark_field> changes(rest);
    changes.push_back(fields[0]);
    ASSERT_OK(with_fields(some, changes, more));
    EXPECT_EQ(info_of(more).field_count, 64);
}

TEST_F(Fields, RefuseWrongInput) {
    Field field;
    auto desc = made(hrbfnpr_field_desc_init);
    EXPECT_FAILS(create(desc, field), HRBFNPR_STATUS_INVALID_ARGUMENT, "field_desc.points is empty");
    const std::vector<double> points{0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0}, values{1.0, 2.0};
    const std::vector<std::int32_t> triangles{0, 1, 3};
    desc.points = in(points);
    desc.values = in(values, 1);
    EXPECT_FAILS(create(desc, field), HRBFNPR_STATUS_INVALID_ARGUMENT, "values has 2 elements, but there are 3 points");
    const std::vector<double> enough{1.0, 2.0, 3.0};
    desc.values = in(enough, 1);
    desc.triangles = in(triangles);
    EXPECT_FAILS(create(desc, field), HRBFNPR_STATUS_INVALID_ARGUMENT, "triangles[0] has the point 3");
    desc.triangles = {};
    desc.range[0] = desc.range[1] = 2.0;
    EXPECT_FAILS(create(desc, field), HRBFNPR_STATUS_INVALID_ARGUMENT, "field_desc.range");
    desc.range[1] = 3.0;
    ASSERT_OK(create(desc, field));
    std::vector<double> results(3);
    const hrbfnpr_array at = in(points);
    const hrbfnpr_array_out to = out(results, 1);
    EXPECT_OK(hrbfnpr_field_evaluate(field.get(), &at, nullptr, &to, nullptr, nullptr, error));
    EXPECT_EQ(results, (std::vector<double>{0.0, 0.0, 1.0}));
    auto dabs = made(hrbfnpr_field_desc_init);
    dabs.source = HRBFNPR_FIELD_SOURCE_DABS;
    ASSERT_OK(create(dabs, field));
    EXPECT_FAILS(hrbfnpr_field_evaluate(field.get(), &at, nullptr, &to, nullptr, nullptr, error),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "normals are not given");
    auto function = made(hrbfnpr_field_desc_init);
    function.source = HRBFNPR_FIELD_SOURCE_FUNCTION;
    EXPECT_FAILS(create(function, field), HRBFNPR_STATUS_INVALID_ARGUMENT, "field_desc.function is NULL");
}

TEST_F(Fields, KeepTheShadingOfTheSet) {
    auto line_desc = made(hrbfnpr_line_set_desc_init);
    hrbfnpr_line_set* raw_lines = nullptr;
    ASSERT_OK(hrbfnpr_line_set_create(context.get(), model.get(), &line_desc, nullptr, &raw_lines, error));
    const hrbfnpr::test::LineSet lines(raw_lines);
    auto style = made(hrbfnpr_style_init);
    style.ambient_sky = 0.5F;
    hrbfnpr_item item = item_of(set, &style);
    item.line_set = lines.get();
    hrbfnpr_occluders* raw_occluders = nullptr;
    ASSERT_OK(hrbfnpr_occluders_create(context.get(), &item, 1, 0, nullptr, &raw_occluders, error));
    const hrbfnpr::test::Occluders occluders(raw_occluders);
    hrbfnpr_shading* raw_shading = nullptr;
    ASSERT_OK(
        hrbfnpr_shading_create(context.get(), occluders.get(), &item, nullptr, nullptr, nullptr, &raw_shading, error));
    const hrbfnpr::test::Shading shading(raw_shading);
    item.shading = shading.get();
    const PointSet other = with_field(set, "a", constant(1.0));
    const auto pixels = rasterize(draw_item(make_renderer(context), item, front_camera()), 64);
    item.point_set = other.get();
    EXPECT_EQ(rasterize(draw_item(make_renderer(context), item, front_camera()), 64), pixels);
}

} // namespace
} // namespace api_test::field_test
