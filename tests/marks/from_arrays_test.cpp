// Ready-made marks: what is copied, what is filled in, what is refused.
#include "support/point_sets.h"

#include "geometry/tangent_frame.h"
#include "marks/from_arrays.h"

namespace hrbfnpr::marks {
namespace {

using namespace test;

struct Arrays {
    std::vector<double> position = {1, 0, 0, 0, 2, 0, 0, 0, 3, 1, 1, 1};
    std::vector<double> normal = {1, 0, 0, 0, 2, 0, 0, 0, 1, 1, 1, 1};
    std::vector<double> direction = {0, 1, 0, 0, 0.5, 2, 1, 0, 0, 1, -1, 0};
    std::vector<double> curvature = {1, 2, 0.5, 3, 4, 0.25, 0, 0, 0, -1, -2, 1};
    std::vector<double> rank = {0.0, 0.25, 0.5, 1.0};
    std::vector<double> level = {0, 1, 1, 2};
    std::vector<double> stroke = {7, 0, 7, 1, 9, 0, 9, 1};
    std::vector<double> width = {0.5, 1.0, 1.0, 0.25};

    [[nodiscard]] std::array<GroupArrays, group_count> views(std::size_t group = 1) const {
        std::array<GroupArrays, group_count> all;
        all[group] = {view(position), view(normal),   view(direction), view(curvature),
                      view(rank, 1),  view(level, 1), view(stroke, 2), view(width, 1)};
        return all;
    }
};

PointSet import(const std::array<GroupArrays, group_count>& arrays, std::uint64_t seed = 1) {
    return from_arrays(runtime(), arrays, seed);
}

TEST(FromArrays, CopiesAndNormalises) {
    const PointSet set = import(Arrays().views());
    const MarkGroup& marks = of(set, Group::curvature);
    ASSERT_EQ(marks.count(), 4);
    EXPECT_EQ(set.origin, glm::dvec3(0.5, 1.0, 1.5));
    EXPECT_EQ(set.bounds.max, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_EQ(position(set, Group::curvature, 1), glm::dvec3(0, 2, 0));
    EXPECT_EQ(vec(marks.normal, 1), glm::dvec3(0, 1, 0)) << "normalised";
    EXPECT_EQ(vec(marks.direction, 1), glm::dvec3(0, 0, 1)) << "made tangent and unit";
    EXPECT_EQ(vec(marks.curvature, 3), glm::dvec3(-1, -2, 1));
    EXPECT_EQ(marks.rank[1], 0.25F);
    EXPECT_LT(marks.rank[3], 1.0F) << "1 becomes the largest number below it";
    EXPECT_EQ(marks.level[3], 2);
    EXPECT_EQ(marks.stroke[6], 9U);
    EXPECT_EQ(marks.stroke[7], 1U);
    EXPECT_EQ(marks.width[3], 0.25F);
    EXPECT_EQ(marks.report.strokes, 2);
    EXPECT_EQ(marks.report.levels, 2);
    EXPECT_EQ(marks.report.level[1].placed, 2);
    EXPECT_GT(set.spacing, 0.0);
    EXPECT_EQ(of(set, Group::stipple).count(), 0);
}

TEST(FromArrays, FillsInWhatIsLeftEmpty) {
    std::array<GroupArrays, group_count> arrays = Arrays().views(0);
    const Arrays keep;
    arrays[0] = {};
    arrays[0].position = view(keep.position);
    arrays[0].normal = view(keep.normal);
    const PointSet set = import(arrays);
    const MarkGroup& marks = of(set, Group::stipple);
    ASSERT_EQ(marks.count(), 4);
    EXPECT_TRUE(marks.curvature.empty());
    EXPECT_TRUE(marks.width.empty());
    for (std::int64_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(glm::distance(vec(marks.direction, i), geometry::stipple_frame(vec(marks.normal, i)).u), 0.0, 1e-6);
        EXPECT_EQ(marks.level[i], 0);
        EXPECT_EQ(marks.stroke[2 * i], i);
        EXPECT_EQ(marks.stroke[2 * i + 1], 0U);
    }
    EXPECT_TRUE(same_bits(set, import(arrays)));
    EXPECT_FALSE(same_bits(set, import(arrays, 2))) << "random ranks depend on the seed";
}

TEST(FromArrays, ReadsOtherScalarsAndStrides) {
    const Arrays keep;
    std::array<GroupArrays, group_count> arrays = keep.views(2);
    std::vector<float> floats(16, -1.0F);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 3; ++k) floats[4 * i + k] = static_cast<float>(keep.position[3 * i + k]);
    arrays[2].position = {reinterpret_cast<const std::byte*>(floats.data() + 12), 4, -16, base::Scalar::float32, 3};
    const PointSet set = import(arrays);
    EXPECT_EQ(position(set, Group::combing, 0), glm::dvec3(1, 1, 1)) << "a negative stride reads backwards";
    EXPECT_EQ(position(set, Group::combing, 3), glm::dvec3(1, 0, 0));
}

TEST(FromArrays, RefusesWhatIsWrongAndNamesIt) {
    const auto refuse = [](std::initializer_list<const char*> words, auto&& change) {
        Arrays arrays;
        change(arrays);
        expect_error(Status::invalid_argument, words, [&] { (void)import(arrays.views()); });
    };
    const double nan = std::nan("");
    refuse({"group[1].position[2]", "finite"}, [&](Arrays& a) { a.position[7] = nan; });
    refuse({"group[1].position[0]", "a float cannot hold"}, [&](Arrays& a) { a.position[0] = 1e300; });
    refuse({"group[1].normal[1]", "finite"}, [&](Arrays& a) { a.normal[4] = INFINITY; });
    refuse({"group[1].normal[1]", "zero"}, [&](Arrays& a) { a.normal[4] = 0.0; });
    refuse({"group[1].direction[3]", "finite"}, [&](Arrays& a) { a.direction[9] = nan; });
    refuse({"group[1].direction[0]", "tangent"}, [&](Arrays& a) { a.direction[1] = 0.0; });
    refuse({"group[1].direction[2]", "tangent"}, [&](Arrays& a) {
        a.direction[6] = 0.0;
        a.direction[8] = 5.0;
    });
    refuse({"group[1].curvature[1]", "finite"}, [&](Arrays& a) { a.curvature[5] = nan; });
    refuse({"group[1].rank[2]", "[0,1)"}, [&](Arrays& a) { a.rank[2] = -0.1; });
    refuse({"group[1].rank[0]", "[0,1)"}, [&](Arrays& a) { a.rank[0] = nan; });
    refuse({"group[1].rank[3]", "[0,1)"}, [&](Arrays& a) { a.rank[3] = 1.5; });
    refuse({"group[1].normal has 3", "position has 4"}, [&](Arrays& a) { a.normal.resize(9); });
    refuse({"group[1].normal has 0", "every mark needs one"}, [&](Arrays& a) { a.normal.clear(); });
    refuse({"group[1].rank has 3", "leave it empty"}, [&](Arrays& a) { a.rank.pop_back(); });
    refuse({"group[1].stroke has 3"}, [&](Arrays& a) { a.stroke.resize(6); });
    refuse({"group[1].normal has 4", "position has 0"}, [&](Arrays& a) { a.position.clear(); });
    expect_error(Status::invalid_argument, {"no mark", "group[0].position"}, [] { (void)import({}); });
}

TEST(FromArrays, EveryAllocationMayFail) {
    struct Allocator {
        int left;
        static void* allocate(void* user, std::uint64_t size, std::uint64_t alignment) {
            if (static_cast<Allocator*>(user)->left-- <= 0) return nullptr;
            return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
        }
        static void deallocate(void* /*user*/, void* memory, std::uint64_t /*size*/, std::uint64_t /*alignment*/) {
            std::free(memory);
        }
    };
    const Arrays arrays;
    for (int k = 0;; ++k) {
        ASSERT_LT(k, 1000);
        Allocator allocator{k};
        const base::Runtime failing(Allocator::allocate, Allocator::deallocate, &allocator, base::Parallel(),
                                    base::InstructionSet::automatic, nullptr, nullptr);
        try {
            (void)from_arrays(failing, arrays.views(), 1);
            EXPECT_GT(k, 8);
            break;
        } catch (const Error& error) {
            ASSERT_EQ(error.status(), Status::out_of_memory);
            ASSERT_EQ(failing.memory.bytes_now(), 0);
        }
    }
}

// Spacing from positions alone: marks of a known area.
TEST(FromArrays, SpacingIsEstimatedFromThePositions) {
    for (const int n : {100, 600, 3000, 20000}) {
        Arrays arrays;
        arrays.position = spiral_seeds(n);
        arrays.normal = arrays.position;
        std::array<GroupArrays, group_count> views;
        views[0].position = view(arrays.position);
        views[0].normal = view(arrays.normal);
        const double expected = std::sqrt(4.0 * 3.14159265 / n);
        EXPECT_NEAR(import(views).spacing, expected, 0.15 * expected) << n;
    }
}

} // namespace
} // namespace hrbfnpr::marks
