// SPDX-License-Identifier: MIT
#include "mesh_shapes.h"
#include "support/depth_image.h"
#include "support/handles.h"
#include "support/samples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace picture_tests::inspect_test {
namespace {

using namespace hrbfnpr;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Told {
    std::uint32_t severity;
    std::uint32_t code;
    std::vector<double> figures;
    std::string text;
    std::string advice;
};

class InspectTest : public testing::Test {
protected:
    InspectTest() {
        hrbfnpr_context* made = nullptr;
        check_(hrbfnpr_context_create(nullptr, &made, check_.error()));
        context.reset(made);
    }

    static hrbfnpr_array in(const std::vector<double>& packed) {
        return {packed.data(), static_cast<std::int64_t>(packed.size() / 3), 0, HRBFNPR_SCALAR_FLOAT64, 3};
    }
    static hrbfnpr_picture_source source_of(const test::Samples& samples, bool with_normals = true) {
        auto source = test::made(hrbfnpr_picture_source_init);
        source.points = in(samples.points);
        if (with_normals) source.normals = in(samples.normals);
        return source;
    }
    static hrbfnpr_picture_source source_of(const test::Triangles& mesh) {
        auto source = test::made(hrbfnpr_picture_source_init);
        source.points = in(mesh.vertices);
        source.triangles = {mesh.triangles.data(), static_cast<std::int64_t>(mesh.faces()), 0, HRBFNPR_SCALAR_INT32, 3};
        return source;
    }

    static void on_event(void* user, const hrbfnpr_picture_event* event) {
        if (event->note == nullptr) return;
        const hrbfnpr_note& note = *event->note;
        static_cast<InspectTest*>(user)->told.push_back({note.severity,
                                                         note.code,
                                                         {note.figures, note.figures + note.figure_count},
                                                         note.text,
                                                         note.advice != nullptr ? note.advice : ""});
    }
    hrbfnpr_source_info inspect(const hrbfnpr_picture_source& source, std::uint32_t wording = HRBFNPR_WORDING_OPTIONS) {
        told.clear();
        auto info = test::made(hrbfnpr_source_info_init);
        check_(hrbfnpr_source_inspect(context.get(), &source, wording, on_event, this, nullptr, &info, check_.error()));
        return info;
    }
    template <class From>
    hrbfnpr_source_info inspect(const From& from) {
        return inspect(source_of(from));
    }

    [[nodiscard]] std::vector<std::string> texts(std::uint32_t severity) const {
        std::vector<std::string> texts;
        for (const Told& each : told)
            if (each.severity == severity) texts.push_back(each.text);
        return texts;
    }
    [[nodiscard]] std::vector<std::string> repairs() const { return texts(HRBFNPR_SEVERITY_NOTE); }
    [[nodiscard]] std::vector<std::string> warnings() const { return texts(HRBFNPR_SEVERITY_WARNING); }
    [[nodiscard]] std::vector<std::string> failures() const { return texts(HRBFNPR_SEVERITY_FAILURE); }
    [[nodiscard]] std::vector<std::string> advice() const {
        std::vector<std::string> all;
        for (const Told& each : told)
            if (!each.advice.empty()) all.push_back(each.advice);
        return all;
    }

