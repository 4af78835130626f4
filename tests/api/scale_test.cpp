// SPDX-License-Identifier: MIT
// Tests models of any size: the same marks and pictures at any power of two, and a clear refusal beyond the range of
// floats.
#include "fixture.h"

#include <cmath>
#include <limits>

namespace api_test::scale_test {
namespace {

scenes::Samples scaled(scenes::Samples samples, double by) {
    for (double& coordinate : samples.points) coordinate *= by;
    return samples;
}

Model sphere_of(const Context& context, double radius) { return fit(context, scaled(scenes::sphere_6(), radius)); }

std::vector<float> times(std::vector<float> numbers, double by) {
    for (float& number : numbers) number = static_cast<float>(static_cast<double>(number) * by);
    return numbers;
}

// Divides k1 and k2, which are inverse lengths, by the scale; the confidence stays.
std::vector<float> bent(std::vector<float> curvature, double by) {
    for (std::size_t i = 0; i < curvature.size(); ++i)
        if (i % 3 != 2) curvature[i] = static_cast<float>(static_cast<double>(curvature[i]) / by);
    return curvature;
}

// Expects that all marks of a set are those of `unit`, scaled by `by`.
void expect_times(const PointSet& set, const PointSet& unit, double by) {
    ASSERT_EQ(info_of(set).layers, info_of(unit).layers);
    for (std::int64_t layer = 0; layer < info_of(set).layers; ++layer) {
        const auto of = [&](const PointSet& which, std::uint32_t what) { return attribute<float>(which, layer, what); };
        ASSERT_FALSE(of(unit, HRBFNPR_MARK_ATTRIBUTE_POSITION).empty());
        EXPECT_EQ(of(set, HRBFNPR_MARK_ATTRIBUTE_POSITION), times(of(unit, HRBFNPR_MARK_ATTRIBUTE_POSITION), by));
        EXPECT_EQ(of(set, HRBFNPR_MARK_ATTRIBUTE_CURVATURE), bent(of(unit, HRBFNPR_MARK_ATTRIBUTE_CURVATURE), by));
        for (const std::uint32_t what :
             {HRBFNPR_MARK_ATTRIBUTE_NORMAL, HRBFNPR_MARK_ATTRIBUTE_DIRECTION, HRBFNPR_MARK_ATTRIBUTE_RANK})
            EXPECT_EQ(of(set, what), of(unit, what));
        EXPECT_EQ(layer_info(set, layer).step, by * layer_info(unit, layer).step);
    }
    const hrbfnpr_point_set_info info = info_of(set);
    const hrbfnpr_point_set_info expected = info_of(unit);
    EXPECT_EQ(info.spacing, by * expected.spacing);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(info.origin[axis], by * expected.origin[axis]);
        EXPECT_EQ(info.bounds_min[axis], by * expected.bounds_min[axis]);
    }
}

TEST(Scale, APowerOfTwoScalesTheMarksExactly) {
    const Context context = make_context();
    for (const std::uint32_t distribution : {HRBFNPR_DISTRIBUTION_BLUE_NOISE, HRBFNPR_DISTRIBUTION_PUBLISHED}) {
        Generation desc = small_desc(distribution);
        const PointSet unit = generate(context, sphere_of(context, 1.0), desc);
        for (const int power : {-100, -73, -60, 60, 73, 100}) {
            SCOPED_TRACE(power);
            expect_times(generate(context, sphere_of(context, std::ldexp(1.0, power)), desc), unit,
                         std::ldexp(1.0, power));
        }
    }
}

// Lengths in descriptors are scaled alike, and callbacks get the caller's coordinates.
std::int32_t upper_half(void* user, std::int64_t count, const double* positions, const double* /*normals*/,
                        double* density) {
    for (std::int64_t i = 0; i < count; ++i) {
        EXPECT_NEAR(std::abs(positions[3 * i + 2] / *static_cast<double*>(user)), 0.5, 0.51);
        density[i] = positions[3 * i + 2] > 0.0 ? 1.0 : 0.25;
    }
    return 0;
}

TEST(Scale, LengthsOfTheDescriptorAreInTheSamplesUnit) {
    const Context context = make_context();
    const auto made_at = [&](double scale) {
        const std::vector<double> seeds{scale, 0.0, 0.0, 0.0, 0.0, -scale};
        Generation desc = small_desc();
        desc.seed_source = HRBFNPR_SEED_POINTS;
        desc.seed_points = in(seeds);
        for (const auto layer : {std::size_t{by_curvature}, std::size_t{by_combing}}) {
            desc.layer[layer].separation = 0.3 * scale;
            desc.layer[layer].step = 0.05 * scale;
        }
        desc.layer[stipples].density = HRBFNPR_DENSITY_CALLBACK;
        desc.layer[stipples].density_function = upper_half;
        desc.layer[stipples].density_user = &scale;
        return generate(context, sphere_of(context, scale), desc);
    };
    expect_times(made_at(std::ldexp(1.0, -70)), made_at(1.0), std::ldexp(1.0, -70));
}

TEST(Scale, APowerOfTwoScalesStepPatchesExactly) {
    const Context context = make_context();
    const auto patches = [&](double scale) {
        Error error;
        std::vector<double> corners(12 * 5);
        const hrbfnpr_array_out to = out(corners, 12);
        double step = 0.0;
        Generation desc = small_desc(HRBFNPR_DISTRIBUTION_PUBLISHED);
        EXPECT_OK(hrbfnpr_point_set_step_patches(context.get(), sphere_of(context, scale).get(), desc.get(), &to, &step,
                                                 nullptr, error));
        corners.push_back(step);
        return corners;
    };
    const std::vector<double> small = patches(std::ldexp(1.0, -80));
    const std::vector<double> unit = patches(1.0);
    for (std::size_t i = 0; i < unit.size(); ++i) EXPECT_EQ(small[i], std::ldexp(unit[i], -80));
}

// The picture of a set by a camera that fits its bounds.
std::vector<std::uint8_t> picture_of(const Context& context, const PointSet& set, double angle,
                                     const hrbfnpr_style& style, const hrbfnpr_model* model = nullptr) {
    Error error;
    const hrbfnpr_point_set_info info = info_of(set);
    auto camera = made(hrbfnpr_camera_init);
    const double direction[3] = {0.2, 0.3, -1.0};
    const double up[3] = {0.0, 1.0, 0.0};
    EXPECT_OK(hrbfnpr_camera_fit_bounds(&camera, info.bounds_min, info.bounds_max, direction, up, angle, 96, 96, 0.05,
                                        error));
    const Renderer renderer = make_renderer(context);
    hrbfnpr_item item = item_of(set, &style);
    item.model = model;
    return rasterize(draw_item(renderer, item, camera), 96);
}

hrbfnpr_style preset(std::uint32_t which, std::uint32_t visibility) {
    Error error;
    hrbfnpr_style style;
    EXPECT_OK(hrbfnpr_style_init_preset(&style, sizeof style, which, error));
    style.visibility = visibility;
    return style;
}

double mean_difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(int{a[i]} - int{b[i]});
    return sum / static_cast<double>(a.size());
}

