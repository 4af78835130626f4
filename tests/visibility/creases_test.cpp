// SPDX-License-Identifier: MIT
// Tests which parts of contours and creases are visible on shapes with creases, by plain counts along lines of sight.
#include "features/line_set.h"
#include "stage.h"
#include "support/sharp_shapes.h"

namespace hrbfnpr::visibility::creases_test {
namespace {

using namespace test_stage;
using namespace test;

base::Runtime& runtime() {
    static base::Runtime instance = test::with_threads(2);
    return instance;
}

std::unique_ptr<curves::LineSet> line_set(const implicit::Implicit& shape, double side) {
    curves::LineSetSettings settings;
    settings.side = side;
    return std::make_unique<curves::LineSet>(runtime(), shape, std::make_unique<implicit::DifferencedShape>(shape),
                                             settings);
}

// A view of a shape with its contours, sheet by sheet, the creases that are contours, and the other creases.
class SharpScene {
public:
    SharpScene(const curves::LineSet& set, const Eye& eye)
        : set_(set), view_(eye.view()),
          parts_(curves::parts_in_view(runtime(), *set.surface().sheets(), set.creases(), view_)),
          picture(runtime(), Stage(), eye) {
        picture.occluders.push_back({&set.sheets(), &set.surface(), glm::dmat4(1.0), view_.eye});
        for (const auto& part : set.parts()) add_contours(*part);
        add(parts_.folds.curves, 2, nullptr);
        add(parts_.outside.curves, 0, nullptr);
        add(parts_.inside.curves, 0, nullptr);
        picture.find();
        picture.beside = 0.3;
    }
    [[nodiscard]] const curves::CreaseParts& parts() const noexcept { return parts_; }
    [[nodiscard]] const std::vector<std::unique_ptr<curves::Curves>>& contours() const noexcept { return curves_; }

    std::int64_t broken = 0;

private:
    void add(const curves::Curves& lines, std::int32_t sheets, const curves::Level* level) {
        if (lines.count() == 0) return;
        Subject subject;
        subject.curves = &lines;
        subject.level = level;
        subject.view = view_;
        subject.side = set_.mesh().side;
        subject.sheet_change = sheets;
        subject.joined = true;
        if (level == nullptr) subject.clearance = visibility_tuning.crease_clearance;
        picture.add(subject);
    }
    void add_contours(const curves::SheetSurface& part) {
        levels_.push_back(std::make_unique<curves::ContourLevel>(part.surface, view_));
        curves::TraceReport report;
        const curves::Curves traced = curves::trace(runtime(), *levels_.back(), part.mesh, {}, report);
        broken += report.broken + report.missed;
        curves_.push_back(std::make_unique<curves::Curves>(
            curves::with_cusps(runtime(), *levels_.back(), view_, traced, report.evaluations)));
        add(*curves_.back(), 2, levels_.back().get());
    }