    test::Context context;
    std::vector<Told> told;

private:
    test::Check check_;
};

test::Samples turned(test::Samples samples, double factor = -1.0) {
    for (double& n : samples.normals) n *= factor;
    return samples;
}

TEST_F(InspectTest, Good_points_have_facts_and_no_findings) {
    const auto info = inspect(test::sphere(400));
    EXPECT_THAT(told, IsEmpty());
    EXPECT_EQ(info.kind, HRBFNPR_SOURCE_KIND_POINTS);
    EXPECT_EQ(info.severity, HRBFNPR_SEVERITY_INFO);
    EXPECT_EQ(info.points, 400);
    EXPECT_EQ(info.has_normals, 1U);
    EXPECT_EQ(info.normals_look, HRBFNPR_NORMALS_LOOK_OUTWARD);
    EXPECT_EQ(info.normals_unit_share, 1.0);
    EXPECT_NEAR(info.normals_closed, 1.0, 0.15);
    EXPECT_EQ(info.normals_flipped_share, 0.0);
    EXPECT_EQ(info.along_curves, 0U);
    EXPECT_NEAR(info.diagonal, 2.0 * std::sqrt(3.0), 0.02);
    EXPECT_NEAR(info.bounds_min[0], -1.0, 0.01);
    EXPECT_NEAR(info.bounds_max[2], 1.0, 0.01);
    EXPECT_THAT(info.up, ElementsAre(0.0, 1.0, 0.0));
    EXPECT_STREQ(info.up_reason, "nothing suggests another direction");
}

TEST_F(InspectTest, The_format_tells_up) {
    const test::Samples ball = test::sphere(100);
    auto source = source_of(ball);
    source.up[2] = 1.0;
    source.up_by = "STL files";
    const auto info = inspect(source);
    EXPECT_THAT(info.up, ElementsAre(0.0, 0.0, 1.0));
    EXPECT_STREQ(info.up_reason, "as in STL files");
    const std::string longer(300, 'x');
    source.up_by = longer.c_str();
    EXPECT_EQ(std::string(inspect(source).up_reason).size(), sizeof info.up_reason - 1);
}

TEST_F(InspectTest, Inward_normals_give_a_warning_in_the_callers_words) {
    const test::Samples inward = turned(test::sphere(400), -3.0);
    const auto info = inspect(inward);
    EXPECT_EQ(info.normals_look, HRBFNPR_NORMALS_LOOK_INWARD);
    EXPECT_EQ(info.severity, HRBFNPR_SEVERITY_WARNING);
    EXPECT_EQ(info.normals_unit_share, 0.0);
    EXPECT_THAT(repairs(), ElementsAre("400 normals scaled to length 1", "all normals turned, as they point inward"));
    EXPECT_THAT(warnings(), ElementsAre("all normals point inward"));
    EXPECT_THAT(advice(), ElementsAre("nothing, as the fit turns them; --normals keep leaves them"));
    inspect(source_of(inward), HRBFNPR_WORDING_ARGUMENTS);
    EXPECT_THAT(advice(), ElementsAre("nothing, as the fit turns them; normals='keep' leaves them"));
    inspect(source_of(inward), HRBFNPR_WORDING_FIELDS);
    EXPECT_THAT(advice(), ElementsAre("nothing, as the fit turns them; normals keep leaves them"));
}

TEST_F(InspectTest, Mixed_normals_give_a_warning) {
    test::Samples mixed = test::torus(600);
    for (std::size_t i = 0; i < mixed.normals.size(); ++i)
        if (i / 3 % 4 == 0) mixed.normals[i] = -mixed.normals[i];
    const auto info = inspect(mixed);
    EXPECT_EQ(info.normals_look, HRBFNPR_NORMALS_LOOK_MIXED);
    EXPECT_NEAR(info.normals_flipped_share, 0.25, 0.05);
    EXPECT_THAT(repairs(), IsEmpty());
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].code, HRBFNPR_NOTE_NORMALS_AGAINST);
    EXPECT_THAT(told[0].text, testing::EndsWith("normals oppose their neighbours"));
    EXPECT_EQ(told[0].advice, "--flipped-normals reorient repairs a few");
}

TEST_F(InspectTest, Unusable_points_are_counted) {
    test::Samples samples = test::sphere(300);
    samples.points[3] = nan;
    samples.points[7] = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 30; i < 36; ++i) samples.normals[i] = 0.0;
    samples.normals[60] = nan;
    for (std::size_t i = 0; i < 3; ++i) { // Point 101 repeats point 100 with the opposite normal.
        samples.points[303 + i] = samples.points[300 + i];
        samples.normals[303 + i] = -samples.normals[300 + i];
    }
    const auto info = inspect(samples);
    EXPECT_EQ(info.points, 300);
    EXPECT_EQ(info.points_not_finite, 2);
    EXPECT_EQ(info.normals_zero, 2);
    EXPECT_EQ(info.normals_not_finite, 1);
    EXPECT_EQ(info.duplicates, 1);
    EXPECT_EQ(info.normals_look, HRBFNPR_NORMALS_LOOK_OUTWARD);
    EXPECT_THAT(repairs(), ElementsAre("2 points without a finite position left out",
                                       "1 point merged with another at the same place, if their normals agree",
                                       "3 points without a usable normal left out"));
    EXPECT_THAT(warnings(), ElementsAre("2 points have a position that is not finite",
                                        "2 normals are zero, 1 not finite", "1 place with opposite normals left out"));
    EXPECT_THAT(advice(), IsEmpty());
}

TEST_F(InspectTest, Missing_normals_are_made) {
    const test::Samples ball = test::sphere(200);
    auto info = inspect(source_of(ball, false));
    EXPECT_EQ(info.has_normals, 0U);
    EXPECT_EQ(info.normals_look, HRBFNPR_NORMALS_LOOK_UNKNOWN);
    EXPECT_THAT(repairs(), ElementsAre("normals computed, as there are none"));
    EXPECT_THAT(warnings(), ElementsAre("the points have no normals"));
    EXPECT_THAT(advice(), ElementsAre("nothing, as they are computed; normals from the scanner are more reliable"));
    info = inspect(turned(ball, 0.0));
    EXPECT_THAT(repairs(), ElementsAre("normals computed, as all are zero"));
}

