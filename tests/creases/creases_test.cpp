// SPDX-License-Identifier: MIT
// Tests meshes that are cut at creases, and the creases of shapes whose true creases are known.
#include "curves/mesh_checks.h"
#include "curves/traced.h"
#include "features/line_set.h"
#include "support/sharp_shapes.h"

#include <cmath>
#include <functional>

namespace hrbfnpr::curves::creases_test {
namespace {

using namespace test;

base::Runtime& runtime() {
    static base::Runtime instance = with_threads(2);
    return instance;
}

std::unique_ptr<LineSet> line_set(const implicit::Implicit& shape, double side) {
    LineSetSettings settings;
    settings.side = side;
    return std::make_unique<LineSet>(runtime(), shape, std::make_unique<implicit::DifferencedShape>(shape), settings);
}

struct Measured {
    double length = 0.0, closed = 0.0;
    double off = 0.0; // the largest distance of the cubics from the true creases
    int count = 0, convex = 0;
    double least = 360.0, most = 0.0; // angles, in degrees
};

// distance() returns the distance of a point from the nearest true crease.
Measured measure(const Creases& creases, const std::function<double(const glm::dvec3&)>& distance) {
    Measured found;
    for (std::int64_t c = 0; c < creases.count(); ++c) {
        ++found.count;
        const std::int64_t first = creases.first[c];
        const std::int64_t count = creases.first[c + 1] - first;
        found.convex += creases.point[first + count / 2].angle() > 0.0 ? 1 : 0;
        const std::int64_t pieces = creases.closed[c] != 0 ? count : count - 1;
        for (std::int64_t k = 0; k < pieces; ++k) {
            const CreasePoint& a = creases.point[first + k];
            const CreasePoint& b = creases.point[first + (k + 1) % count];
            CurvePoint p, q;
            for (auto [to, from] : {std::pair(&p, &a), std::pair(&q, &b)}) {
                to->position = from->position;
                to->gradient = glm::normalize(from->left - glm::dot(from->left, from->tangent) * from->tangent);
                to->level_gradient = glm::cross(from->tangent, to->gradient);
            }
            const CubicPiece piece(p, q);
            for (int i = 0; i < 4; ++i) {
                found.length += glm::distance(piece.at(i / 4.0), piece.at((i + 1) / 4.0));
                found.off = std::max(found.off, distance(piece.at(i / 4.0)));
            }
            found.least = std::min(found.least, std::abs(a.angle()));
            found.most = std::max(found.most, std::abs(a.angle()));
        }
        found.closed += creases.closed[c];
    }
    return found;
}

// The distance of a point from the edges of a cube of half edge 1.
double off_cube(const glm::dvec3& p) {
    glm::dvec3 q = glm::abs(odd_turn() * p);
    double best = 1e9;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 on(1.0);
        on[axis] = std::min(1.0, q[axis]);
        best = std::min(best, glm::distance(q, on));
    }
    return best;
}

double off_ring(const glm::dvec3& p, double radius, double z) {
    return std::hypot(std::hypot(p.x, p.y) - radius, p.z - z);
}

void expect_whole(const LineSet& lines, double area) {
    const SurfaceMesh& mesh = lines.mesh();
    const test_checks::Measures found = test_checks::measure(mesh, lines.surface());
    EXPECT_EQ(found.bad_edges + found.bad_across, 0);
    EXPECT_LE(found.off, 1e-7);
    EXPECT_NEAR(found.area, area, 2e-3 * area);
    EXPECT_EQ(mesh.turned, 0);
    std::int64_t triangles = 0;
    for (const auto& part : lines.parts()) triangles += part->mesh.triangles();
    EXPECT_EQ(triangles, mesh.triangles());
}

TEST(Creases, ACubeHasTwelveStraightEdges) {
    const auto shape = sharp_cube();
    for (const double side : {0.3, 0.12, 0.05}) {
        const auto lines = line_set(*shape, side);
        expect_whole(*lines, 24.0);
        const Measured found = measure(lines->creases(), off_cube);
        EXPECT_EQ(found.count, 12) << side;
        EXPECT_EQ(found.convex, 12);
        EXPECT_NEAR(found.length, 24.0, 1e-7);
        EXPECT_LE(found.off, 1e-8);
        EXPECT_NEAR(found.least, 90.0, 1e-6);
        EXPECT_NEAR(found.most, 90.0, 1e-6);
        EXPECT_EQ(lines->parts().size(), 6);
        EXPECT_EQ(lines->border().curves.count(), 0);
    }
}

// The cube is aligned with the lattice.
TEST(Creases, AnAxisAlignedCubeHasTwelveEdges) {
    const auto shape = sharp_cube(glm::dmat3(1.0));
    const auto lines = line_set(*shape, 0.11);
    expect_whole(*lines, 24.0);
    EXPECT_EQ(lines->creases().count(), 12);
}

TEST(Creases, ABoredCubeHasTheRimsOfItsBore) {
    const auto shape = bored_cube();
    const auto lines = line_set(*shape, 0.1);
    const double pi = std::acos(-1.0);
    expect_whole(*lines, 24.0 - 2.0 * pi * 0.36 + 4.0 * pi * 0.6);
    const Measured found = measure(lines->creases(), [](const glm::dvec3& p) {
        const glm::dvec3 q = odd_turn() * p;
        return std::min(off_cube(p), off_ring(q, 0.6, q.z < 0.0 ? -1.0 : 1.0));
    });
    EXPECT_EQ(found.count, 14);
    EXPECT_EQ(found.closed, 2);
    EXPECT_EQ(found.convex, 14);
    EXPECT_NEAR(found.length, 24.0 + 4.0 * pi * 0.6, 1e-4);
    EXPECT_LE(found.off, 1e-5);
}

TEST(Creases, ASteppedShaftHasFourRings) {
    const auto shape = stepped_shaft();
    const auto lines = line_set(*shape, 0.07);
    const double pi = std::acos(-1.0);
    expect_whole(*lines, 2.0 * pi + 2.0 * pi + 2.0 * pi * 0.5 * 1.2);
    const Measured found = measure(lines->creases(), [](const glm::dvec3& p) {
        return std::min({off_ring(p, 1.0, -1.0), off_ring(p, 1.0, 0.0), off_ring(p, 0.5, 0.0), off_ring(p, 0.5, 1.2)});
    });
    EXPECT_EQ(found.count, 4);
    EXPECT_EQ(found.closed, 4);
    EXPECT_EQ(found.convex, 3);
    EXPECT_NEAR(found.length, 6.0 * pi, 2e-4);
    EXPECT_LE(found.off, 1e-5);
}

TEST(Creases, TwoBallsMeetInOneCircle) {
    for (const bool joined : {true, false}) {
        const auto shape = two_balls(joined);
        const auto lines = line_set(*shape, 0.08);
        const glm::dvec3 axis = glm::normalize(glm::dvec3(1.0, 0.1, 0.0));
        const glm::dvec3 middle(0.0, 0.05, 0.0);
        const double half = 0.5 * std::hypot(1.0, 0.1);
        const double radius = std::sqrt(1.0 - half * half);
        const Measured found = measure(lines->creases(), [&](const glm::dvec3& p) {
            const double along = glm::dot(p - middle, axis);
            return std::hypot(along, glm::length(p - middle - along * axis) - radius);
        });
        EXPECT_EQ(found.count, 1);
        EXPECT_EQ(found.closed, 1);
        EXPECT_EQ(found.convex, joined ? 0 : 1);
        EXPECT_LE(found.off, 1e-5);
        EXPECT_NEAR(found.least, found.most, 1e-5);
        EXPECT_EQ(lines->mesh().turned, 0);
    }
}

TEST(Creases, ACappedConeHasTwoRims) {
    const auto shape = capped_cone();
    const auto lines = line_set(*shape, 0.06);
    const Measured found = measure(lines->creases(), [](const glm::dvec3& p) {
        return std::min(off_ring(p, 1.0, -1.0), off_ring(p, 0.6 - 0.28, 0.7));
    });
    EXPECT_EQ(found.count, 2);
    EXPECT_EQ(found.convex, 2);
    EXPECT_LE(found.off, 1e-5);
}

// The crease along y exists at all angles, but is left out below a limit.
TEST(Creases, AnglesFadeAlongAWedge) {
    const auto shape = fading_wedge();
    const auto lines = line_set(*shape, 0.06);
    const Creases& creases = lines->creases();
    double longest = 0.0;
    for (std::int64_t i = 0; i < creases.point.size(); ++i) {
        const CreasePoint& p = creases.point[i];
        if (std::abs(p.position.x) > 1e-9 || std::hypot(p.position.y, p.position.z) > 0.95) continue;
        const double expected = 2.0 * glm::degrees(std::atan(0.5 * std::exp(-3.0 * (p.position.y + 1.0))));
        EXPECT_NEAR(p.angle(), expected, 1e-6) << p.position.y;
        longest = std::max(longest, p.position.y);
    }
    EXPECT_GT(longest, 0.8);
}

// Two overlapping boxes with four common face planes are one box, whichever of two equal faces is active.
TEST(Creases, CoplanarFacesHaveNoCreaseBetween) {
    const auto box = [](double low, double high) {
        return max_of({plane({1, 0, 0}, high), plane({-1, 0, 0}, -low), plane({0, 1, 0}, 0.7), plane({0, -1, 0}, 0.7),
                       plane({0, 0, 1}, 0.6), plane({0, 0, -1}, 0.6)});
    };
    const SharpShape shape(geometry::Bounds{{-1.0, -0.7, -0.6}, {1.5, 0.7, 0.6}},
                           min_of({box(-1.0, 0.5), box(0.1, 1.5)}));
    const auto lines = line_set(shape, 0.13);
    const Creases& creases = lines->creases();
    double length = 0.0;
    double flat = 0.0;
    for (std::int64_t c = 0; c < creases.count(); ++c)
        for (std::int64_t i = creases.first[c] + 1; i < creases.first[c + 1]; ++i) {
            const double step = glm::distance(creases.point[i].position, creases.point[i - 1].position);
            (std::abs(creases.point[i].angle()) > 1.0 ? length : flat) += step;
        }
    EXPECT_NEAR(length, 4.0 * (2.5 + 1.4 + 1.2), 1e-6);
    EXPECT_EQ(flat, 0.0);
}

// The five plates are thinner than the cells that the spacing asks for. Where these cells tear the plates, creases cut
// very many triangles, and the mesh is made again with smaller cells.
TEST(Creases, ThinWallsAreMeshedWithSmallerCells) {
    constexpr double thickness = 0.034;
    std::vector<Sharp> plates;
    for (int k = -2; k <= 2; ++k) {
        std::vector<Sharp> all = sides({0.5 * thickness, 1.0, 1.0});
        all[0] = plane({1.0, 0.0, 0.0}, 0.3 * k + 0.5 * thickness);
        all[1] = plane({-1.0, 0.0, 0.0}, -0.3 * k + 0.5 * thickness);
        for (Sharp& side : all) side = turned(side.field, odd_turn());
        plates.push_back(max_of(std::move(all)));
    }
    const SharpShape shape(cube(1.8), min_of(std::move(plates)));
    std::vector<double> seeds;
    for (int k = -2; k <= 2; ++k)
        for (const double side : {-0.5, 0.5}) {
            const glm::dvec3 p = glm::transpose(odd_turn()) * glm::dvec3(0.3 * k + side * thickness, 0.2, 0.3);
            seeds.insert(seeds.end(), {p.x, p.y, p.z});
        }
    LineSetSettings settings;
    settings.seeds = seeds;
    settings.spacing = 0.08;
    const LineSet lines(runtime(), shape, std::make_unique<implicit::DifferencedShape>(shape), settings);
    EXPECT_LT(lines.mesh().side, thickness);
    EXPECT_LT(lines.mesh().turned, 1e-3 * static_cast<double>(lines.mesh().triangles()));
    EXPECT_EQ(lines.mesh().missed_seeds, 0);
}

// Two sheets differ by at most 1 % of a cell, as parts of one patch do, and a third sheet goes through both. The steps
// between the two are not drawn.
TEST(Creases, TinyStepsBetweenSheetsHaveNoCrease) {
    const glm::dmat3 turn = odd_turn();
    const auto lower = turned(plane({0, 0, 1}, 0.0), turn);
    const auto upper = turned(plane({1e-3, 0, 1}, 0.0), turn);
    const auto wall = turned(plane({0.1, 1.0, 0.02}, 0.0), turn);
    const SharpShape shape(cube(1.0), min_of({Sharp(lower), max_of({Sharp(upper), Sharp(wall)})}));
    const auto lines = line_set(shape, 0.1);
    for (std::int64_t c = 0; c < lines->creases().count(); ++c)
        EXPECT_LT(std::abs(lines->creases().point[lines->creases().first[c]].angle()), 1.0) << c;
}

// The solid is below z = 0 and y = 0. Its top consists of two sheets, by default a hundredth of a cell apart: between x
// = -0.3 and 0.3 f changes from one sheet to the other, and equals neither.
class SeamedTop : public SharpShape {
public:
    explicit SeamedTop(double gap = 1e-3)
        : SharpShape(cube(1.0), max_of({plane({0, 0, 1}, 0.0), plane({0, 0, 1}, gap), plane({0, 1, 0}, 0.0)})),
          gap_(gap) {}