    const curves::LineSet& set_;
    curves::View view_;
    curves::CreaseParts parts_;
    std::vector<std::unique_ptr<curves::ContourLevel>> levels_;
    std::vector<std::unique_ptr<curves::Curves>> curves_;

public:
    Picture picture;
};

// Returns the ends of open curves.
std::vector<glm::dvec3> ends_of(const curves::Curves& curves) {
    std::vector<glm::dvec3> ends;
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        if (curves.closed[c] != 0) continue;
        ends.push_back(curves.point[curves.first[c]].position);
        ends.push_back(curves.point[curves.first[c + 1] - 1].position);
    }
    return ends;
}

// Contours end at creases, and there a crease begins to be a contour. So each end is the end of another line, too.
void expect_joined(const SharpScene& sharp, double within) {
    std::vector<glm::dvec3> ends = ends_of(sharp.parts().folds.curves);
    for (const auto& curves : sharp.contours())
        for (const glm::dvec3& end : ends_of(*curves)) ends.push_back(end);
    for (std::size_t i = 0; i < ends.size(); ++i) {
        double nearest = 1e9;
        for (std::size_t k = 0; k < ends.size(); ++k)
            if (k != i) nearest = std::min(nearest, glm::distance(ends[i], ends[k]));
        EXPECT_LE(nearest, within) << ends[i].x << ' ' << ends[i].y << ' ' << ends[i].z;
    }
}

void look_at(const SharpShape& shape, double side, double distance, int places, int least) {
    const auto set = line_set(shape, side);
    int compared = 0;
    for (const Eye& eye : test::eyes(cube_directions(0.1), distance)) {
        SCOPED_TRACE(named(eye));
        const SharpScene sharp(*set, eye);
        EXPECT_EQ(sharp.broken, 0);
        compared += expect_right(sharp.picture, places);
        expect_joined(sharp, 1e-6);
    }
    EXPECT_GT(compared, least);
}

TEST(CreasesSeen, AreRightOnACube) { look_at(*sharp_cube(), 0.2, 5.0, 40, 1500); }
TEST(CreasesSeen, AreRightOnABoredCube) { look_at(*bored_cube(), 0.12, 5.0, 60, 2000); }
TEST(CreasesSeen, AreRightOnASteppedShaft) { look_at(*stepped_shaft(), 0.08, 5.0, 60, 2000); }
TEST(CreasesSeen, AreRightOnJoinedBalls) { look_at(*two_balls(true), 0.1, 5.0, 40, 1500); }
TEST(CreasesSeen, AreRightOnTheCommonPartOfBalls) { look_at(*two_balls(false), 0.1, 5.0, 40, 1500); }
TEST(CreasesSeen, AreRightOnACappedCone) { look_at(*capped_cone(), 0.1, 5.0, 40, 1500); }

// A random ball, cylinder or half-space. random_tree() unites, intersects and subtracts them.
FieldFunction random_leaf(std::uint64_t number) {
    const auto u = base::uniform4(7, number, base::Purpose::probe, 1);
    const auto v = base::uniform4(7, number, base::Purpose::probe, 2);
    const glm::dvec3 at = 1.2 * glm::dvec3(u[0] - 0.5, u[1] - 0.5, u[2] - 0.5);
    if (u[3] < 0.5) return sphere(at, 0.35 + 0.4 * v[0]);
    if (u[3] < 0.8) return turned(cylinder(0.25 + 0.3 * v[0], at), odd_turn());
    return plane(glm::dvec3(v[0] - 0.5, v[1] - 0.5, v[2] - 0.5), 0.4 * v[3]);
}
Sharp random_tree(std::uint64_t number, int depth) {
    if (depth == 0) return {random_leaf(number)};
    const double u = base::uniform4(7, number, base::Purpose::probe, 3)[0];
    Sharp a = random_tree(2 * number + 1, depth - 1);
    if (u < 0.25) return max_of({std::move(a), Sharp(without(random_leaf(2 * number + 2)))});
    Sharp b = random_tree(2 * number + 2, depth - 1);
    std::vector<Sharp> both;
    both.push_back(std::move(a));
    both.push_back(std::move(b));
    return u < 0.75 ? min_of(std::move(both)) : max_of(std::move(both));
}

TEST(CreasesSeen, AreRightOnRandomTrees) {
    int compared = 0;
    int wrong = 0;
    int unsaid = 0; // wrong ones on meshes that report no fault
    int doubtless = 0;
    std::int64_t lines = 0;
    std::int64_t settled = 0;
    std::int64_t broken = 0;
    int shapes = 0;
    for (std::uint64_t tree = 0; tree < 20; ++tree) {
        SCOPED_TRACE(tree);
        std::vector<Sharp> parts;
        parts.push_back(random_tree(1000 * (tree + 1), 3));
        parts.emplace_back(sphere(glm::dvec3(0.0), 1.3));
        const SharpShape shape(cube(1.3), max_of(std::move(parts)));
        std::unique_ptr<curves::LineSet> set;
        try {
            set = line_set(shape, 0.08);
        } catch (const Error&) {
            continue; // the shape is empty
        }
        ++shapes;
        const bool doubted = set->mesh().turned > 0 || set->mesh().missed_seeds > 0;
        for (const Eye& eye : {Eye::at({0.5, 0.7, 0.9}, 5.0, true), Eye::at({-0.8, 0.4, -0.3}, 5.0, false)}) {
            const SharpScene sharp(*set, eye);
            broken += sharp.broken;
            settled += sharp.picture.found->report.settled;
            lines += sharp.picture.found->report.lines;
            for (int i = 0; i < 40; ++i) {
                const Place place = sharp.picture.random_place(i);
                const std::optional<std::int32_t> sheets = sharp.picture.sheets_at(place);
                if (!sheets) continue;
                ++compared;
                const bool off = *sheets != sharp.picture.dense_count(place, 600) &&
                                 *sheets != sharp.picture.dense_count(place, 20000);
                wrong += off ? 1 : 0;
                unsaid += off && !doubted ? 1 : 0;
                doubtless += doubted ? 0 : 1;
            }
        }
    }
    // Parts smaller than a cell may be missed. Then the mesh reports turned triangles or missed seeds.
    EXPECT_GE(shapes, 15);
    EXPECT_GT(compared, 1000);
    EXPECT_EQ(broken, 0);
    EXPECT_LE(settled, lines / 50);
    EXPECT_LE(wrong, compared / 50);
    EXPECT_EQ(unsaid, 0);
    EXPECT_GT(doubtless, 200);
}

// A cube that is seen from a corner has nine edges around its three visible faces. Six of them are its outline.
TEST(CreasesSeen, ACubeFromACornerHasSixOutlineEdges) {
    const auto shape = sharp_cube(glm::dmat3(1.0));
    const auto set = line_set(*shape, 0.23);
    const SharpScene sharp(*set, Eye::at({1.0, 0.9, 1.1}, 6.0, true));
    EXPECT_EQ(sharp.parts().folds.curves.count(), 6);
    EXPECT_EQ(sharp.parts().outside.curves.count(), 3);
    EXPECT_EQ(sharp.parts().inside.curves.count(), 3);
    double seen = 0.0;
    double whole = 0.0;
    for (const Interval& part : sharp.picture.found->intervals) {
        whole += part.end_at - part.begin_at;
        seen += part.invisibility == 0 ? part.end_at - part.begin_at : 0.0;
        EXPECT_TRUE(part.invisibility == 0 || part.invisibility == 1); // hidden edges are behind one face
    }
    double nine = 0.0;
    for (std::int64_t l = 0; l < sharp.picture.found->lines.lines.size(); ++l)
        if (sharp.picture.found->lines.lines[l].subject < 2)
            nine += sharp.picture.lengths->total(sharp.picture.found->lines.lines[l]);
    EXPECT_NEAR(seen, nine, 1e-6);
    EXPECT_GT(whole, 1.2 * nine);
}

} // namespace
} // namespace hrbfnpr::visibility::creases_test
