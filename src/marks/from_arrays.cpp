#include "marks/from_arrays.h"

#include "geometry/tangent_frame.h"
#include "geometry/unit.h"
#include "marks/assemble.h"
#include "marks/size.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::marks {
namespace {

using base::InView;

long long number(std::int64_t i) noexcept { return static_cast<long long>(i); }

// So that its square is neither 0 nor infinite.
glm::dvec3 of_moderate_length(const glm::dvec3& v) noexcept {
    return v / geometry::unit_for(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}));
}

// Copies one group's arrays, checking every number; `group` is its number for messages.
class Importer {
public:
    Importer(const GroupArrays& arrays, int group, std::uint64_t random_seed, MarkGroup& marks)
        : arrays_(arrays), group_(group), random_seed_(random_seed), marks_(marks), count_(arrays.position.count) {}

    void positions(geometry::VecArray& result) const;
    void rest();
    void relative_positions(const geometry::VecArray& positions, const glm::dvec3& origin);

private:
    void check_count(const InView& view, const char* name, bool needed) const;
    [[nodiscard]] double finite(const InView& view, const char* name, std::int64_t i, std::uint32_t component) const;
    [[nodiscard]] glm::dvec3 vector(const InView& view, const char* name, std::int64_t i) const {
        return {finite(view, name, i, 0), finite(view, name, i, 1), finite(view, name, i, 2)};
    }
    [[nodiscard]] glm::dvec3 normal(std::int64_t i) const;
    [[nodiscard]] glm::dvec3 direction(std::int64_t i, const glm::dvec3& n) const;
    [[nodiscard]] float rank(std::int64_t i) const;
    [[nodiscard]] float width(std::int64_t i) const;
    void report();

    static void store(base::Array<float>& array, std::int64_t i, const glm::dvec3& v) noexcept {
        for (int axis = 0; axis < 3; ++axis) array[3 * i + axis] = static_cast<float>(v[axis]);
    }

    const GroupArrays& arrays_;
    int group_;
    std::uint64_t random_seed_;
    MarkGroup& marks_;
    std::int64_t count_;
};

void Importer::check_count(const InView& view, const char* name, bool needed) const {
    if (view.count == count_ || (view.empty() && !needed)) return;
    fail(Status::invalid_argument, "group[%d].%s has %lld elements and group[%d].position has %lld: %s", group_, name,
         number(view.count), group_, number(count_),
         needed ? "every mark needs one" : "give one for each mark or leave it empty");
}

double Importer::finite(const InView& view, const char* name, std::int64_t i, std::uint32_t component) const {
    const double value = view.get(i, component);
    if (!std::isfinite(value))
        fail(Status::invalid_argument, "group[%d].%s[%lld] is not finite", group_, name, number(i));
    // It would become infinite in the set.
    if (std::abs(value) > 3.4e38)
        fail(Status::invalid_argument, "group[%d].%s[%lld] is %g, which a float cannot hold: scale the marks", group_,
             name, number(i), value);
    return value;
}

glm::dvec3 Importer::normal(std::int64_t i) const {
    const glm::dvec3 n = of_moderate_length(vector(arrays_.normal, "normal", i));
    const double length = glm::length(n);
    if (!(length > 0.0) || !std::isfinite(length))
        fail(Status::invalid_argument, "group[%d].normal[%lld] is zero: every mark needs a normal", group_, number(i));
    return n / length;
}

// Made tangent: a stroke has no part along its normal.
glm::dvec3 Importer::direction(std::int64_t i, const glm::dvec3& n) const {
    if (arrays_.direction.empty()) return geometry::stipple_frame(n).u;
    const glm::dvec3 d = of_moderate_length(vector(arrays_.direction, "direction", i));
    const glm::dvec3 tangent = d - glm::dot(d, n) * n;
    const double length = glm::length(tangent);
    if (!(length > 1e-6 * glm::length(d)))
        fail(Status::invalid_argument, "group[%d].direction[%lld] is zero or along the normal: it must be tangent",
             group_, number(i));
    return tangent / length;
}

float Importer::rank(std::int64_t i) const {
    if (arrays_.rank.empty())
        return random_rank(random_seed_, static_cast<std::uint64_t>(i), static_cast<Group>(group_));
    const double u = arrays_.rank.get(i, 0);
    if (!(u >= 0.0 && u <= 1.0))
        fail(Status::invalid_argument, "group[%d].rank[%lld] is outside [0,1)", group_, number(i));
    return rank_of(u);
}

float Importer::width(std::int64_t i) const {
    const double width = arrays_.width.get(i, 0);
    const auto rounded = static_cast<float>(width);
    if (!(rounded > 0.0F && width <= 1.0))
        fail(Status::invalid_argument, "group[%d].width[%lld] is outside (0,1]", group_, number(i));
    return rounded;
}

