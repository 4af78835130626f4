// SPDX-License-Identifier: MIT
#include "picture/blank.h"
#include "picture/look.h"
#include "picture/report.h"
#include "support/handles.h"
#include "support/samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace hrbfnpr::picture::blank_test {
namespace {

// Draws a sphere with stipples, seen from `eye`.
struct BlankTest : testing::Test {
    BlankTest() {
        hrbfnpr_context* made = nullptr;
        test::Check check;
        check(hrbfnpr_context_create(nullptr, &made, check.error()));
        context.reset(made);
        layer.contours = 0;
        view.size = 200;
        view.margin = 0.05;
    }
    [[nodiscard]] PointSet marks(double outward) {
        test::Samples samples = test::sphere(300);
        for (double& part : samples.normals) part *= outward;
        auto fit = defaults<hrbfnpr_fit_desc>(hrbfnpr_fit_desc_init);
        fit.points = {samples.points.data(), samples.count(), 0, HRBFNPR_SCALAR_FLOAT64, 3};
        fit.normals = {samples.normals.data(), samples.count(), 0, HRBFNPR_SCALAR_FLOAT64, 3};
        fit.trim = HRBFNPR_TRIM_NEVER;
        const auto model = make<Model>([&](hrbfnpr_model** out, hrbfnpr_error* error) {
            return hrbfnpr_model_fit(context.get(), &fit, nullptr, out, error);
        });
        auto layer_desc = defaults<hrbfnpr_layer_desc>(hrbfnpr_layer_desc_init);
        layer_desc.budget = 2000;
        auto desc = defaults<hrbfnpr_generate_desc>(hrbfnpr_generate_desc_init);
        desc.layers = &layer_desc;
        desc.layer_count = 1;
        return make<PointSet>([&](hrbfnpr_point_set** out, hrbfnpr_error* error) {
            return hrbfnpr_point_set_generate(context.get(), model.get(), &desc, nullptr, out, error);
        });
    }
    // Returns the message in the words of a command line, or "" if enough can be seen.
    [[nodiscard]] std::string message(double outward = 1.0, bool is_flipped = false) {
        const PointSet set = marks(outward);
        style.layers = &layer;
        style.layer_count = 1;
        const hrbfnpr_camera camera = camera_for(view, bounds, positions_of(set, pool), false);
        const auto renderer = make<Renderer>([&](hrbfnpr_renderer** out, hrbfnpr_error* error) {
            return hrbfnpr_renderer_create(context.get(), out, error);
        });
        auto item = defaults<hrbfnpr_item>(hrbfnpr_item_init);
        item.point_set = set.get();
        item.style = &style;
        const auto drawing = make<Drawing>([&](hrbfnpr_drawing** out, hrbfnpr_error* error) {
            return hrbfnpr_renderer_draw(renderer.get(), &item, 1, 0, &camera, out, error);
        });
        const std::optional<double> ink = find_blank(drawing, camera, style, pool);
        if (!ink) return {};
        const Blank blank = why_blank(drawing, *ink, bounds, camera, style, is_flipped, pool);
        EXPECT_EQ(blank.marks, 2000);
        return std::string(in_words(blank.text, HRBFNPR_WORDING_OPTIONS, pool));
    }

    base::Memory memory;
    Pool pool{memory};
    test::Context context;
    View view;
    geometry::Bounds bounds{glm::dvec3(-1.0), glm::dvec3(1.0)};
    hrbfnpr_style style = defaults<hrbfnpr_style>(hrbfnpr_style_init);
    hrbfnpr_layer_style layer = defaults<hrbfnpr_layer_style>(hrbfnpr_layer_style_init);
};

TEST_F(BlankTest, ASphereIsNotBlank) {
    EXPECT_EQ(message(), "");
    const float pale[4] = {0.5F, 0.25F, 0.9F, 0.5F};
    std::copy(pale, pale + 4, style.paper);
    EXPECT_EQ(message(), "");
}

TEST_F(BlankTest, ACameraThatLooksAwayIsNamed) {
    view.eye = glm::dvec3(5, 0, 0);
    view.target = glm::dvec3(9, 0, 0);
    EXPECT_EQ(message(), "the picture would be blank: nothing is drawn. The camera looks away from the model or past "
                         "it: leave out --eye and --direction, or set --target in the model");
}

TEST_F(BlankTest, AModelOfOnePointIsNamed) {
    view.eye = glm::dvec3(5000, 0, 0);
    view.target = glm::dvec3(0.0);
    bounds = {glm::dvec3(0.0), glm::dvec3(0.0)};
    view.camera = camera_for(view, {glm::dvec3(-1.0), glm::dvec3(1.0)}, Points(&pool), false);
    EXPECT_EQ(message(), "the picture would be blank: nothing is drawn. All samples are at one point");
}

TEST_F(BlankTest, InkLikeThePaperIsNamed) {
    std::fill(layer.ink, layer.ink + 3, 1.0F);
    EXPECT_EQ(message(),
              "the picture would be blank: nothing is drawn. The ink has the colour of the paper, or is transparent");
}

TEST_F(BlankTest, ATooLightToneIsNamed) {
    style.light[0] = style.light[1] = 0.0F; // The light comes from the eye.
    style.light[2] = 1.0F;
    style.light_space = HRBFNPR_LIGHT_CAMERA;
    style.tone_rule = HRBFNPR_TONE_RULE_PUBLISHED;
    style.tone_exponent = 0.001;
    const std::string text = message();
    EXPECT_NE(text.find("The surface is too light for any mark: --tone none draws all marks, --light turns the light"),
              std::string::npos)
        << text;
}

TEST_F(BlankTest, InwardNormalsAreNamed) {
    for (const bool is_flipped : {false, true}) {
        const std::string text = message(-1.0, is_flipped);
        EXPECT_NE(text.find("marks that face the eye are hidden, as if normals pointed inward: "), std::string::npos)
            << text;
        const std::string advice = is_flipped ? ": leave out --flip" : ": --flip turns them";
        EXPECT_EQ(text.substr(text.size() - advice.size()), advice);
    }
}

TEST_F(BlankTest, AStyleWithoutMarksIsNamed) {
    layer.share = 0.0F;
    EXPECT_EQ(message(), "the picture would be blank: nothing is drawn. The model is too small in the picture, or the "
                         "style draws no marks: try --style contour-and-stipple");
}

} // namespace
} // namespace hrbfnpr::picture::blank_test
