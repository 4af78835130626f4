// SPDX-License-Identifier: MIT
#include "marks/tone_normals.h"

#include "geometry/point_grid.h"
#include "surface/creased.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hrbfnpr::marks {
namespace {

constexpr double tone_reach = 2.0; // lengths
// So many marks within reach tell the average; of more some are left out.
constexpr double enough = 64.0;
// What leaves the tangent plane more steeply is another sheet.
constexpr double steepest_tone = 0.7;
constexpr std::int64_t marks_a_check = 256;

// Every n-th mark.
struct Sources {
    Sources(const Site& site, const Marks& marks, const base::Array<std::int32_t>& sheets, std::int64_t step)
        : position(site.memory(), (marks.count() + step - 1) / step), normal(site.memory(), position.size()),
          sheet(site.memory(), sheets.empty() ? 0 : position.size()) {
        for (std::int64_t i = 0; i < position.size(); ++i) {
            position.set(i, marks.position[i * step]);
            normal.set(i, marks.normal[i * step]);
            if (!sheets.empty()) sheet[i] = sheets[i * step];
        }
    }
    geometry::VecArray position, normal;
    base::Array<std::int32_t> sheet; // empty: there are no creases
};

class Softener {
public:
    Softener(const Sources& sources, double radius, const base::Progress& progress)
        : radius_(radius), grid_(sources.position, radius, progress),
          position_(grid_.in_order(sources.position, progress)), normal_(grid_.in_order(sources.normal, progress)),
          sheet_(sources.sheet) {}

    // The mark's own normal counts once, so that there is always one.  Most places are too far away: that first.
    [[nodiscard]] glm::dvec3 around(const glm::dvec3& place, const glm::dvec3& own, std::int32_t sheet) const {
        glm::dvec3 sum = own;
        grid_.around(place, [&](std::int64_t at) {
            const glm::dvec3 way = position_[at] - place;
            const double square = glm::dot(way, way);
            if (!(square < radius_ * radius_)) return;
            const glm::dvec3 normal = normal_[at];
            const double agree = glm::dot(own, normal);
            const double height = glm::dot(way, own);
            if (!(agree > 0.0) || height * height > steepest_tone * steepest_tone * square) return;
            if (!sheet_.empty() && surface::is_creased(sheet, sheet_[grid_.index(at)], own, normal)) return;
            const double near = 1.0 - square / (radius_ * radius_);
            sum += near * near * agree * normal;
        });
        return glm::normalize(sum);
    }

private:
    double radius_;
    geometry::PointGrid grid_;
    geometry::VecArray position_, normal_; // in the grid's order
    const base::Array<std::int32_t>& sheet_;
};

} // namespace

void soften_normals(const Site& site, const Marks& marks, double length, double spacing, base::Array<float>& result,
                    const base::Progress& progress) {
    const double radius = tone_reach * length;
    const double within = std::numbers::pi * radius * radius / (spacing * spacing);
    const auto step = static_cast<std::int64_t>(std::clamp(within / enough, 1.0, 1e6));
    const base::Array<std::int32_t> sheets =
        surface::sheets_at(site.runtime, site.implicit, marks.position, progress.part(0.0, 0.0));
    const Sources sources(site, marks, sheets, step);
    const Softener softener(sources, radius, progress);
    result.resize(3 * marks.count());
    site.runtime.parallel.for_chunks(marks.count(), chunk_size, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            if ((i - begin) % marks_a_check == 0) progress.check();
            const glm::dvec3 normal =
                softener.around(marks.position[i], marks.normal[i], sheets.empty() ? 0 : sheets[i]);
            for (int k = 0; k < 3; ++k) result[3 * i + k] = static_cast<float>(normal[k]);
        }
    });
}

} // namespace hrbfnpr::marks
