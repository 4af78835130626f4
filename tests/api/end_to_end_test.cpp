// SPDX-License-Identifier: MIT
// Tests the way from samples to a picture, as a caller's program goes it.
#include "fixture.h"

namespace api_test::end_to_end_test {
namespace {

void expect_a_drawing(const std::vector<std::uint8_t>& pixels) {
    std::int64_t dark = 0;
    for (std::size_t i = 0; i < pixels.size(); i += 4) dark += pixels[i] < 128 ? 1 : 0;
    const auto all = static_cast<std::int64_t>(pixels.size() / 4);
    EXPECT_GT(dark, all / 100);
    EXPECT_LT(dark, all / 2);
    EXPECT_EQ(pixels[0], 255); // the corner is paper
    EXPECT_EQ(pixels[3], 255);
}

TEST(EndToEnd, SixSamplesOfASphereGiveADrawing) {
    const Context context = make_context();
    const Model model = fit(context, scenes::sphere_6());
    const PointSet set = generate(context, model, small_desc());
    expect_a_drawing(draw(make_renderer(context), set));
}

TEST(EndToEnd, ATorusGivesADrawing) {
    const Context context = make_context();
    const Model model = fit(context, scenes::torus(100));
    const PointSet set = generate(context, model, small_desc(HRBFNPR_DISTRIBUTION_PUBLISHED));
    expect_a_drawing(draw(make_renderer(context), set));
}

TEST(EndToEnd, ACustomFunctionGivesADrawing) {
    const Context context = make_context();
    Sphere sphere;
    {
        const Model model = custom_sphere(context, sphere);
        const PointSet set = generate(context, model, small_desc());
        expect_a_drawing(draw(make_renderer(context), set));
    }
    EXPECT_EQ(sphere.releases, 1);
}

} // namespace
} // namespace api_test::end_to_end_test
