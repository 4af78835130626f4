// SPDX-License-Identifier: MIT
#include "picture/points.h"

#include "picture/ends.h"
#include "picture/nearness.h"
#include "support/handles.h"
#include "support/samples.h"

#include "api/handles.h"
#include "base/random.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace picture_test::points_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

test::Context make_context() {
    hrbfnpr_context* context = nullptr;
    test::Check check;
    check(hrbfnpr_context_create(nullptr, &context, check.error()));
    return test::Context(context);
}

// Makes a call with options that are set before its first use.
class FitPoints : public testing::Test {
protected:
    test::Context context = make_context();
    Pool pool{context->runtime.memory};
    Report report{pool, HRBFNPR_WORDING_OPTIONS, nullptr, nullptr, *context, nullptr};
    hrbfnpr_picture_desc desc = defaults<hrbfnpr_picture_desc>(hrbfnpr_picture_desc_init);
    std::vector<hrbfnpr_change> changes;

    void change(const char* field, const char* value) {
        auto added = defaults<hrbfnpr_change>(hrbfnpr_change_init);
        added.field = field;
        added.value = value;
        changes.push_back(added);
    }

    // Calls f(call) and returns its result.
    template <class F>
    auto with_call(F&& f) {
        desc.changes = changes.data();
        desc.change_count = static_cast<std::int64_t>(changes.size());
        const Options options(desc, nullptr, pool);
        return f(Call{*context, options, report, pool});
    }

    // The surface, which may be empty, and its up direction.
    struct Fitted {
        Surface surface;
        glm::dvec3 up{0.0};
    };
    Fitted fit(Shape shape) {
        report.notes.clear();
        report.stages.clear();
        return with_call([&](const Call& call) {
            Fitted fitted;
            leave_out_unusable(call, shape);
            fitted.surface = fit_points(call, std::move(shape), fitted.up);
            return fitted;
        });
    }
    std::string refusal(Shape shape) {
        try {
            static_cast<void>(fit(std::move(shape)));
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), Status::invalid_argument);
            return error.what();
        }
        return "";
    }

    [[nodiscard]] std::vector<std::string> said(std::uint32_t severity) const {
        std::vector<std::string> texts;
        for (const Note& note : report.notes)
            if (note.severity == severity) texts.emplace_back(note.text);
        return texts;
    }
    [[nodiscard]] std::vector<std::string> notes() const { return said(HRBFNPR_SEVERITY_NOTE); }
    [[nodiscard]] std::vector<std::string> warnings() const { return said(HRBFNPR_SEVERITY_WARNING); }
    [[nodiscard]] std::string said_of(std::uint32_t stage) const {
        for (const FinishedStage& each : report.stages)
            if (each.stage == stage) return std::string(each.says);
        return "no such stage";
    }

    Shape shape_of(const test::Samples& samples, double sign = 1.0) {
        Shape shape(pool);
        for (std::size_t i = 0; i < samples.points.size(); i += 3) {
            shape.points.emplace_back(samples.points[i], samples.points[i + 1], samples.points[i + 2]);
            shape.normals.push_back(sign *
                                    glm::dvec3(samples.normals[i], samples.normals[i + 1], samples.normals[i + 2]));
        }
        return shape;
    }
    Shape ball(std::int64_t count = 250) { return shape_of(test::sphere(count)); }
    Shape without_normals(Shape shape) {
        shape.normals.clear();
        return shape;
    }
    // Returns the value of the implicit function at the origin, which is negative inside.
    static double value_at_origin(const Model& model) { return value_at(model, glm::dvec3(0.0)); }
    static double value_at(const Model& model, const glm::dvec3& place) {
        const std::array<double, 3> at{place.x, place.y, place.z};
        double value = 0.0;
        const hrbfnpr_array points{at.data(), 1, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        const hrbfnpr_array_out to{&value, 1, 0, HRBFNPR_SCALAR_FLOAT64, 1};
        picture::call([&](hrbfnpr_error* error) {
            return hrbfnpr_model_evaluate(model.get(), &points, &to, nullptr, nullptr, nullptr, error);
        });
        return value;
    }
};

