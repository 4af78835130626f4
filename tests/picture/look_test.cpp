// SPDX-License-Identifier: MIT
#include "picture/look.h"
#include "support/handles.h"
#include "support/samples.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace hrbfnpr::picture::look_test {
namespace {

const glm::dvec3 y_up(0, 1, 0);
const glm::dvec3 z_up(0, 0, 1);

struct LookTest : testing::Test {
    LookTest() : places(&pool) {
        for (int i = 0; i < 40; ++i) {
            places.emplace_back(i * 7 % 11 / 8.0 - 0.5, i * 5 % 13 / 16.0, i * 3 % 17 / 4.0 + 1.0);
            bounds.extend(places.back());
        }
    }
    [[nodiscard]] static View view(const glm::dvec3& up, std::int32_t size = 1600) {
        View made;
        made.up = up;
        made.size = size;
        made.margin = 0.05;
        return made;
    }
    // Returns the box of all places in the picture, in pixels.
    [[nodiscard]] geometry::Bounds in_picture(const hrbfnpr_camera& camera) const {
        geometry::Bounds box;
        for (const glm::dvec3& place : places) box.extend(pixel_of(camera, place));
        return box;
    }
    [[nodiscard]] static glm::dvec3 pixel_of(const hrbfnpr_camera& camera, const glm::dvec3& place) {
        const glm::dvec4 clip = clip_place(camera, place);
        return {(clip.x / clip.w + 1.0) / 2.0 * camera.viewport[2], (1.0 - clip.y / clip.w) / 2.0 * camera.viewport[3],
                0.0};
    }
    // Returns the place of the eye, which the view takes to the origin.
    [[nodiscard]] static glm::dvec3 eye_of(const hrbfnpr_camera& camera) {
        glm::dvec3 eye(0.0);
        for (int axis = 0; axis < 3; ++axis)
            for (int row = 0; row < 3; ++row) eye[axis] -= camera.view[4 * axis + row] * camera.view[12 + row];
        return eye;
    }

