// SPDX-License-Identifier: MIT
#include "picture/apart.h"

#include "mesh_shapes.h"
#include "planned_call.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace picture_tests::apart_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;
using testing::ElementsAre;
using testing::IsEmpty;

class PartGroups : public testing::Test {
protected:
    PlannedCall planned;

    std::optional<FaceGroups> groups(const test::Triangles& from) {
        return find_groups(mesh_of(*planned.context.get(), from), planned.pool);
    }
    FaceNumbers flaps(const test::Triangles& from) {
        return find_flaps(mesh_of(*planned.context.get(), from), planned.pool);
    }
    LostParts lost(const test::Triangles& from) {
        return find_lost_parts(mesh_of(*planned.context.get(), from), planned.pool);
    }
};

TEST_F(PartGroups, CrossingPartsBecomeGroups) {
    const std::int64_t faces = 528;
    const std::optional<FaceGroups> found = groups(pipe().with(pipe_across()));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->parts, 2);
    ASSERT_EQ(found->groups.size(), 2U);
    for (const FaceNumbers& group : found->groups) {
        EXPECT_EQ(group.size(), static_cast<std::size_t>(faces));
        EXPECT_TRUE(std::is_sorted(group.begin(), group.end()));
        EXPECT_EQ(group.front() < faces, group.back() < faces); // The group is a single pipe.
    }
    EXPECT_NE(found->groups[0].front(), found->groups[1].front());
}

TEST_F(PartGroups, DistantPartsShareAGroup) {
    const test::Triangles far = pipe().moved(1.0, 6.0, 0.0, 0.0);
    EXPECT_FALSE(groups(pipe().with(far)));
    const std::optional<FaceGroups> found = groups(pipe().with(pipe_across()).with(far));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->parts, 3);
    ASSERT_EQ(found->groups.size(), 2U);
    EXPECT_EQ(found->groups[0].size(), 1056U); // The larger group comes first.
    EXPECT_EQ(found->groups[1].size(), 528U);
}

TEST_F(PartGroups, SolidsStayTogether) {
    const test::Triangles solids = test::box(1, 1, 1, 4).with(test::box(1, 1, 1, 4).moved(1.0, 0.5, 0.5, 0.5));
    EXPECT_FALSE(groups(solids)); // Closed parts need no groups.
    const test::Triangles sheet = wall({-1, 0.4, -1}, {3, 0, 0}, {0, 0, 3});
    const std::optional<FaceGroups> found = groups(solids.with(sheet));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->parts, 2);
    ASSERT_EQ(found->groups.size(), 2U);
    EXPECT_EQ(found->groups[0].size(), 2U * 6U * 32U); // This group is larger by its area, 12 to 9.
    EXPECT_EQ(found->groups[1].front(), 2 * 6 * 32);
}

TEST_F(PartGroups, ACutThroughAPipeMakesNoGroups) {
    EXPECT_FALSE(groups(pipe().with(pipe().moved(1.0, 0.0, 3.002, 0.0)))); // The pipes continue each other.
    // A lid lies on the border of the pipe, but the border of the lid is elsewhere.
    const std::optional<FaceGroups> found = groups(pipe().with(wall({-1, 2.95, -1}, {0, 0, 2}, {2, 0, 0})));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->groups.size(), 2U);
}

TEST_F(PartGroups, WallsThatMeetInOneEdgeBecomeGroups) {
    const std::optional<FaceGroups> found = groups(wall({0, 0, 0}, {1, 0, 0}, {0, 1, 0})
                                                       .with(wall({0, 0, 0}, {-1, 0, 0}, {0, 1, 0}))
                                                       .with(wall({0, 0, 0}, {0, 0, 1}, {0, 1, 0})));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->parts, 3);
    EXPECT_EQ(found->groups.size(), 3U);
}

TEST_F(PartGroups, SkinsOfAWallBecomeGroups) {
    const test::Triangles skin = wall({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const std::optional<FaceGroups> found = groups(skin.with(skin.turned().moved(1.0, 0, 0, 0.002)));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->groups.size(), 2U);
    // A sheet that was cut and whose other half faces the other way is one surface.
    EXPECT_FALSE(groups(skin.with(skin.turned().moved(1.0, 1.002, 0, 0))));
}

TEST_F(PartGroups, TheNumberOfGroupsIsLimited) {
    test::Triangles many = wall({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 4);
    for (int i = 1; i < 10; ++i) many = many.with(wall({0, 0, 0.001 * i}, {1, 0, 0}, {0, 1, 0}, 4));
    // The walls are nearer to each other than a seam is wide, and all along their borders, so they count as one cut
    // plane.
    EXPECT_FALSE(groups(many));
    for (int i = 1; i < 10; ++i) many = many.with(wall({0.1 * i, -0.5, -0.5}, {0, 2, 0}, {0, 0, 1}, 4));
    const std::optional<FaceGroups> found = groups(many);
    ASSERT_TRUE(found);
    EXPECT_LE(found->groups.size(), 8U);
}

TEST_F(PartGroups, AFewFacesMakeNoGroups) {
    EXPECT_FALSE(groups(wall({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1)));
    EXPECT_FALSE(groups(test::tetrahedron()));
}

TEST_F(PartGroups, AFaceOnAnEdgeOfTwoOthersIsSetAside) {
    test::Triangles mesh = wall({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const std::int32_t top = mesh.add(0.49, 0.5, 0.004);
    mesh.face(84, 85, top);
    EXPECT_THAT(flaps(mesh), ElementsAre(288));
    EXPECT_FALSE(groups(mesh)); // The face is too small for a separate surface.
    // Each of three walls is a part, however few faces it has.
    const test::Triangles walls = wall({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1)
                                      .with(wall({0, 0, 0}, {-1, 0, 0}, {0, 1, 0}, 1))
                                      .with(wall({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1));
    EXPECT_THAT(flaps(walls), IsEmpty());
    EXPECT_THAT(flaps(test::icosphere(1)), IsEmpty());
}

TEST_F(PartGroups, ATinyDistantPartCountsAsLost) {
    test::Triangles mesh = pipe();
    const std::int32_t a = mesh.add(60, 0, 0), b = mesh.add(60, 0.1, 0), c = mesh.add(60, 0, 0.1);
    mesh.face(a, b, c);
    const LostParts found = lost(mesh);
    EXPECT_EQ(found.parts, 1);
    EXPECT_THAT(found.faces, ElementsAre(528));
    EXPECT_EQ(lost(pipe()).parts, 0);
    test::Triangles near = pipe(); // The face is not far enough away.
    const std::int32_t d = near.add(10, 0, 0), e = near.add(10, 0.1, 0), f = near.add(10, 0, 0.1);
    near.face(d, e, f);
    EXPECT_EQ(lost(near).parts, 0);
    EXPECT_EQ(lost(pipe().with(pipe().moved(1.0, 60.0, 0.0, 0.0))).parts, 0); // The second pipe is not small.
}

} // namespace
} // namespace picture_tests::apart_test