TEST_F(FitPoints, CleanPointsWithNormalsGiveNoNotes) {
    const Fitted fitted = fit(ball());
    EXPECT_THAT(notes(), IsEmpty());
    EXPECT_THAT(warnings(), IsEmpty());
    EXPECT_EQ(said_of(HRBFNPR_STAGE_SAMPLE), "250 samples");
    EXPECT_EQ(said_of(HRBFNPR_STAGE_ORIENT), "normals point outward");
    EXPECT_EQ(said_of(HRBFNPR_STAGE_FIT), "250 centres, triharmonic, iterative; passes through all samples");
    EXPECT_EQ(said_of(HRBFNPR_STAGE_END), "the whole surface is kept");
    EXPECT_LT(value_at_origin(fitted.surface.model), 0.0);
    EXPECT_EQ(fitted.up, glm::dvec3(0.0, 1.0, 0.0));
    ASSERT_NE(fitted.surface.shape, nullptr);
    EXPECT_EQ(fitted.surface.shape->points.size(), 250U);
    EXPECT_FALSE(fitted.surface.mesh);
}

TEST_F(FitPoints, InwardNormalsAreTurned) {
    const Shape inward = shape_of(test::sphere(250), -1.0);
    EXPECT_LT(value_at_origin(fit(inward).surface.model), 0.0);
    EXPECT_THAT(notes(), ElementsAre("all normals pointed inward: they are turned (--normals keep leaves them)"));
    EXPECT_EQ(said_of(HRBFNPR_STAGE_ORIENT), "normals pointed inward: all turned");
    desc.normals = HRBFNPR_NORMALS_GIVEN;
    EXPECT_GT(value_at_origin(fit(inward).surface.model), 0.0);
    EXPECT_THAT(notes(), IsEmpty());
    EXPECT_EQ(said_of(HRBFNPR_STAGE_ORIENT), "normals kept");
    desc.flags = HRBFNPR_PICTURE_FLIP;
    EXPECT_LT(value_at_origin(fit(inward).surface.model), 0.0);
    EXPECT_EQ(said_of(HRBFNPR_STAGE_ORIENT), "no such stage") << "it is the user's own word";
}

TEST_F(FitPoints, MixedNormalsAreRepaired) {
    Shape mixed = ball(120);
    for (std::size_t i = 0; i < mixed.normals.size(); i += 7) mixed.normals[i] = -mixed.normals[i];
    EXPECT_LT(value_at_origin(fit(mixed).surface.model), 0.0);
    EXPECT_THAT(notes(), ElementsAre("normals repaired: 18 turned, 0 computed again (--normals "
                                     "keep leaves them)"));
    EXPECT_EQ(said_of(HRBFNPR_STAGE_ORIENT), "18 normals turned, 0 computed again; closed surface, confidence 1.00");
}

TEST_F(FitPoints, MissingNormalsAreMade) {
    const Fitted fitted = fit(without_normals(ball(120)));
    EXPECT_LT(value_at_origin(fitted.surface.model), 0.0);
    EXPECT_THAT(notes(), ElementsAre("the points have no normals: 120 are computed"));
    EXPECT_EQ(said_of(HRBFNPR_STAGE_ORIENT), "normals computed; closed surface, confidence 1.00");
    Shape zeros = ball(120);
    zeros.normals.assign(120, glm::dvec3(0.0, nan, 0.0));
    EXPECT_FALSE(has_normals(zeros));
    fit(zeros);
    EXPECT_THAT(notes(), ElementsAre("the points have no normals: 120 are computed"));
}