    [[nodiscard]] Field at(const glm::dvec3& p) const override {
        const Field wall = sheet_at(2, p);
        const double share = std::clamp((p.x + 0.3) / 0.6, 0.0, 1.0);
        Field top = sheet_at(0, p);
        top.value -= gap_ * share * share * (3.0 - 2.0 * share);
        if (share > 0.0 && share < 1.0) top.gradient.x = -gap_ * 6.0 * share * (1.0 - share) / 0.6;
        return top.value > wall.value ? top : wall;
    }
    void active(const implicit::PointBatch& points, std::int32_t* sheet) const override {
        for (std::int64_t i = 0; i < points.count; ++i) {
            const glm::dvec3 p(points.x[i], points.y[i], points.z[i]);
            const double wall = sheet_at(2, p).value;
            sheet[i] = wall > at(p).value - 1e-12 ? 2 : p.x + 0.1 * p.y < 0.02 ? 0 : 1;
        }
    }

private:
    double gap_;
};

TEST(Creases, ContinueThroughSeams) {
    const SeamedTop shape;
    for (const double side : {0.13, 0.1}) {
        const auto lines = line_set(shape, side);
        const Creases& creases = lines->creases();
        double length = 0.0;
        for (std::int64_t c = 0; c < creases.count(); ++c)
            for (std::int64_t i = creases.first[c] + 1; i < creases.first[c + 1]; ++i)
                if (std::abs(creases.point[i].angle()) > 1.0)
                    length += glm::distance(creases.point[i].position, creases.point[i - 1].position);
        const geometry::Bounds region = lines->mesh().region;
        EXPECT_NEAR(length, region.max.x - region.min.x, 2e-3) << side;
    }
}

// The two sheets are half a cell apart and meet nowhere, so smaller cells would not help and are not tried again and
// again.
TEST(Creases, SheetsThatNeverMeetAreNotRefined) {
    const auto near = line_set(SeamedTop(), 0.1);
    const auto apart = line_set(SeamedTop(0.05), 0.1);
    EXPECT_LT(static_cast<double>(apart->mesh().triangles()), 1.3 * static_cast<double>(near->mesh().triangles()));
}

// Beyond the inner corner of a notch, both sheets of an edge of the notch's floor are 0, and so is f, but no edge is
// there.
TEST(Creases, EndAtInnerCornersOfANotch) {
    const double slope = std::tan(glm::radians(30.0));
    const std::vector<glm::dvec2> outline{{-1.0, -1.0}, {1.0, -1.0}, {1.0, 0.05 + 0.9 * slope},
                                          {0.1, 0.05},  {0.1, 1.0},  {-1.0, 1.0}};
    const glm::dvec3 upper = glm::normalize(glm::dvec3(-slope, 1.0, 0.0));
    std::vector<Sharp> all = sides({1.0, 1.0, 0.6}, odd_turn());
    all.push_back(min_of({Sharp(turned(plane({1, 0, 0}, 0.1), odd_turn())),
                          Sharp(turned(plane(upper, glm::dot(upper, glm::dvec3(0.1, 0.05, 0.0))), odd_turn()))}));
    const SharpShape shape(cube(1.75), max_of(std::move(all)));
    const auto distance = [&](const glm::dvec3& place) {
        const glm::dvec3 p = odd_turn() * place;
        const glm::dvec2 q(p);
        double best = 1e9;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const glm::dvec2 along = outline[(i + 1) % outline.size()] - outline[i];
            const double share = std::clamp(glm::dot(q - outline[i], along) / glm::dot(along, along), 0.0, 1.0);
            best = std::min(best, std::hypot(glm::distance(q, outline[i] + share * along), std::abs(p.z) - 0.6));
            const double beyond = std::max(0.0, std::abs(p.z) - 0.6);
            best = std::min(best, std::hypot(glm::distance(q, outline[i]), beyond));
        }
        return best;
    };
    double length = 6.0 * 1.2;
    for (std::size_t i = 0; i < outline.size(); ++i)
        length += 2.0 * glm::distance(outline[i], outline[(i + 1) % outline.size()]);
    for (const double side : {0.3, 0.17, 0.11, 0.07}) {
        const auto lines = line_set(shape, side);
        const Measured found = measure(lines->creases(), distance);
        EXPECT_EQ(found.count, 18) << side;
        EXPECT_LE(found.off, 1e-7) << side;
        EXPECT_NEAR(found.length, length, 1e-6) << side;
    }
}