TEST(Scale, PicturesDoNotDependOnTheScale) {
    const Context context = make_context();
    Generation desc = small_desc();
    const auto set_of = [&](double radius) { return generate(context, sphere_of(context, radius), desc); };
    const PointSet unit = set_of(1.0);
    for (const std::uint32_t visibility : {HRBFNPR_VISIBILITY_DEPTH_LAYERS, HRBFNPR_VISIBILITY_PUBLISHED}) {
        const hrbfnpr_style style = preset(HRBFNPR_PRESET_FULL, visibility);
        for (const double angle : {0.0, 0.6}) {
            const std::vector<std::uint8_t> expected = picture_of(context, unit, angle, style);
            ASSERT_GT(mean_difference(expected, std::vector<std::uint8_t>(expected.size(), 255)), 3.0) << "no ink";
            for (const int power : {-100, -66, 66, 100}) {
                const PointSet set = set_of(std::ldexp(1.0, power));
                EXPECT_LT(mean_difference(picture_of(context, set, angle, style), expected), 0.01)
                    << "2^" << power << ", angle " << angle << ", visibility " << visibility;
            }
        }
    }
}

TEST(Scale, ExactVisibilityDoesNotDependOnTheScale) {
    const Context context = make_context();
    const hrbfnpr_style style = preset(HRBFNPR_PRESET_XRAY, HRBFNPR_VISIBILITY_DEPTH_LAYERS);
    std::vector<std::vector<std::uint8_t>> pictures;
    for (const int power : {0, -90, 90}) {
        const Model model = sphere_of(context, std::ldexp(1.0, power));
        const PointSet set = generate(context, model, small_desc());
        pictures.push_back(picture_of(context, set, 0.6, style, model.get()));
    }
    EXPECT_LT(mean_difference(pictures[1], pictures[0]), 0.01);
    EXPECT_LT(mean_difference(pictures[2], pictures[0]), 0.01);
}