    base::Memory memory;
    Pool pool{memory};
    Points places;
    geometry::Bounds bounds;
};

TEST_F(LookTest, PointsFillThePicture) {
    for (const double fov : {0.0, 30.0}) {
        View wanted = view(z_up, 640);
        wanted.fov = fov;
        const hrbfnpr_camera camera = camera_for(wanted, bounds, places, false);
        const double width = camera.viewport[2];
        const double height = camera.viewport[3];
        EXPECT_EQ(std::max(width, height), 640.0);
        const geometry::Bounds seen = in_picture(camera);
        EXPECT_NEAR(seen.size().x, 0.9 * width, 1.0); // Sides are rounded to whole pixels.
        EXPECT_NEAR(seen.size().y, 0.9 * height, 1.0);
        EXPECT_NEAR(seen.centre().x, width / 2.0, 1e-9);
        EXPECT_NEAR(seen.centre().y, height / 2.0, 1e-9);
    }
}

TEST_F(LookTest, OneAxisFillsAPictureOfAGivenSize) {
    View wanted = view(y_up);
    wanted.width = 300;
    wanted.height = 900;
    wanted.margin = 0.1;
    const geometry::Bounds seen = in_picture(camera_for(wanted, bounds, places, false));
    EXPECT_NEAR(seen.size().x, 0.8 * 300.0, 1e-9);
    EXPECT_LT(seen.size().y, 0.8 * 900.0);
}

TEST_F(LookTest, ASlimPictureIsAQuarterWide) {
    Points line(&pool);
    for (int i = 0; i < 5; ++i) line.emplace_back(0.0, i, 0.0);
    geometry::Bounds box{{0, 0, 0}, {0, 4, 0}};
    const hrbfnpr_camera camera = camera_for(view(y_up, 400), box, line, false);
    EXPECT_EQ(camera.viewport[2], 100.0);
    EXPECT_EQ(camera.viewport[3], 400.0);
}

// NumPy computed the numbers, before this was C++: the translation of the view, the entries other than 0 in the first
// two rows of the projection, and the size.
TEST_F(LookTest, CamerasStayTheSame) {
    struct Case {
        View view;
        bool is_find;
        double turn;
        std::array<double, 9> numbers;
        double width;
        double height;
    };
    const auto with = [](View view, auto&& change) {
        change(view);
        return view;
    };
    const std::array cases{Case{view(z_up),
                                false,
                                0.0,
                                {-0.29575317547305513, -2.9087759031721294, -9.56192103512944, 11.588346133742414,
                                 3.94728040180601, 0.006784939054608766, 0.025268758919998968, 0.0, 0.0},
                                545,
                                1600},
                           Case{with(view(y_up),
                                     [](View& v) {
                                         v.fov = 0.0;
                                         v.direction = glm::dvec3(-1.0, -2.0, 0.5);
                                     }),
                                false,
                                0.0,
                                {2.7391832724372427, -1.2564713439212365, -1.1894972749741335, 0.44108738186297214,
                                 0.7763914312219532, 0.0, 0.0, -0.012328767123287768, -0.014206508519364617},
                                1600,
                                909},
                           Case{view(z_up),
                                true,
                                0.0,
                                {-0.2957531754730548, -2.90877590317213, -2.4882201085712197, 1.2620227343089405,
                                 0.4559057127691048, 0.0, 0.0, 0.01971910522357719, 0.01914126734055741},
                                578,
                                1600},
                           Case{with(view(z_up),
                                     [](View& v) {
                                         v.width = 320;
                                         v.height = 200;
                                         v.fov = 0.0;
                                         v.eye = glm::dvec3(8.0, 6.0, 7.0);
                                         v.target = glm::dvec3(0.0, 0.5, 2.0);
                                     }),
                                false,
                                0.0,
                                {-0.41202096209968353, -1.6483419486322122, -12.087729627484634, 0.29361010975735174,
                                 0.46977617561176277, 0.0, 0.0, 0.0, 0.0},
                                320,
                                200},
                           Case{with(view(z_up, 480), [](View& v) { v.azimuth = 120.0; }),
                                false,
                                -90.0,
                                {-0.24224236766834606, -2.7180632548932886, -10.600023595996618, 12.227656868249507,
                                 4.050411337607649, 0.030633636552939915, 0.02458246538251951, 0.0, 0.0},
                                159,
                                480}};
    for (std::size_t i = 0; i < cases.size(); ++i) {
        SCOPED_TRACE(i);
        const Case& one = cases[i];
        const std::int32_t frames = one.turn < 0.0 ? 5 : 36;
        const hrbfnpr_camera camera = one.turn != 0.0
                                          ? first_camera(one.view, bounds, places, one.turn, frames, one.is_find)
                                          : camera_for(one.view, bounds, places, one.is_find);
        const std::array found{camera.view[12],      camera.view[13],       camera.view[14],
                               camera.projection[0], camera.projection[5],  camera.projection[8],
                               camera.projection[9], camera.projection[12], camera.projection[13]};
        for (std::size_t k = 0; k < found.size(); ++k)
            EXPECT_NEAR(found[k], one.numbers[k], 2e-14 * std::max(1.0, std::abs(one.numbers[k]))) << k;
        EXPECT_EQ(camera.viewport[2], one.width);
        EXPECT_EQ(camera.viewport[3], one.height);
    }
}

TEST_F(LookTest, AzimuthAndDirectionAreInverse) {
    for (const glm::dvec3& up : {y_up, z_up, glm::dvec3(0.3, -0.8, 0.5)})
        for (const double azimuth : {0.5, 77.0, 180.0, 359.0})
            EXPECT_NEAR(azimuth_of(up, -direction_of_view(up, azimuth, 35.0)), azimuth, 1e-9);
    const auto expect_near = [](const glm::dvec3& a, const glm::dvec3& b) { EXPECT_LT(glm::length(a - b), 1e-15); };
    expect_near(direction_of_view(y_up, 0.0, 0.0), {0, 0, -1});
    expect_near(direction_of_view(z_up, 0.0, 0.0), {0, 1, 0});
    expect_near(direction_of_view(z_up, 90.0, 0.0), {-1, 0, 0});
    expect_near(direction_of_view(z_up, 0.0, 90.0), {0, 0, -1});
}

TEST_F(LookTest, OpenSurfacesThatLookAwayHaveAFront) {
    EXPECT_EQ(front_azimuth(y_up, {0, 0, 0.5}), std::nullopt);  // The usual camera sees the front.
    EXPECT_EQ(front_azimuth(y_up, {0, -0.5, 0}), std::nullopt); // It faces down: no azimuth shows it better.
    EXPECT_EQ(front_azimuth(y_up, {0, 0, -0.2}), std::nullopt); // It faces all sides.
    EXPECT_EQ(front_azimuth(y_up, {0, 0, -0.5}), 210.0);
    EXPECT_EQ(front_azimuth(z_up, {0, 0.5, 0}), 210.0);
    EXPECT_EQ(front_azimuth(y_up, {-0.5, 0, 0}), 300.0);
}

TEST_F(LookTest, PixelsPerUnitAreMeasured) {
    const hrbfnpr_camera camera = camera_for(view(z_up), bounds, places, false);
    const glm::dvec3 place = bounds.centre();
    const glm::dvec3 right(camera.view[0], camera.view[4], camera.view[8]);
    constexpr double step = 1e-4;
    const double measured = glm::length(pixel_of(camera, place + step * right) - pixel_of(camera, place)) / step;
    EXPECT_NEAR(pixels_per_unit(camera, place), measured, 1e-6 * measured);
}

TEST_F(LookTest, AnOrbitStaysInThePicture) {
    for (const double turn : {360.0, -90.0}) {
        const View wanted = view(z_up, 480);
        const hrbfnpr_camera first = first_camera(wanted, bounds, places, turn, 7, false);
        const glm::dvec3 centre = orbit_centre(wanted, bounds);
        for (int i = 0; i < 7; ++i) {
            const geometry::Bounds seen = in_picture(turned(first, z_up, centre, turn * i / 7));
            EXPECT_GT(seen.min.x, 0.0);
            EXPECT_GT(seen.min.y, 0.0);
            EXPECT_LT(seen.max.x, first.viewport[2]);
            EXPECT_LT(seen.max.y, first.viewport[3]);
        }
    }
}

TEST_F(LookTest, AnOrbitGoesAroundTheAxis) {
    View wanted = view(y_up);
    wanted.azimuth = 10.0;
    const hrbfnpr_camera camera = camera_for(wanted, bounds, places, false);
    const glm::dvec3 centre = orbit_centre(wanted, bounds);
    const glm::dvec3 from = eye_of(camera) - centre;
    const glm::dvec3 to = eye_of(turned(camera, y_up, centre, 40.0)) - centre;
    EXPECT_NEAR(from.y, to.y, 1e-12);
    EXPECT_NEAR(azimuth_of(y_up, from), 10.0, 1e-9);
    EXPECT_NEAR(azimuth_of(y_up, to), 50.0, 1e-9);
    wanted.eye = glm::dvec3(5.0);
    EXPECT_EQ(orbit_centre(wanted, bounds), centre);
    wanted.target = glm::dvec3(1.0, 2.0, 3.0);
    EXPECT_EQ(orbit_centre(wanted, bounds), *wanted.target);
}

TEST_F(LookTest, ACallersCameraIsUsedUnchanged) {
    View wanted = view(y_up);
    wanted.camera = camera_for(view(z_up, 77), bounds, places, false);
    const hrbfnpr_camera camera = camera_for(wanted, bounds, places, false);
    EXPECT_EQ(camera.viewport[3], 77.0);
    EXPECT_EQ(first_camera(wanted, bounds, places, 360.0, 36, false).projection[0], camera.projection[0]);
}

TEST_F(LookTest, InvalidViewsAreRefused) {
    EXPECT_THROW(static_cast<void>(camera_for(view(y_up), bounds, Points(&pool), false)), Error);
    places[3].y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(static_cast<void>(camera_for(view(y_up), bounds, places, false)), Error);
    EXPECT_THROW(static_cast<void>(camera_for(view(glm::dvec3(0.0)), bounds, places, false)), Error);
}

TEST_F(LookTest, OnePointIsSeen) {
    const Points one({glm::dvec3(1e6, 0, 3)}, &pool);
    const hrbfnpr_camera camera = camera_for(view(y_up, 100), {one[0], one[0]}, one, false);
    EXPECT_EQ(camera.viewport[2], 100.0);
    EXPECT_NEAR(pixel_of(camera, one[0]).x, 50.0, 1.0);
}

// ---- With a model

struct ProbeTest : LookTest {
    ProbeTest() {
        hrbfnpr_context* made = nullptr;
        test::Check check;
        check(hrbfnpr_context_create(nullptr, &made, check.error()));
        context.reset(made);
    }
    [[nodiscard]] Model fitted(const test::Samples& samples) const {
        auto fit = defaults<hrbfnpr_fit_desc>(hrbfnpr_fit_desc_init);
        fit.points = {samples.points.data(), samples.count(), 0, HRBFNPR_SCALAR_FLOAT64, 3};
        fit.normals = {samples.normals.data(), samples.count(), 0, HRBFNPR_SCALAR_FLOAT64, 3};
        return make<Model>([&](hrbfnpr_model** out, hrbfnpr_error* error) {
            return hrbfnpr_model_fit(context.get(), &fit, nullptr, out, error);
        });
    }