TEST_F(FitPoints, AnOpenSurfaceLooksToTheScanner) {
    Shape cap(pool);
    for (const glm::dvec3& p : ball(240).points)
        if (p.z > 0.4) cap.points.push_back(p);
    fit(cap);
    EXPECT_THAT(said_of(HRBFNPR_STAGE_END), testing::StartsWith("left out "));
    EXPECT_THAT(said_of(HRBFNPR_STAGE_END), HasSubstr("% of the diagonal beyond the points; --close keeps it"));
    desc.viewpoint[0] = desc.viewpoint[1] = 0.0;
    desc.viewpoint[2] = -30.0;
    const Fitted seen_from_below = fit(cap);
    EXPECT_GT(value_at_origin(seen_from_below.surface.model), 0.0);
    EXPECT_THAT(notes(), testing::Contains(HasSubstr("are computed, facing the scanner")));
    EXPECT_THAT(warnings(), IsEmpty());
    desc.flags = HRBFNPR_PICTURE_CLOSE;
    fit(cap);
    EXPECT_EQ(said_of(HRBFNPR_STAGE_END), "no such stage");
}

TEST_F(FitPoints, AnUnusedViewpointGivesAWarning) {
    desc.viewpoint[0] = desc.viewpoint[1] = desc.viewpoint[2] = 5.0;
    fit(ball());
    EXPECT_THAT(warnings(),
                ElementsAre("--viewpoint is ignored: there are normals already (--normals none computes new ones)"));
}

TEST_F(FitPoints, ATerrainThatLooksDownIsTurned) {
    Shape terrain(pool);
    for (int i = 0; i < 24; ++i)
        for (int j = 0; j < 20; ++j) {
            terrain.points.emplace_back(0.5 * i, 0.5 * j, 0.5 * std::sin(0.5 * i) * std::cos(0.4 * j));
            terrain.normals.emplace_back(0.5 * std::cos(0.5 * i) * std::cos(0.4 * j),
                                         -0.4 * std::sin(0.5 * i) * std::sin(0.4 * j), -1.0);
        }
    const Fitted fitted = fit(terrain);
    EXPECT_EQ(fitted.up, glm::dvec3(0.0, 0.0, 1.0));
    EXPECT_THAT(notes(), testing::Contains(
                             "the terrain faced down along z: its normals are turned (--normals keep leaves them)"));
    EXPECT_EQ(said_of(HRBFNPR_STAGE_ORIENT), "terrain that faced down: normals turned");
    ASSERT_FALSE(report.notes.empty());
    EXPECT_EQ(report.notes.front().code, static_cast<std::uint32_t>(HRBFNPR_NOTE_TERRAIN_TURNED));
    EXPECT_EQ(report.notes.front().figures[0], 2.0);
}

// ---- Samples

TEST_F(FitPoints, SamplesAreChosenFromManyPoints) {
    desc.flags = HRBFNPR_PICTURE_CLOSE; // The end of the surface is not looked for.
    fit(ball(5000));                    // The default uses fewer points.
    EXPECT_THAT(notes(), ElementsAre("4096 of 5000 points are used (--samples N changes this)"));
    desc.samples = 100; // They are chosen from 4000 random points.
    EXPECT_LT(value_at_origin(fit(ball(5000)).surface.model), 0.0);
    EXPECT_THAT(notes(), IsEmpty());
    EXPECT_EQ(said_of(HRBFNPR_STAGE_SAMPLE), "100 samples");
    desc.samples = 0;
    desc.maximum_centres = 60; // The fit chooses from all points.
    fit(ball(5000));
    EXPECT_EQ(said_of(HRBFNPR_STAGE_SAMPLE), "5000 samples");
    EXPECT_THAT(said_of(HRBFNPR_STAGE_FIT), testing::StartsWith("60 centres, "));
}

TEST_F(FitPoints, UnusablePointsAreLeftOut) {
    Shape shape = ball();
    shape.points[3].x = nan;
    shape.normals[5] = glm::dvec3(0.0);
    shape.normals[6].y = std::numeric_limits<double>::infinity();
    shape.points[8].z = -9999.0;
    fit(shape);
    EXPECT_THAT(notes(), ElementsAre("1 point left out, as the value -9999 marks missing data",
                                     "3 points left out: without a usable position or normal"));
    EXPECT_EQ(said_of(HRBFNPR_STAGE_SAMPLE), "246 samples");
    shape.points.assign(250, glm::dvec3(nan));
    EXPECT_EQ(refusal(shape), "no point has both a finite position and a normal that is not zero");
    EXPECT_NE(refusal(Shape(pool)), "");
    EXPECT_NE(refusal(without_normals(shape)), "");
}