// For a host that reads a frame, directions and normals are unit vectors, and positions are those of the marks.
TEST(Scale, VerticesAreFiniteWithUnitDirections) {
    const Context context = make_context();
    Error error;
    const double scale = std::ldexp(1.0, -90);
    const PointSet set = generate(context, sphere_of(context, scale), small_desc());
    const Renderer renderer = make_renderer(context);
    const hrbfnpr_point_set_info info = info_of(set);
    auto camera = made(hrbfnpr_camera_init);
    const double direction[3] = {0.0, 0.0, -1.0};
    const double up[3] = {0.0, 1.0, 0.0};
    ASSERT_OK(
        hrbfnpr_camera_fit_bounds(&camera, info.bounds_min, info.bounds_max, direction, up, 0.6, 96, 96, 0.05, error));
    const hrbfnpr_item item = item_of(set);
    const Drawing drawing = draw_item(renderer, item, camera);
    std::int64_t count = 0;
    ASSERT_OK(hrbfnpr_drawing_vertex_bound(drawing.get(), HRBFNPR_PRIMITIVE_POINTS, &count, nullptr, error));
    ASSERT_GT(count, 20);
    Layout layout;
    layout.add(HRBFNPR_VERTEX_ATTRIBUTE_POSITION, HRBFNPR_SCALAR_FLOAT32, 0);
    layout.add(HRBFNPR_VERTEX_ATTRIBUTE_DIRECTION, HRBFNPR_SCALAR_FLOAT32, 12);
    std::vector<float> vertices(static_cast<std::size_t>(6 * count));
    ASSERT_OK(hrbfnpr_drawing_write_vertices(drawing.get(), layout.get(), vertices.data(), count, &count, nullptr, 0,
                                             nullptr, error));
    for (std::size_t i = 0; i < vertices.size(); i += 6) {
        EXPECT_NEAR(double{std::hypot(vertices[i], vertices[i + 1], vertices[i + 2])} / scale, 1.0, 0.05);
        EXPECT_NEAR(std::hypot(vertices[i + 3], vertices[i + 4], vertices[i + 5]), 1.0, 1e-5);
    }
}

// ---- refusals ------------------------------------------------------------------------------

TEST(Scale, ModelsTooLargeOrSmallForFloatsAreRefused) {
    const Context context = make_context();
    for (const double radius : {1e-100, 1e-60, 1e-38, 1e38, 1e39, 1e60, 1e99}) {
        Error error;
        const Model model = sphere_of(context, radius);
        for (const std::uint32_t distribution : {HRBFNPR_DISTRIBUTION_BLUE_NOISE, HRBFNPR_DISTRIBUTION_PUBLISHED}) {
            Generation desc = small_desc(distribution);
            hrbfnpr_point_set* set = nullptr;
            EXPECT_FAILS(hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), nullptr, &set, error),
                         HRBFNPR_STATUS_INVALID_ARGUMENT, "scale the samples");
            EXPECT_EQ(set, nullptr);
        }
    }
}

TEST(Scale, LargeSpheresGetAllTheirMarks) {
    const Context context = make_context();
    for (const double radius : {1e20, 1e30, 1e-20, 1e-22, 1e-30}) {
        Generation desc = small_desc();
        desc.layer[by_curvature].flags = HRBFNPR_LAYER_WITH_CURVATURE;
        const PointSet set = generate(context, sphere_of(context, radius), desc);
        EXPECT_GE(layer_info(set, stipples).marks, 294) << radius; // the set has 300
        const auto curvature = attribute<float>(set, by_curvature, HRBFNPR_MARK_ATTRIBUTE_CURVATURE);
        EXPECT_FALSE(curvature.empty());
        for (const float x : curvature) ASSERT_TRUE(std::isfinite(x));
        for (const float x : attribute<float>(set, stipples, HRBFNPR_MARK_ATTRIBUTE_POSITION))
            ASSERT_LE(std::abs(x), 1.01 * radius);
    }
}

