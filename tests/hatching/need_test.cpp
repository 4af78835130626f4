// SPDX-License-Identifier: MIT
// Tests lines without those that a still picture does not need.
#include "hatching/hatching.h"
#include "support/point_sets.h"
#include "support/runtime.h"

#include "geometry/point_grid.h"

#include <algorithm>

namespace hrbfnpr::hatching::need_test {
namespace {

using namespace marks;
using namespace test;

constexpr double separation = 0.03;

// Needs the marks with x above `least`.
class Beyond final : public Need {
public:
    explicit Beyond(double least) noexcept : least_(least) {}

    [[nodiscard]] bool may_show(const glm::dvec3& place, const glm::dvec3&, double reach) const noexcept override {
        return place.x + reach > least_;
    }
    [[nodiscard]] double share(const glm::dvec3& place, const glm::dvec3& normal,
                               double reach) const noexcept override {
        return may_show(place, normal, reach) ? 1.0 : 0.0;
    }

private:
    double least_;
};

Marks lines_on(const implicit::Implicit& surface, const Need* need) {
    Site site{runtime(), surface, 1e-6, 1};
    site.need = need;
    Seeds seeds(runtime().memory);
    seeds.position.push_back({1.4, 0.0, 0.0});
    Settings settings;
    settings.separation = separation;
    settings.field.diagonal = surface.diagonal();
    const HatchingField field(site, stipples::cover_surface(site, seeds, 0.1, 32768), settings);
    EXPECT_EQ(field.is_whole(), need == nullptr);
    Marks marks(runtime().memory);
    LayerReport report(runtime().memory);
    field.place_lines(site, settings, marks, report);
    EXPECT_EQ(report.step, separation);
    return marks;
}

TEST(NeededLines, LieWhereThoseOfAWholeSetLie) {
    const Torus torus;
    const Marks all = lines_on(torus, nullptr);
    const Beyond need(0.2);
    const Marks some = lines_on(torus, &need);
    EXPECT_EQ(all.whole, 0);
    EXPECT_NEAR(static_cast<double>(some.whole), static_cast<double>(all.count()),
                0.06 * static_cast<double>(all.count()));
    EXPECT_LT(some.count(), all.count() * 65 / 100);
    EXPECT_GT(*std::min_element(some.position.x.begin(), some.position.x.end()), 0.2 - 20.0 * separation);
    // Marks of the whole set have a line of the other set within half a step and a tenth of a separation.
    const double near = 0.5 * 0.4 * separation + 0.1 * separation;
    const geometry::PointGrid grid(some.position, near, base::Progress());
    std::int64_t needed = 0;
    std::int64_t found = 0;
    for (std::int64_t i = 0; i < all.count(); ++i) {
        if (all.position[i].x < 0.2) continue;
        ++needed;
        bool any = false;
        grid.around(all.position[i], [&](std::int64_t at) {
            any = any || glm::distance(some.position[grid.index(at)], all.position[i]) < near;
        });
        if (any) ++found;
    }
    EXPECT_GT(static_cast<double>(found), 0.98 * static_cast<double>(needed)) << needed;
}

TEST(NeededLines, AreNoneWhereNothingIsShown) {
    const Beyond need(9.0);
    const Marks none = lines_on(Torus(), &need);
    EXPECT_EQ(none.count(), 0);
    EXPECT_GT(none.whole, 10000);
}

} // namespace
} // namespace hrbfnpr::hatching::need_test