TEST_F(FitPoints, NonFiniteFacesAreLeftOut) {
    Shape mesh = without_normals(ball(20));
    mesh.triangles = {{{0, 1, 2}, {1, 2, 3}, {4, 5, 6}}};
    mesh.points[0].x = nan;
    with_call([&](const Call& call) { leave_out_unusable(call, mesh); });
    EXPECT_EQ(mesh.triangles.size(), 2U);
    EXPECT_THAT(warnings(), ElementsAre("1 face left out, as a corner is not finite"));
    mesh.points[2] = mesh.points[5] = glm::dvec3(nan);
    EXPECT_THROW(with_call([&](const Call& call) { leave_out_unusable(call, mesh); }), Error);
    EXPECT_EQ(mesh.triangles.size(), 2U);
}

TEST_F(FitPoints, PlacesWithSeveralNormalsAreReported) {
    Shape shape = ball();
    shape.points.push_back(shape.points[7]);
    shape.normals.push_back(-shape.normals[7]);
    shape.points.push_back(shape.points[9]);
    shape.normals.push_back(glm::normalize(shape.normals[9] + glm::dvec3(0.0, 0.3, 0.2)));
    fit(shape);
    EXPECT_THAT(notes(), ElementsAre("1 place with several normals, as on a sharp edge: their mean is used"));
    EXPECT_THAT(warnings(), ElementsAre("1 place with opposite normals left out"));
    EXPECT_EQ(said_of(HRBFNPR_STAGE_SAMPLE), "252 samples");
    shape = ball(20);
    for (std::size_t i = 0; i < 20; ++i) {
        shape.points.push_back(shape.points[i]);
        shape.normals.push_back(-shape.normals[i]);
    }
    EXPECT_EQ(refusal(shape), "all points come in pairs with opposite normals");
}

TEST_F(FitPoints, PointsFarFromAllOthersAreLeftOut) {
    Shape shape = ball(500);
    shape.points.emplace_back(0.0, -20.0, 0.0);
    shape.normals.emplace_back(0.0, -1.0, 0.0);
    EXPECT_EQ(fit(shape).surface.shape->points.size(), 500U);
    EXPECT_THAT(notes(), ElementsAre("1 point far from all others left out (--outliers keep keeps them)"));
    change("fit.outliers", "keep");
    EXPECT_EQ(fit(shape).surface.shape->points.size(), 501U);
    EXPECT_THAT(notes(), testing::Not(testing::Contains(HasSubstr("far from all others"))));
}

// Dust in the box of a ball leaves the surface whole, with normals and without.
TEST_F(FitPoints, DustInTheBoxIsLeftOut) {
    for (const bool with_normals : {true, false}) {
        Shape dusty = ball(1200);
        for (std::uint64_t i = 0; i < 60; ++i) {
            const auto random = base::uniform4(3, i, base::Purpose::probe, 1);
            const glm::dvec3 place(2.0 * random[0] - 1.0, 2.0 * random[1] - 1.0, 2.0 * random[2] - 1.0);
            dusty.points.push_back(place);
            dusty.normals.push_back(glm::normalize(glm::dvec3(random[3] - 0.5, random[1] - 0.3, random[0] - 0.6)));
        }
        const Fitted fitted = fit(with_normals ? dusty : without_normals(dusty));
        EXPECT_THAT(notes(), testing::Contains(HasSubstr("far from all others left out"))) << with_normals;
        EXPECT_LE(fitted.surface.shape->points.size(), 1250U) << with_normals;
        EXPECT_LT(value_at(fitted.surface.model, {0.0, 0.0, 0.0}), 0.0) << with_normals;
        for (std::size_t i = 1200; i < dusty.points.size(); ++i) {
            const double off = glm::length(dusty.points[i]) - 1.0;
            if (std::abs(off) <= 0.4) continue;
            EXPECT_GT(value_at(fitted.surface.model, dusty.points[i]) * off, 0.0) << i;
        }
    }
}