hrbfnpr_status from_arrays(const Context& context, const std::vector<double>& positions, Error& error) {
    std::vector<double> normals;
    for (std::size_t i = 0; i < positions.size(); ++i) normals.push_back(i % 3 == 2 ? 1.0 : 0.0);
    auto desc = made(hrbfnpr_point_set_desc_init);
    auto arrays = made(hrbfnpr_layer_arrays_init);
    arrays.position = in(positions);
    arrays.normal = in(normals);
    desc.layers = &arrays;
    desc.layer_count = 1;
    hrbfnpr_point_set* set = nullptr;
    const hrbfnpr_status status = hrbfnpr_point_set_create(context.get(), &desc, &set, error);
    hrbfnpr_point_set_release(set);
    return status;
}

TEST(Scale, GivenMarksTooLargeOrSmallForFloatsAreRefused) {
    const Context context = make_context();
    Error error;
    for (const double size : {1e-300, 1e-40, 1e34, 1e38})
        EXPECT_FAILS(from_arrays(context, {0, 0, 0, size, 0, 0, 0, size, 0}, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                     "scale the");
    EXPECT_FAILS(from_arrays(context, {0, 0, 0, 1e300, 0, 0}, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "layers[0].position[1]");
    EXPECT_OK(from_arrays(context, {0, 0, 0, 1e-30, 0, 0, 0, 1e-30, 0}, error));
    EXPECT_OK(from_arrays(context, {0, 0, 0, 1e30, 0, 0, 0, 1e30, 0}, error));
    EXPECT_OK(from_arrays(context, {5, 0, 0}, error)); // one point has no size, wherever it is
}

// A single seed that is too far from the model is refused.
TEST(Scale, SeedsFarFromTheModelAreRefused) {
    const Context context = make_context();
    Error error;
    scenes::Samples plane;
    plane.add({0, 0, 0}, {0, 0, 1});
    plane.add({1, 0, 0}, {0, 0, 1});
    plane.add({0, 1, 0}, {0, 0, 1});
    const Model model = fit(context, plane);
    const std::vector<double> seeds{0.1, 0.1, 0.0, 1e35, 0.0, 0.0};
    Generation desc = small_desc();
    desc.seed_source = HRBFNPR_SEED_POINTS;
    desc.seed_points = in(seeds);
    hrbfnpr_point_set* set = nullptr;
    EXPECT_FAILS(hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), nullptr, &set, error),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "seed_points[1]");
}

// ---- questions to a model ------------------------------------------------------------------

struct Answers {
    std::vector<double> value = std::vector<double>(2), gradient = std::vector<double>(6),
                        hessian = std::vector<double>(12), position = std::vector<double>(6),
                        normal = std::vector<double>(6), k1 = std::vector<double>(2), k2 = std::vector<double>(2),
                        t = std::vector<double>(2);
    std::vector<std::uint8_t> status = std::vector<std::uint8_t>(2);

    // Expects that each call returns finite numbers or an error message.
    void ask(const Model& model, const std::vector<double>& point);
};

void expect_said(hrbfnpr_status status, const Error& error, const std::vector<const std::vector<double>*>& numbers) {
    if (status != HRBFNPR_STATUS_OK) {
        EXPECT_EQ(status, HRBFNPR_STATUS_INVALID_ARGUMENT);
        EXPECT_NE(std::string(error.record.message).find("points["), std::string::npos) << error.record.message;
        return;
    }
    for (const auto* all : numbers)
        for (const double number : *all) EXPECT_TRUE(std::isfinite(number)) << number;
}

void Answers::ask(const Model& model, const std::vector<double>& point) {
    const hrbfnpr_array points = in(point);
    const hrbfnpr_array_out to_value = out(value, 1), to_gradient = out(gradient), to_hessian = out(hessian, 6);
    auto projection = made(hrbfnpr_projection_init);
    projection.position = out(position);
    projection.normal = out(normal);
    projection.status = out(status, 1);
    auto curvature = made(hrbfnpr_curvature_init);
    curvature.k1 = out(k1, 1);
    curvature.k2 = out(k2, 1);
    Error error;
    expect_said(hrbfnpr_model_evaluate(model.get(), &points, &to_value, &to_gradient, &to_hessian, nullptr, error),
                error, {&value, &gradient, &hessian});
    expect_said(hrbfnpr_model_project(model.get(), &points, nullptr, &projection, nullptr, error), error,
                {&position, &normal});
    expect_said(hrbfnpr_model_curvature(model.get(), &points, &curvature, nullptr, error), error, {&k1, &k2});
}

