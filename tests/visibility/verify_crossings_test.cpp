// SPDX-License-Identifier: MIT
// Tests that true crossings of curves near each other stay.
#include "visibility/image_lines.h"

#include "stage.h"
#include "support/contour_shapes.h"

namespace hrbfnpr::visibility::verify_crossings_test {
namespace {

using namespace test_stage;

// Adds four crossings of consecutive pieces of a line, which do not cross.
void add_wrong_ones(const ImageLines& lines, base::Array<Crossing>& crossings) {
    for (std::int32_t p = 3, left = 4; left > 0; p += 7, --left) {
        while (lines.pieces[p].line != lines.pieces[p + 1].line) ++p;
        Crossing wrong{};
        wrong.far_piece = p;
        wrong.near_piece = p + 1;
        wrong.far_share = wrong.near_share = 0.5;
        wrong.gap = 0.1;
        crossings.push_back(wrong);
    }
}

TEST(VerifyCrossings, KeepsOnlyRealCrossings) {
    const base::Runtime runtime = test::with_threads(2);
    const test::Torus torus(1.0, 0.4);
    Stage stage;
    add(runtime, stage, torus, {1.4, 0.0, 0.0}, 0.1);
    std::int64_t true_ones = 0;
    for (int i = 0; i < 60; ++i) {
        const double angle = 0.6755 - 5e-6 * i; // swallowtails appear on the way
        Picture picture(runtime, stage, Eye::at({std::cos(angle), 0.013, std::sin(angle)}, 4.0, true));
        picture.find();
        const ImageLines& lines = picture.found->lines;
        base::Array<Crossing> crossings(runtime.memory);
        for (const Crossing& c : picture.found->crossings) {
            if (!(c.gap < 0.5)) continue;
            crossings.push_back(c);
            ++true_ones;
        }
        const std::int64_t right = crossings.size();
        add_wrong_ones(lines, crossings);
        EXPECT_EQ(verify_crossings(runtime, picture.subjects, lines, crossings), 4);
        ASSERT_EQ(crossings.size(), right);
        for (const Crossing& c : crossings) EXPECT_NE(c.change, 0);
    }
    EXPECT_GT(true_ones, 10);
}

// If pieces are long, both places may move to the end that the pieces share.
TEST(VerifyCrossings, RejectsFalseCrossingsOfLongPieces) {
    const base::Runtime runtime = test::with_threads(2);
    const test::Torus torus(1.0, 0.4);
    Stage stage;
    add(runtime, stage, torus, {1.4, 0.0, 0.0}, 0.6);
    for (int i = 0; i < 60; ++i) {
        const double angle = 0.2 + 0.015 * i;
        Picture picture(runtime, stage, Eye::at({std::cos(angle), 0.013, std::sin(angle)}, 4.0, true));
        picture.find();
        base::Array<Crossing> crossings(runtime.memory);
        add_wrong_ones(picture.found->lines, crossings);
        EXPECT_EQ(verify_crossings(runtime, picture.subjects, picture.found->lines, crossings), 4);
    }
}

} // namespace
} // namespace hrbfnpr::visibility::verify_crossings_test
