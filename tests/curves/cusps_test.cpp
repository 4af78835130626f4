// SPDX-License-Identifier: MIT
// Tests contours of a torus and their cusps against those computed from its angles.
#include "curves/curve_changes.h"

#include "support/contour_shapes.h"
#include "traced.h"

#include <set>

namespace hrbfnpr::curves::cusps_test {
namespace {

using namespace test_traced;

constexpr double tau = 6.283185307179586;
constexpr double tube = 0.4;
constexpr int steps = 20000;

base::Runtime& runtime() {
    static base::Runtime instance = test::with_threads(2);
    return instance;
}

using Places = std::vector<glm::dvec3>;

// For each angle u along the ring, n . (p - c) = 0 is r + (R - out . c) cos v - c_z sin v = 0. For an orthographic view
// it is (out . d) cos v + d_z sin v = 0. Both have two solutions v, or none.
class TorusContour {
public:
    explicit TorusContour(const Eye& eye) : eye_(eye) {}

    // All closed curves of the contour.
    [[nodiscard]] std::vector<Places> curves() const {
        std::vector<Places> found;
        std::vector<double> ends = borders();
        if (ends.empty() && !(opening(0.0) >= 0.0)) return found;
        for (const int side : {-1, 1})
            if (ends.empty()) found.push_back(all_round(side));
        for (std::size_t i = 0; i < ends.size(); ++i) {
            const double next = i + 1 < ends.size() ? ends[i + 1] : ends[0] + tau;
            if (opening(0.5 * (ends[i] + next)) > 0.0) found.push_back(forth_and_back(ends[i], next));
        }
        return found;
    }

private:
    [[nodiscard]] static glm::dvec3 out(double u) { return {std::cos(u), std::sin(u), 0.0}; }
    // The line of sight to the centre of the tube, in the plane of angle u.
    [[nodiscard]] glm::dvec2 sight(double u) const {
        const glm::dvec3 v = eye_.perspective ? out(u) - eye_.place() : -eye_.back;
        return {glm::dot(v, out(u)), v.z};
    }
    // 1 minus the square of the cosine. It is negative where no contour exists.
    [[nodiscard]] double opening(double u) const {
        const double share = (eye_.perspective ? tube : 0.0) / glm::length(sight(u));
        return 1.0 - share * share;
    }
    [[nodiscard]] glm::dvec3 place(double u, int side) const {
        const double share = (eye_.perspective ? -tube : 0.0) / glm::length(sight(u));
        const double v = std::atan2(sight(u).y, sight(u).x) + side * std::acos(std::max(-1.0, share));
        return out(u) + tube * (std::cos(v) * out(u) + glm::dvec3(0.0, 0.0, std::sin(v)));
    }
    // The angles where contours begin or end, ascending.
    [[nodiscard]] std::vector<double> borders() const {
        std::vector<double> found;
        for (int i = 0; i < steps; ++i) {
            double a = tau * i / steps;
            double b = tau * (i + 1) / steps;
            if ((opening(a) < 0.0) == (opening(b) < 0.0)) continue;
            for (int k = 0; k < 60; ++k) {
                const double middle = 0.5 * (a + b);
                ((opening(middle) < 0.0) == (opening(a) < 0.0) ? a : b) = middle;
            }
            found.push_back(a);
        }
        return found;
    }
    [[nodiscard]] Places all_round(int side) const {
        Places found;
        for (int i = 0; i < steps; ++i) found.push_back(place(tau * i / steps, side));
        return found;
    }
    [[nodiscard]] Places forth_and_back(double from, double to) const {
        Places found;
        for (int i = 0; i < steps; ++i) {
            const double turn = tau * (i + 0.5) / steps;
            found.push_back(place(0.5 * (from + to) - 0.5 * (to - from) * std::cos(turn), turn < 0.5 * tau ? 1 : -1));
        }
        return found;
    }

    Eye eye_;
};

// The points where the image of a closed curve, on a sphere around the eye, turns back: two consecutive steps of the
// image point in opposite directions.
Places turning_places(const Eye& eye, const Places& curve) {
    const std::size_t n = curve.size();
    const auto seen = [&](std::size_t i) {
        const glm::dvec3 p = curve[i % n];
        return eye.perspective ? glm::normalize(p - eye.place()) : p - glm::dot(p, eye.back) * eye.back;
    };
    Places found;
    for (std::size_t i = 0; i < n; ++i)
        if (glm::dot(seen(i + 1) - seen(i), seen(i + 2) - seen(i + 1)) < 0.0) found.push_back(curve[(i + 1) % n]);
    return found;
}

double nearest(const Places& places, const glm::dvec3& p) {
    double least = HUGE_VAL;
    for (const glm::dvec3& place : places) least = std::min(least, glm::distance(place, p));
    return least;
}

// The distance to the nearest chord.
double nearest(const std::vector<Chord>& chords, const glm::dvec3& p) {
    double least = HUGE_VAL;
    for (const Chord& chord : chords) {
        const glm::dvec3 way = chord.way();
        const double share = std::clamp(glm::dot(p - chord.a, way) / glm::dot(way, way), 0.0, 1.0);
        least = std::min(least, glm::distance(chord.a + share * way, p));
    }
    return least;
}

class TorusCusps : public testing::Test {
protected:
    const test::Torus torus{1.0, tube};
    const Meshed meshed{runtime(), torus, {{1.0 + tube, 0.0, 0.0}}, 0.07};

