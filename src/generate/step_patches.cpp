// SPDX-License-Identifier: MIT
#include "base/random.h"
#include "generate/generate.h"
#include "generate/in_unit.h"
#include "generate/make_seeds.h"
#include "geometry/tangent_frame.h"

#include <algorithm>
#include <array>

namespace hrbfnpr::generate {
namespace {

// The seeds in a random order: patches are placed at different ones as long as there are some.
struct Ticket {
    std::uint64_t number;
    std::int64_t seed;
};

base::Array<Ticket> shuffled(const marks::Site& site, std::int64_t count) {
    base::Array<Ticket> tickets(site.memory(), count);
    for (std::int64_t i = 0; i < count; ++i) {
        const auto index = static_cast<std::uint64_t>(i);
        const base::Philox bits =
            base::philox(site.random_seed, {static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(index >> 32U),
                                            static_cast<std::uint32_t>(base::Purpose::patch), 0});
        tickets[i] = {static_cast<std::uint64_t>(bits[0]) << 32U | bits[1], i};
    }
    std::sort(tickets.begin(), tickets.end(), [](const Ticket& a, const Ticket& b) {
        return a.number != b.number ? a.number < b.number : a.seed < b.seed;
    });
    return tickets;
}

} // namespace

double step_patches(const base::Runtime& runtime, const implicit::Implicit& implicit, const SampleHint& samples,
                    const Settings& given, const base::OutView& corners, const base::Progress& progress) {
    const Settings settings = completed(given);
    check_request(implicit, settings);
    const InUnit in_unit(runtime, implicit, samples, settings);
    const marks::Site site = in_unit.site();
    const marks::Seeds seeds = make_seeds(site, in_unit.samples(), in_unit.settings(), progress);
    const double step = seeds.step;
    const base::Array<Ticket> order = shuffled(site, seeds.position.size());
    progress.update(1.0); // the last chance to cancel, before anything is written
    for (std::int64_t patch = 0; patch < corners.count; ++patch) {
        const std::int64_t seed = order[patch % order.size()].seed;
        const geometry::TangentFrame frame = geometry::stipple_frame(seeds.normal[seed]);
        // u x r = n: counter-clockwise seen from outside.
        constexpr std::array<std::array<double, 2>, 4> sides = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
        std::uint32_t component = 0;
        for (const auto& [along_u, along_r] : sides) {
            const glm::dvec3 corner = seeds.position[seed] + step * (along_u * frame.u + along_r * frame.r);
            for (int axis = 0; axis < 3; ++axis) corners.set(patch, component++, site.unit * corner[axis]);
        }
    }
    return site.unit * step;
}

} // namespace hrbfnpr::generate