TEST_F(InspectTest, Strays_no_data_and_distant_origins_are_reported) {
    test::Samples samples = test::sphere(1000);
    samples.add({40.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
    samples.add({0.0, 0.0, -9999.0}, {1.0, 0.0, 0.0});
    auto info = inspect(samples);
    EXPECT_EQ(info.no_data, 1);
    EXPECT_EQ(info.strays, 1);
    EXPECT_EQ(info.points, 1002);
    EXPECT_LT(info.bounds_max[0], 1.01);
    EXPECT_THAT(repairs(), ElementsAre("1 point left out, as the value -9999 marks missing data",
                                       "1 point far from all others left out"));
    EXPECT_EQ(info.severity, HRBFNPR_SEVERITY_NOTE);

    samples = test::sphere(200);
    for (std::size_t i = 1; i < samples.points.size(); i += 3) samples.points[i] += 4e6;
    inspect(samples);
    EXPECT_THAT(warnings(),
                ElementsAre("the model is far from the origin for its size: single precision loses its details"));
    EXPECT_THAT(advice(), ElementsAre("move it to the origin with a program that keeps double precision"));

    for (double& x : samples.points) x = 2.0;
    inspect(samples);
    EXPECT_THAT(warnings(), Contains("all points are at one place: there is no surface to draw"));
}

TEST_F(InspectTest, A_terrain_that_looks_down_gives_a_warning) {
    test::Samples waves;
    for (int i = 0; i < 30; ++i)
        for (int j = 0; j < 30; ++j) {
            const double x = 0.1 * i;
            const double y = 0.1 * j;
            const std::array<double, 3> n{-0.2 * std::cos(2.0 * x), 0.0, 1.0};
            const double length = -std::hypot(n[0], n[2]);
            waves.add({x, y, 0.1 * std::sin(2.0 * x)}, {n[0] / length, 0.0, n[2] / length});
        }
    const auto info = inspect(waves);
    EXPECT_EQ(info.looks_down, 2U);
    EXPECT_THAT(info.up, ElementsAre(0.0, 0.0, 1.0));
    EXPECT_EQ(info.normals_look, HRBFNPR_NORMALS_LOOK_OPEN);
    EXPECT_THAT(repairs(), ElementsAre("all normals turned, as a terrain faces up"));
    EXPECT_THAT(warnings(), Contains("the surface is a terrain whose normals point down along z"));
}

TEST_F(InspectTest, Normals_along_curves_are_judged_by_the_library) {
    const test::Samples wires = test::torus_wires(0.4);
    auto info = inspect(wires);
    EXPECT_EQ(info.along_curves, 1U);
    EXPECT_EQ(info.normals_look, HRBFNPR_NORMALS_LOOK_OUTWARD);
    EXPECT_THAT(told, IsEmpty());
    info = inspect(turned(wires));
    EXPECT_EQ(info.normals_look, HRBFNPR_NORMALS_LOOK_INWARD);
    EXPECT_THAT(repairs(), ElementsAre("normals repaired, as they point inward"));
    EXPECT_THAT(warnings(), ElementsAre("the normals point inward"));
    EXPECT_THAT(advice(), ElementsAre("nothing, as the fit repairs them; --normals keep leaves them"));
}

TEST_F(InspectTest, An_undrawable_source_is_a_failure_not_an_error) {
    const test::Samples ball = test::sphere(50);
    test::Samples both = ball;
    const test::Samples inside = turned(ball);
    both.points.insert(both.points.end(), inside.points.begin(), inside.points.end());
    both.normals.insert(both.normals.end(), inside.normals.begin(), inside.normals.end());
    auto info = inspect(both);
    EXPECT_EQ(info.severity, HRBFNPR_SEVERITY_FAILURE);
    EXPECT_EQ(told.back().code, HRBFNPR_NOTE_NOT_USABLE);
    EXPECT_THAT(failures(), ElementsAre("all points come in pairs with opposite normals"));
    EXPECT_EQ(info.duplicates, 50);
    EXPECT_STREQ(info.up_reason, "");

    test::Samples nowhere = test::sphere(20);
    for (double& x : nowhere.points) x = nan;
    info = inspect(nowhere);
    EXPECT_EQ(info.points_not_finite, 20);
    EXPECT_THAT(failures(), ElementsAre("no point is finite"));

    test::Triangles line;
    line.face(line.add(0.0, 0.0, 0.0), line.add(1.0, 0.0, 0.0), line.add(2.0, 0.0, 0.0));
    info = inspect(line);
    EXPECT_EQ(info.degenerate_faces, 1);
    EXPECT_EQ(failures().size(), 1U);
    line.vertices[0] = nan;
    inspect(line);
    EXPECT_THAT(failures(), ElementsAre("every face has a corner that is not finite"));
}

TEST_F(InspectTest, A_mesh_has_facts) {
    const auto info = inspect(test::box(1.0, 2.0, 3.0, 2));
    EXPECT_EQ(info.kind, HRBFNPR_SOURCE_KIND_MESH);
    EXPECT_EQ(info.triangles, 48);
    EXPECT_EQ(info.closed, 1U);
    EXPECT_EQ(info.components, 1);
    EXPECT_NEAR(info.area, 22.0, 1e-12);
    EXPECT_NEAR(info.volume, 6.0, 1e-12);
    EXPECT_EQ(info.duplicates, 8 * 2 + 12);
    EXPECT_EQ(info.normals_look, HRBFNPR_NORMALS_LOOK_OUTWARD);
    EXPECT_EQ(info.severity, HRBFNPR_SEVERITY_NOTE);
    EXPECT_THAT(repairs(), ElementsAre("28 vertices joined with another at the same place"));
    EXPECT_THAT(warnings(), IsEmpty());
}

TEST_F(InspectTest, Faults_of_a_mesh_are_reported) {
    auto info = inspect(pipe());
    EXPECT_EQ(info.boundary_loops, 2);
    EXPECT_EQ(info.closed, 0U);
    EXPECT_THAT(warnings(), ElementsAre("the mesh is open: it has 2 borders of 48 edges"));
    EXPECT_THAT(advice(),
                ElementsAre("nothing, as small holes are closed and wide ones stay open; --close closes all"));

    const test::Triangles ball = test::icosphere(2);
    info = inspect(ball.turned());
    EXPECT_EQ(info.inside_out, 1U);
    EXPECT_EQ(info.normals_look, HRBFNPR_NORMALS_LOOK_OUTWARD); // This holds once the faces are turned.
    EXPECT_THAT(repairs(), ElementsAre("all faces turned, as the mesh is inside out"));
    EXPECT_THAT(warnings(), ElementsAre("the mesh is inside out"));

    info = inspect(ball.with(ball.moved(0.4, 0.0, 0.0, 0.0).turned()));
    EXPECT_EQ(info.components_inside_out, 1);
    EXPECT_THAT(warnings(), ElementsAre("1 of 2 parts are inside out or are cavities", "the mesh has 2 parts"));
}

TEST_F(InspectTest, Edges_of_many_faces_are_mended_where_solids_touch) {
    const test::Triangles box = test::box(1.0, 1.0, 1.0, 1);
    auto info = inspect(box.with(box.moved(1.0, 1.0, 1.0, 0.0)));
    EXPECT_EQ(info.nonmanifold_edges, 1);
    EXPECT_EQ(info.nonmanifold_left, 0);
    EXPECT_THAT(repairs(), Contains("1 edge of more than two triangles split where solids touch"));

    test::Triangles fan;
    const std::int32_t a = fan.add(0.0, 0.0, 0.0), b = fan.add(0.0, 0.0, 1.0);
    fan.face(a, b, fan.add(1.0, 0.0, 0.0));
    fan.face(a, b, fan.add(-1.0, 1.0, 0.0));
    fan.face(a, b, fan.add(-1.0, -1.0, 0.0));
    info = inspect(fan);
    EXPECT_EQ(info.nonmanifold_edges, 1);
    EXPECT_EQ(info.nonmanifold_left, 1);
    EXPECT_THAT(warnings(), Contains("1 edge has more than two triangles"));
}

TEST_F(InspectTest, The_noise_of_a_depth_image_is_reported) {
    const test::SeenDepths image = test::seen_depths(48, 36, {1e-3, 0.0, 1.0});
    auto source = test::made(hrbfnpr_picture_source_init);
    source.points = in(image.points);
    source.columns = image.columns;
    source.rows = image.rows;
    source.flags = HRBFNPR_SOURCE_IS_PHOTO;
    source.up[1] = -1.0;
    const auto info = inspect(source);
    EXPECT_EQ(info.points_not_finite, 6 * 4); // The camera did not see this corner.
    EXPECT_EQ(info.image_seen, 48 * 36 - 6 * 4);
    EXPECT_NEAR(info.image_noise / (info.image_depth * info.image_depth), 1e-3, 2.5e-4);
    EXPECT_STREQ(info.up_reason, "as in depth images");
    EXPECT_THAT(repairs(), Contains(StartsWith("depth image smoothed over ")));
    EXPECT_THAT(warnings(), IsEmpty());
}

TEST_F(InspectTest, Models_and_their_marks_have_bounds) {
    test::Check check;
    const test::Samples ball = test::sphere(60);
    auto fit = test::made(hrbfnpr_fit_desc_init);
    fit.points = in(ball.points);
    fit.normals = in(ball.normals);
    hrbfnpr_model* fitted = nullptr;
    check(hrbfnpr_model_fit(context.get(), &fit, nullptr, &fitted, check.error()));
    const test::Model model(fitted);
    auto source = test::made(hrbfnpr_picture_source_init);
    source.model = fitted;
    const auto info = inspect(source);
    EXPECT_EQ(info.kind, HRBFNPR_SOURCE_KIND_MODEL);
    EXPECT_EQ(info.points, 60);
    EXPECT_GT(info.diagonal, 3.0);
    EXPECT_EQ(info.severity, HRBFNPR_SEVERITY_INFO);

    auto layer = test::made(hrbfnpr_layer_desc_init);
    layer.budget = 50;
    auto generate = test::made(hrbfnpr_generate_desc_init);
    generate.layers = &layer;
    generate.layer_count = 1;
    hrbfnpr_point_set* made = nullptr;
    check(hrbfnpr_point_set_generate(context.get(), fitted, &generate, nullptr, &made, check.error()));
    const test::PointSet marks(made);
    source.model = nullptr;
    source.point_set = made;
    const auto of_marks = inspect(source);
    EXPECT_EQ(of_marks.kind, HRBFNPR_SOURCE_KIND_POINT_SET);
    EXPECT_EQ(of_marks.points, 50);
}

TEST_F(InspectTest, Invalid_calls_are_refused) {
    const test::Samples ball = test::sphere(100);
    const auto source = source_of(ball);
    auto info = test::made(hrbfnpr_source_info_init);
    hrbfnpr_error error;
    hrbfnpr_error_init(&error, sizeof error);
    const auto call = [&](hrbfnpr_context* in, const hrbfnpr_picture_source* of, std::uint32_t wording,
                          hrbfnpr_source_info* to, hrbfnpr_operation* operation = nullptr) {
        return hrbfnpr_source_inspect(in, of, wording, nullptr, nullptr, operation, to, &error);
    };
    EXPECT_EQ(call(nullptr, &source, 0, &info), HRBFNPR_STATUS_INVALID_ARGUMENT);
    EXPECT_EQ(call(context.get(), nullptr, 0, &info), HRBFNPR_STATUS_INVALID_ARGUMENT);
    EXPECT_EQ(call(context.get(), &source, 0, nullptr), HRBFNPR_STATUS_INVALID_ARGUMENT);
    EXPECT_EQ(call(context.get(), &source, 3, &info), HRBFNPR_STATUS_INVALID_ARGUMENT);
    EXPECT_STREQ(error.message, "wording is 3; it must be one of HRBFNPR_WORDING_* (0 to 2)");
    test::Triangles mesh = test::tetrahedron();
    mesh.triangles[0] = 4;
    const auto wrong = source_of(mesh);
    EXPECT_EQ(call(context.get(), &wrong, 0, &info), HRBFNPR_STATUS_INVALID_ARGUMENT);
    EXPECT_STREQ(error.message, "picture_source.triangles: face 0 names vertex 4, but there are only 4 vertices");
    const auto empty = test::made(hrbfnpr_picture_source_init);
    EXPECT_EQ(call(context.get(), &empty, 0, &info), HRBFNPR_STATUS_INVALID_ARGUMENT);

    hrbfnpr_operation* made = nullptr;
    ASSERT_EQ(hrbfnpr_operation_create(context.get(), &made, &error), HRBFNPR_STATUS_OK);
    const test::Operation operation(made);
    EXPECT_EQ(call(context.get(), &source, 0, &info, made), HRBFNPR_STATUS_OK);
    EXPECT_EQ(hrbfnpr_operation_progress(made), 1.0);
    hrbfnpr_operation_cancel(made);
    EXPECT_EQ(call(context.get(), &source, 0, &info, made), HRBFNPR_STATUS_CANCELLED);
}

} // namespace
} // namespace picture_tests::inspect_test