std::unique_ptr<LineSet> cut(const implicit::Implicit& shape, const glm::dvec3& plane, std::span<const double> levels) {
    LineRequest request;
    request.kind = LineKind::section;
    request.plane = plane;
    request.levels = levels;
    LineSetSettings settings;
    settings.side = 0.1;
    settings.lines = std::span(&request, 1);
    return std::make_unique<LineSet>(runtime(), shape, std::make_unique<implicit::DifferencedShape>(shape), settings);
}

// Returns the middles of the pieces that turn by more than 20 degrees, and expects them to be short, as corners are.
std::vector<glm::dvec3> corners_of(const Curves& curves) {
    std::vector<glm::dvec3> corners;
    for (std::int64_t c = 0; c < curves.count(); ++c)
        for (std::int64_t i = curves.first[c]; i < curves.first[c] + curves.pieces_of(c); ++i) {
            const CurvePoint& p = curves.point[i];
            const CurvePoint& q = curves.point[curves.next(c, i)];
            if (glm::dot(glm::normalize(p.direction()), glm::normalize(q.direction())) > std::cos(0.35)) continue;
            EXPECT_LE(glm::distance(p.position, q.position), 3e-5);
            corners.push_back(0.5 * (p.position + q.position));
        }
    return corners;
}

// The section of the cube is one polygon; the section of the bored cube also has a circle or an ellipse.
TEST(Creases, SectionsAreClosedAndHaveCorners) {
    const std::array<double, 2> levels{-0.33, 0.17};
    for (const bool bored : {false, true})
        for (const glm::dvec3& plane : {glm::dvec3(0.1, 0.2, 1.0), glm::dvec3(0.0, 0.0, 1.0)}) {
            const auto cube = sharp_cube(glm::dmat3(1.0));
            const auto tube = bored_cube(0.6, glm::dmat3(1.0));
            const auto lines = cut(bored ? *tube : *cube, plane, levels);
            const Curves& curves = lines->found()[0].lines.curves;
            ASSERT_EQ(curves.count(), bored ? 4 : 2);
            for (std::int64_t c = 0; c < curves.count(); ++c) EXPECT_EQ(curves.closed[c], 1) << c;
            const std::vector<glm::dvec3> corners = corners_of(curves);
            EXPECT_EQ(corners.size(), 8U) << bored;
            for (const glm::dvec3& p : corners) {
                EXPECT_LE(std::hypot(std::abs(p.x) - 1.0, std::abs(p.y) - 1.0), 2e-5);
                double off = 1e9;
                for (const double level : levels)
                    off = std::min(off, std::abs(glm::dot(glm::normalize(plane), p) - level));
                EXPECT_LE(off, 1e-10);
            }
        }
}

// The plane passes through the top and crosses the rim of the hole: the outline and the hole's part meet only there.
TEST(Creases, SectionsThroughRimsAreClosed) {
    const auto shape = bored_cube(0.6, glm::dmat3(1.0));
    const std::array<double, 1> levels{1.05};
    const auto lines = cut(*shape, {0.1, 0.2, 1.0}, levels);
    const Curves& curves = lines->found()[0].lines.curves;
    ASSERT_GE(curves.count(), 1);
    for (std::int64_t c = 0; c < curves.count(); ++c) EXPECT_EQ(curves.closed[c], 1) << c;
    for (const glm::dvec3& p : corners_of(curves))
        EXPECT_LE(std::min({off_ring(p, 0.6, 1.0), std::hypot(std::abs(p.x) - 1.0, std::abs(p.y) - 1.0),
                            std::hypot(std::abs(p.x) - 1.0, p.z - 1.0), std::hypot(std::abs(p.y) - 1.0, p.z - 1.0)}),
                  2e-5);
}

} // namespace
} // namespace hrbfnpr::curves::creases_test