void Importer::positions(geometry::VecArray& result) const {
    check_count(arrays_.normal, "normal", true);
    check_count(arrays_.direction, "direction", false);
    check_count(arrays_.curvature, "curvature", false);
    check_count(arrays_.rank, "rank", false);
    check_count(arrays_.level, "level", false);
    check_count(arrays_.stroke, "stroke", false);
    check_count(arrays_.width, "width", false);
    if (count_ > most_marks)
        fail(Status::invalid_argument, "group[%d].position has %lld elements, and %lld are the most", group_,
             number(count_), number(most_marks));
    result.resize(count_);
    for (std::int64_t i = 0; i < count_; ++i) result.set(i, vector(arrays_.position, "position", i));
}

void Importer::rest() {
    marks_.normal.resize(3 * count_);
    marks_.direction.resize(3 * count_);
    marks_.rank.resize(count_);
    marks_.level.resize(count_);
    marks_.stroke.resize(2 * count_);
    if (!arrays_.curvature.empty()) marks_.curvature.resize(3 * count_);
    if (!arrays_.width.empty()) marks_.width.resize(count_);
    for (std::int64_t i = 0; i < count_; ++i) {
        const glm::dvec3 n = normal(i);
        store(marks_.normal, i, n);
        store(marks_.direction, i, direction(i, n));
        if (!arrays_.curvature.empty()) store(marks_.curvature, i, vector(arrays_.curvature, "curvature", i));
        marks_.rank[i] = rank(i);
        if (!arrays_.width.empty()) marks_.width[i] = width(i);
        if (!arrays_.level.empty()) marks_.level[i] = static_cast<std::uint8_t>(arrays_.level.get(i, 0));
        const bool given = !arrays_.stroke.empty();
        marks_.stroke[2 * i] =
            given ? static_cast<std::uint32_t>(arrays_.stroke.get(i, 0)) : static_cast<std::uint32_t>(i);
        marks_.stroke[2 * i + 1] = given ? static_cast<std::uint32_t>(arrays_.stroke.get(i, 1)) : 0U;
    }
    report();
}

void Importer::report() {
    GroupReport& report = marks_.report;
    report.full_count = count_;
    for (const std::uint8_t level : marks_.level) {
        const int counted = std::min<int>(level, most_levels);
        report.levels = std::max(report.levels, counted);
        ++report.level[static_cast<std::size_t>(counted)].attempted;
        ++report.level[static_cast<std::size_t>(counted)].placed;
    }
    if (group_ == static_cast<int>(Group::stipple)) return;
    base::Array<std::uint32_t> strokes(marks_.stroke.memory(), count_);
    for (std::int64_t i = 0; i < count_; ++i) strokes[i] = marks_.stroke[2 * i];
    std::sort(strokes.begin(), strokes.end());
    report.strokes = std::unique(strokes.begin(), strokes.end()) - strokes.begin();
}

void Importer::relative_positions(const geometry::VecArray& positions, const glm::dvec3& origin) {
    marks_.position.resize(3 * count_);
    for (std::int64_t i = 0; i < count_; ++i) store(marks_.position, i, positions[i] - origin);
}

} // namespace

PointSet from_arrays(const base::Runtime& runtime, const std::array<GroupArrays, group_count>& arrays,
                     std::uint64_t random_seed) {
    PointSet set(runtime.memory);
    std::array<geometry::VecArray, group_count> positions = {
        geometry::VecArray(runtime.memory), geometry::VecArray(runtime.memory), geometry::VecArray(runtime.memory)};
    for (int group = 0; group < group_count; ++group) {
        const auto g = static_cast<std::size_t>(group);
        Importer importer(arrays[g], group, random_seed, set.group[g]);
        importer.positions(positions[g]);
        importer.rest();
    }
    if (positions[0].empty() && positions[1].empty() && positions[2].empty())
        fail(Status::invalid_argument, "there is no mark: give group[0].position and group[0].normal, or those of "
                                       "another group");
    const std::array<const geometry::VecArray*, group_count> all = {&positions[0], &positions[1], &positions[2]};
    measure(runtime, all, 0.0, set, {});
    if (const double side = set.bounds.longest_side(); side > 0.0) require_size("the marks are", side, "positions");
    for (int group = 0; group < group_count; ++group) {
        const auto g = static_cast<std::size_t>(group);
        Importer(arrays[g], group, random_seed, set.group[g]).relative_positions(positions[g], set.origin);
    }
    return set;
}

} // namespace hrbfnpr::marks