    test::Context context;
    hrbfnpr_picture_desc desc = defaults<hrbfnpr_picture_desc>(hrbfnpr_picture_desc_init);
};

TEST_F(ProbeTest, MeasuresTheAreaAndFindsPlaces) {
    const Options options(desc, nullptr, pool);
    Report report(pool, HRBFNPR_WORDING_OPTIONS, nullptr, nullptr, *context, nullptr);
    test::Samples samples = test::sphere(300);
    for (std::size_t i = 0; i < samples.points.size(); i += 3) samples.points[i] += 1000.0;
    const Model model = fitted(samples);
    const Probe found = probe({*context, options, report, pool}, model);
    EXPECT_NEAR(found.area, 4.0 * 3.14159265358979, 0.05);
    EXPECT_LT(glm::length(found.mean_normal), 0.01);
    ASSERT_EQ(found.places.size(), 2000U);
    for (const glm::dvec3& place : found.places) EXPECT_NEAR(glm::length(place - glm::dvec3(1000, 0, 0)), 1.0, 0.01);
    const geometry::Bounds box = bounds_of(std::array{model, model});
    EXPECT_EQ(box.min, bounds_of(model).min);
    EXPECT_EQ(box.max, bounds_of(model).max);
    EXPECT_NEAR(bounds_of(found.marks).max.x, 1001.0, 0.01);
}

TEST_F(ProbeTest, LooksAtTheFront) {
    const Options options(desc, nullptr, pool);
    Report report(pool, HRBFNPR_WORDING_OPTIONS, nullptr, nullptr, *context, nullptr);
    const Call call{*context, options, report, pool};
    std::array<Probe, 2> probes{Probe(pool), Probe(pool)}; // A large one faces -z, a small one x.
    probes[0].area = 9.0;
    probes[0].mean_normal = {0, 0, -0.6};
    probes[1].area = 1.0;
    probes[1].mean_normal = {0.6, 0, 0};
    for (Probe& one : probes) one.places = places;

    View free = view(y_up);
    look_at_front(call, free, nullptr, probes);
    EXPECT_EQ(free.azimuth, 204.0); // 180 - atan(1 / 9), plus 30
    ASSERT_EQ(report.notes.size(), 1U);
    EXPECT_EQ(report.notes[0].code, HRBFNPR_NOTE_SEEN_FROM_FRONT);
    EXPECT_STREQ(report.notes[0].text.c_str(),
                 "the surface is drawn from its front, azimuth 204 (--azimuth 30 shows its back)");

    Shape photo(pool);
    photo.is_photo = true;
    photo.viewpoint = glm::dvec3(-90.0, 0.0, 0.0);
    View of_photo = view(y_up);
    look_at_front(call, of_photo, &photo, probes);
    EXPECT_EQ(of_photo.azimuth, 268.0);
    EXPECT_EQ(of_photo.elevation, 0.0);
    ASSERT_EQ(report.notes.size(), 2U);
    EXPECT_STREQ(report.notes[1].text.c_str(), "the depth image is drawn from where its camera stood, azimuth 268");

    View said = view(y_up);
    said.azimuth = 30.0;
    look_at_front(call, said, nullptr, probes);
    EXPECT_EQ(said.azimuth, 30.0);
    EXPECT_EQ(report.notes.size(), 2U);
}

TEST_F(ProbeTest, OptionsBecomeAView) {
    const View free = view_of(Options(desc, nullptr, pool), z_up);
    EXPECT_FALSE(free.camera || free.azimuth || free.elevation || free.direction || free.eye || free.target ||
                 free.fov);
    EXPECT_EQ(free.margin, 0.05);
    EXPECT_EQ(free.up, z_up);
    EXPECT_EQ(free.width, 0);
    EXPECT_EQ(free.size, 1600);
    desc.width = 320;
    desc.height = 200;
    desc.eye[0] = desc.eye[1] = desc.eye[2] = 2.0;
    desc.azimuth = 0.0;
    desc.fov = 0.0;
    desc.margin = 0.0;
    const View given = view_of(Options(desc, nullptr, pool), y_up);
    EXPECT_EQ(given.width, 320);
    EXPECT_EQ(given.height, 200);
    EXPECT_EQ(given.eye, glm::dvec3(2.0));
    EXPECT_EQ(given.azimuth, 0.0);
    EXPECT_EQ(given.fov, 0.0);
    EXPECT_EQ(given.margin, 0.0);
}

} // namespace
} // namespace hrbfnpr::picture::look_test