// ---- The fit

TEST_F(FitPoints, NoiseIsSmoothed) {
    Shape noisy = ball(400);
    for (std::size_t i = 0; i < noisy.points.size(); ++i)
        noisy.points[i] *= 1.0 + 0.03 * std::sin(17.0 * static_cast<double>(i * i % 97));
    const char* const smooth = "the samples are noisy: the surface is smoothed (--regularization 0 keeps the noise)";
    fit(noisy);
    EXPECT_THAT(notes(), testing::Contains(smooth));
    EXPECT_THAT(said_of(HRBFNPR_STAGE_FIT), HasSubstr("; samples within "));
    change("fit.regularization", "0");
    fit(noisy);
    EXPECT_THAT(notes(), testing::Not(testing::Contains(smooth)));
    EXPECT_THAT(said_of(HRBFNPR_STAGE_FIT), HasSubstr("; passes through all samples"));
}

// The box of a closed surface contains the surface between few points.
TEST_F(FitPoints, TheBoxOfFewPointsHoldsTheSurface) {
    const Model model = fit(shape_of(test::even_torus(25))).surface.model;
    const hrbfnpr_model_info info = model_info_of(model);
    constexpr int cells = 24;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool high : {false, true})
            for (int k = 0; k < cells * cells; ++k) {
                glm::dvec3 place(0.0);
                const std::array<double, 3> share{high ? 1.0 : 0.0, (k % cells + 0.5) / cells,
                                                  (k / cells + 0.5) / cells};
                for (int c = 0; c < 3; ++c) {
                    const double margin = 0.05 * diagonal_of(info);
                    const double low = info.bounds_min[(axis + c) % 3] - margin;
                    const double top = info.bounds_max[(axis + c) % 3] + margin;
                    place[(axis + c) % 3] = low + share[static_cast<std::size_t>(c)] * (top - low);
                }
                EXPECT_GT(value_at(model, place), 0.0) << axis << ' ' << high << ' ' << k;
            }
}

TEST_F(FitPoints, FitOptionsAreApplied) {
    change("fit.kernel", "gaussian");
    change("fit.solver", "direct");
    change("fit.trim", "auto");
    desc.samples = 40;
    fit(ball());
    EXPECT_THAT(said_of(HRBFNPR_STAGE_FIT), testing::StartsWith("40 centres, gaussian, direct; "));
}

TEST_F(FitPoints, TooFewPointsGiveAWarning) {
    const auto told_of = [&](std::initializer_list<glm::dvec3> list, int times = 1) {
        Points points(&pool);
        for (int i = 0; i < times; ++i)
            for (const glm::dvec3& p : list) points.push_back(p * (1.0 + i));
        report.notes.clear();
        with_call([&](const Call& call) { tell_thin_evidence(call, points); });
        return warnings();
    };
    EXPECT_THAT(told_of({{1, 2, 3}}), ElementsAre("there is only one point: its plane is drawn"));
    EXPECT_THAT(told_of({{1, 2, 3}, {2, 2, 3}}),
                ElementsAre("there are only 2 points: the surface between them is a guess"));
    EXPECT_THAT(told_of({{1, 2, 3}}, 10), ElementsAre("all points lie on a line: the surface beside it is a guess"));
    EXPECT_THAT(told_of({{1, 2, 3}, {3, -1, 1}}, 10),
                ElementsAre("all points lie in a plane: the surface is flat and ends where they do"));
    EXPECT_THAT(told_of({{1, 2, 3}, {3, -1, 1}, {1, 0, 0}}, 5), IsEmpty());
    EXPECT_THAT(told_of({{nan, 2, 3}, {3, -1, 1}, {1, 0, 0}}, 5), IsEmpty());
}

// ---- The image of a depth camera

