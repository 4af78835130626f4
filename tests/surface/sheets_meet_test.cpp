// SPDX-License-Identifier: MIT
#include "surface/sheets_meet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hrbfnpr::surface::sheets_meet_test {
namespace {

// A ball of radius 2 and the plane z = 1. Their values have rounding errors of up to `noise` in either direction.
class BallAndPlane final : public implicit::Sheets {
public:
    explicit BallAndPlane(double noise) : noise_(noise) {}

    [[nodiscard]] std::int32_t count() const noexcept override { return 2; }
    void active(const implicit::PointBatch& points, std::int32_t* sheet) const override {
        for (std::int64_t i = 0; i < points.count; ++i) sheet[i] = points.z[i] > 1.0 ? 1 : 0;
    }
    void evaluate(std::int32_t sheet, const implicit::PointBatch& points,
                  const implicit::FieldBatch& fields) const override {
        for (std::int64_t i = 0; i < points.count; ++i) {
            const glm::dvec3 p(points.x[i], points.y[i], points.z[i]);
            const double radius = glm::length(p);
            const double rounding = noise_ * std::sin(1e13 * (p.x + 2.0 * p.y + 3.0 * p.z));
            fields.value[i] = (sheet == 0 ? radius - 2.0 : p.z - 1.0) + rounding;
            const glm::dvec3 g = sheet == 0 ? p / radius : glm::dvec3(0.0, 0.0, 1.0);
            fields.gradient[0][i] = g.x;
            fields.gradient[1][i] = g.y;
            fields.gradient[2][i] = g.z;
        }
    }

private:
    double noise_;
};

MeetingPlace meet(double noise, double tolerance, double x = 1.6) {
    Meeting meeting;
    meeting.add(0);
    meeting.add(1);
    return find_meeting(BallAndPlane(noise), {meeting, {x, 0.3, 1.2}, 1.0}, tolerance);
}

TEST(SheetsMeet, WhereBothAreZero) {
    const MeetingPlace place = meet(0.0, 1e-12);
    ASSERT_TRUE(place.found);
    EXPECT_NEAR(place.position.z, 1.0, 1e-12);
    EXPECT_NEAR(glm::length(place.position), 2.0, 1e-12);
}

// Without this, creases of a machine part were missing around one of its sheets, whose rounding errors exceeded the
// tolerance.
TEST(SheetsMeet, WithinRoundingIfTheToleranceIsSmaller) {
    for (int i = 0; i < 20; ++i) { // some meet the tolerance by chance
        const MeetingPlace place = meet(2e-10, 1e-12, 1.5 + 0.01 * i);
        ASSERT_TRUE(place.found) << i;
        EXPECT_NEAR(place.position.z, 1.0, 1e-9);
        EXPECT_NEAR(glm::length(place.position), 2.0, 1e-9);
    }
    EXPECT_FALSE(meet(1e-3, 1e-12).found);
}

TEST(SheetsMeet, NowhereWithinReach) {
    Meeting meeting;
    meeting.add(0);
    meeting.add(1);
    EXPECT_FALSE(find_meeting(BallAndPlane(0.0), {meeting, {1.6, 0.3, 1.2}, 0.05}, 1e-12).found);
}

TEST(SheetsMeet, ManyAsOneByOne) {
    const BallAndPlane sheets(2e-10);
    std::vector<MeetingSearch> searches;
    for (int i = 0; i < 150; ++i) { // more than are searched for together; some fail
        MeetingSearch& search = searches.emplace_back();
        if (i % 7 != 0) search.meeting.add(1);
        search.meeting.add(0);
        search.from = {1.0 + 0.01 * i, 0.3 * std::sin(i), 0.9 + 0.002 * i};
        search.farthest = i % 5 == 0 ? 0.05 : 1.0;
    }
    std::vector<MeetingPlace> places(searches.size());
    find_meetings(sheets, searches, 1e-12, places.data());
    int found = 0;
    for (std::size_t i = 0; i < searches.size(); ++i) {
        const MeetingPlace alone = find_meeting(sheets, searches[i], 1e-12);
        EXPECT_EQ(places[i].found, alone.found) << i;
        EXPECT_EQ(places[i].position, alone.position) << i;
        EXPECT_EQ(places[i].gradient, alone.gradient) << i;
        found += alone.found ? 1 : 0;
    }
    EXPECT_GT(found, 100);
    EXPECT_LT(found, 150);
}

TEST(SheetsMeet, AnswersAreInTheOrderOfTheRequests) {
    const BallAndPlane sheets(0.0);
    std::vector<SheetRequest> requests;
    for (int i = 0; i < 500; ++i) requests.push_back({i % 3 == 0 ? 1 : 0, {0.1 * i, std::sin(i), 0.3 * std::cos(i)}});
    std::vector<SheetValue> answers(requests.size());
    sheets_at(sheets, requests, answers.data());
    for (std::size_t i = 0; i < requests.size(); ++i) {
        const SheetValue alone = sheet_at(sheets, requests[i].sheet, requests[i].place);
        EXPECT_EQ(answers[i].value, alone.value) << i;
        EXPECT_EQ(answers[i].gradient, alone.gradient) << i;
    }
}

} // namespace
} // namespace hrbfnpr::surface::sheets_meet_test