    void compare_cusps(const Contours& found, const Places& cusps) {
        EXPECT_EQ(found.cusps(), static_cast<std::int64_t>(cusps.size()));
        for (std::int64_t i = 0; i < found.curves.point.size(); ++i) {
            if (found.curves.point[i].is_cusp == 0) continue;
            const CurvePoint& p = found.curves.point[i];
            EXPECT_LE(nearest(cusps, p.position), 2e-3);
            // The line of sight is tangent to the curve.
            const glm::dvec3 v = glm::normalize(found.view.sight(p.position));
            EXPECT_LE(glm::length(glm::cross(v, glm::normalize(p.direction()))), 1e-5);
        }
    }
    // Returns the number of cusps.
    std::int64_t compare(const Eye& eye) {
        SCOPED_TRACE(testing::Message() << (eye.perspective ? "perspective " : "orthographic ") << eye.back.x << ' '
                                        << eye.back.y << ' ' << eye.back.z);
        const Contours found(runtime(), meshed, eye.view());
        expect_sound(runtime(), meshed, found);
        const std::vector<Chord> chords = chords_of(found.curves);
        const std::vector<Places> known = TorusContour(eye).curves();
        EXPECT_EQ(found.curves.count(), static_cast<std::int64_t>(known.size()));
        Places cusps;
        for (const Places& curve : known) {
            const Places turns = turning_places(eye, curve);
            cusps.insert(cusps.end(), turns.begin(), turns.end());
            for (std::size_t i = 0; i < curve.size(); i += 40)
                EXPECT_LE(nearest(chords, curve[i]), 0.05 * meshed.mesh.side);
        }
        compare_cusps(found, cusps);
        return found.cusps();
    }
};

TEST_F(TorusCusps, LieAtTheirExactAngles) {
    std::int64_t all = 0;
    for (const Eye& eye : test::eyes(cube_directions(0.1), 4.0)) all += compare(eye);
    EXPECT_GT(all, 60);
}

// The eye is in the ring's hole, or beside it.
TEST_F(TorusCusps, AreFoundFromANearbyEye) {
    for (const glm::dvec3& towards : cube_directions(0.1)) {
        const double distance = std::abs(towards.z) > 0.5 ? 0.7 : 0.4;
        compare(Eye::at(towards, distance, true));
    }
}

// A part of the ring has no contour: one curve goes forth and back over the rest.
TEST_F(TorusCusps, AreFoundFromInsideTheTube) {
    const Eye eye = Eye::at({0.9, 0.1, 0.05}, 1.1, true);
    ASSERT_EQ(TorusContour(eye).curves().size(), 1U);
    compare(eye);
}

// The eye moves through views in which two cusps meet.
TEST_F(TorusCusps, AppearInPairs) {
    std::set<std::int64_t> numbers;
    for (int i = 0; i <= 60; ++i) {
        const double angle = 0.2 + 0.02 * i;
        numbers.insert(compare(Eye::at({std::cos(angle), 0.01, std::sin(angle)}, 4.0, i % 2 == 0)));
    }
    EXPECT_GT(numbers.size(), 1U);
    for (const std::int64_t cusps : numbers) EXPECT_EQ(cusps % 2, 0);
}

TEST(Cusps, AreAbsentOnConvexSurfaces) {
    const test::Ellipsoid ellipsoid({1.0, 0.5, 0.2});
    const Meshed meshed(runtime(), ellipsoid, {{1.0, 0.0, 0.0}}, 0.06);
    for (const Eye& eye : test::eyes(cube_directions(0.1), 1.3))
        EXPECT_EQ(Contours(runtime(), meshed, eye.view()).cusps(), 0);
}

TEST(Cusps, AreAbsentWithoutCurves) {
    const test::SquareSphere sphere;
    const ContourLevel level(sphere, {});
    Curves none(runtime().memory);
    std::int64_t evaluations = 0;
    const Curves found = with_cusps(runtime(), level, {}, none, evaluations);
    EXPECT_EQ(found.count(), 0);
    EXPECT_EQ(found.point.size(), 0);
    EXPECT_EQ(evaluations, 0);
}

} // namespace
} // namespace hrbfnpr::curves::cusps_test