Shape depth_image(int columns, int rows, Pool& pool) {
    Shape shape(pool);
    shape.columns = columns;
    shape.rows = rows;
    shape.is_photo = true;
    shape.up = glm::dvec3(0.0, 1.0, 0.0);
    shape.viewpoint = glm::dvec3(0.0);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double x = (column - columns / 2) / 70.0;
            const double y = (row - rows / 2) / 70.0;
            const double noise = 3e-4 * std::sin(37.0 * (row * columns + column) * (row + 2.0));
            const double z = column < 3 ? nan : 1.0 / (1.0 / (3.0 + 0.4 * x) + noise);
            shape.points.emplace_back(x * z, y * z, z);
        }
    return shape;
}

TEST_F(FitPoints, ADepthImageIsSmoothed) {
    desc.samples = 120;
    const Fitted fitted = fit(depth_image(60, 40, pool));
    EXPECT_THAT(said_of(HRBFNPR_STAGE_SMOOTH), testing::StartsWith("2280 points in 60 x 40 pixels, smoothed over "));
    EXPECT_EQ(said_of(HRBFNPR_STAGE_SAMPLE), "120 samples");
    EXPECT_EQ(said_of(HRBFNPR_STAGE_ORIENT), "no such stage");
    EXPECT_THAT(notes(), testing::Contains(HasSubstr(": it is smoothed (--depth-smoothing 0 keeps it)")));
    EXPECT_EQ(fitted.up, glm::dvec3(0.0, 1.0, 0.0));
    EXPECT_GT(value_at_origin(fitted.surface.model), 0.0) << "the camera is outside";
    desc.depth_smoothing = 0.0;
    desc.viewpoint[0] = desc.viewpoint[1] = desc.viewpoint[2] = 1.0;
    fit(depth_image(60, 40, pool));
    EXPECT_THAT(notes(), testing::Contains(HasSubstr(": it is kept")));
    EXPECT_THAT(warnings(), testing::Contains("--viewpoint is ignored: the camera of the depth image is known"));
}

// ---- Nearness

TEST_F(FitPoints, DistancesAreWrittenInWords) {
    auto found = defaults<hrbfnpr_comparison>(hrbfnpr_comparison_init);
    found.surface_p99 = 0.002;
    found.surface_max = 0.02;
    found.mesh_p99 = 0.001;
    found.mesh_max = 0.0456;
    EXPECT_EQ(distances_in_words(found, 2.0, pool),
              "99% of surface and mesh are within 0.10% of the diagonal of each other, all within 2.28%");
    found.mesh_max = std::numeric_limits<double>::infinity();
    EXPECT_EQ(distances_in_words(found, 2.0, pool), "99% of surface and mesh are within 0.10% of the diagonal of each "
                                                    "other, but parts of the mesh have no surface near them");
    found.mesh_p99 = nan;
    EXPECT_EQ(distances_in_words(found, 2.0, pool), "parts of the mesh have no surface near them");
    found.surface_p99 = nan;
    EXPECT_EQ(distances_in_words(found, 2.0, pool), "no surface near the mesh");
    EXPECT_EQ(percent_of(nan, 1, pool), "nan%");
}

TEST_F(FitPoints, RepairedAndDoubtfulSamplesAreReported) {
    auto info = defaults<hrbfnpr_model_info>(hrbfnpr_model_info_init);
    info.samples = 1000;
    info.merged_samples = 1;
    info.near_duplicates = 2;
    info.outliers_found = info.outliers_dropped = 3;
    info.flipped_found = 9;
    info.flipped_repaired = 4;
    with_call([&](const Call& call) {
        tell_repaired_samples(call, info);
        tell_doubted_samples(call, info);
        info.outliers_found = 7; // The four that remain are too few for a warning.
        tell_doubted_samples(call, info);
    });
    EXPECT_THAT(notes(),
                ElementsAre("1 sample merged with another at the same place", "2 samples merged with a very near one",
                            "3 samples left out as strays", "4 samples with a flipped normal turned"));
    EXPECT_THAT(warnings(), ElementsAre("5 samples look as if their normals were flipped: --flipped-normals reorient "
                                        "turns them"));
}

} // namespace
} // namespace picture_test::points_test