TEST(Scale, AnswersAreFiniteOrRefused) {
    const Context context = make_context();
    for (const double radius : {1e-99, 1e-60, 1e-30, 1.0, 1e30, 1e60, 1e99}) {
        const Model model = sphere_of(context, radius);
        for (const double part : {0.0, 1e-20, 0.5, 1.2, 1e10, 1e100, 1e200, 1e307}) {
            const double x = radius * part;
            if (!std::isfinite(x)) continue;
            SCOPED_TRACE(testing::Message() << "radius " << radius << ", at " << x);
            Answers().ask(model, {x, 0.0, 0.0, 0.3 * x, 0.3 * x, 0.3 * x});
        }
        Answers near;
        near.ask(model, {1.2 * radius, 0.0, 0.0, 0.0, 1.1 * radius, 0.0});
        EXPECT_NEAR(near.position[0] / radius, 1.0, 1e-6) << radius;
        EXPECT_EQ(near.status[0], HRBFNPR_PROJECTION_CONVERGED) << radius;
    }
}

// If a float cannot hold a result, the call fails and does not return infinity.
TEST(Scale, FloatArraysThatCannotHoldAnAnswerAreRefused) {
    const Context context = make_context();
    Error error;
    const Model model = sphere_of(context, 1e-60);
    const std::vector<double> point{1e-60, 0.0, 0.0};
    std::vector<float> k1(1);
    const hrbfnpr_array points = in(point);
    auto curvature = made(hrbfnpr_curvature_init);
    curvature.k1 = out(k1, 1);
    EXPECT_FAILS(hrbfnpr_model_curvature(model.get(), &points, &curvature, nullptr, error),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "too large for FLOAT32; give a FLOAT64 array");
    const Model large = sphere_of(context, 1e60);
    const std::vector<double> far{2e60, 0.0, 0.0};
    std::vector<float> value(1), place(3);
    const hrbfnpr_array from = in(far);
    const hrbfnpr_array_out values = out(value, 1);
    auto projection = made(hrbfnpr_projection_init);
    projection.position = out(place);
    EXPECT_FAILS(hrbfnpr_model_evaluate(large.get(), &from, &values, nullptr, nullptr, nullptr, error),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "FLOAT64");
    EXPECT_FAILS(hrbfnpr_model_project(large.get(), &from, nullptr, &projection, nullptr, error),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "projection.position[0] is ");
}

TEST(Scale, RaysAreCastAtAnyScaleOrRefused) {
    const Context context = make_context();
    for (const double radius : {1e-99, 1e-30, 1.0, 1e30, 1e99}) {
        const Model model = sphere_of(context, radius);
        for (const double length : {1e-300, 1.0, 1e300}) {
            Error error;
            const std::vector<double> origin{0.0, 0.0, 3.0 * radius}, direction{0.0, 0.0, -length};
            std::vector<double> t(1), place(3);
            std::vector<std::uint32_t> count(1);
            const hrbfnpr_array from = in(origin), along = in(direction);
            auto hits = made(hrbfnpr_ray_hits_init);
            hits.count = out(count, 1);
            hits.t = out(t, 1);
            hits.position = out(place);
            const hrbfnpr_status status =
                hrbfnpr_model_cast_rays(model.get(), &from, &along, nullptr, &hits, nullptr, error);
            if (status != HRBFNPR_STATUS_OK) {
                EXPECT_NE(std::string(error.record.message).find("directions[0]"), std::string::npos)
                    << error.record.message;
                continue;
            }
            ASSERT_EQ(count[0], 1U) << radius << ' ' << length;
            EXPECT_NEAR(place[2] / radius, 1.0, 1e-6) << radius << ' ' << length;
            EXPECT_TRUE(std::isfinite(t[0])) << radius << ' ' << length;
        }
    }
}

TEST(Scale, ExtremeBoxesOfCustomModelsAreRefused) {
    const Context context = make_context();
    Error error;
    Sphere sphere;
    for (const double half : {1e-200, 1e-130, 1e130, 1e200}) {
        hrbfnpr_custom_desc desc = sphere_desc(sphere, 0);
        for (int axis = 0; axis < 3; ++axis) {
            desc.bounds_min[axis] = -half;
            desc.bounds_max[axis] = half;
        }
        hrbfnpr_model* model = nullptr;
        EXPECT_FAILS(hrbfnpr_model_create_custom(context.get(), &desc, &model, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                     "custom_desc.bounds");
        hrbfnpr_model_release(model);
    }
}

} // namespace
} // namespace api_test::scale_test
