// SPDX-License-Identifier: MIT
// Casts enough rays for the model to prepare itself. The reference is the march over sums of all centres, which is used
// if a bound on |grad f| is given.
#include "trimmed.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstring>
#include <random>

namespace api_test::many_rays_test {
namespace {

constexpr std::int64_t many = 4000;

struct Bundle {
    std::vector<double> origin, direction;

    void add(const glm::dvec3& from, const glm::dvec3& along) {
        origin.insert(origin.end(), {from.x, from.y, from.z});
        direction.insert(direction.end(), {along.x, along.y, along.z});
    }
    [[nodiscard]] std::size_t size() const { return origin.size() / 3; }
};

struct Hits {
    Hits(std::size_t rays, std::size_t room)
        : count(rays), status(rays), t(rays * room), position(3 * rays * room), normal(3 * rays * room),
          entering(rays * room) {}
    std::vector<std::uint32_t> count;
    std::vector<std::uint8_t> status;
    std::vector<double> t, position, normal;
    std::vector<std::uint8_t> entering;
};

Hits cast(const Model& model, const Bundle& bundle, const hrbfnpr_cast_desc& desc) {
    Error error;
    const auto room = static_cast<std::uint32_t>(desc.maximum_hits);
    Hits hits(bundle.size(), room);
    auto given = made(hrbfnpr_ray_hits_init);
    given.count = out(hits.count, 1);
    given.status = out(hits.status, 1);
    given.t = out(hits.t, room);
    given.position = out(hits.position, 3 * room);
    given.normal = out(hits.normal, 3 * room);
    given.entering = out(hits.entering, room);
    const hrbfnpr_array from = in(bundle.origin);
    const hrbfnpr_array along = in(bundle.direction);
    EXPECT_OK(hrbfnpr_model_cast_rays(model.get(), &from, &along, &desc, &given, nullptr, error));
    return hits;
}

hrbfnpr_cast_desc at_most(std::int32_t hits) {
    auto desc = made(hrbfnpr_cast_desc_init);
    desc.maximum_hits = hits;
    return desc;
}

glm::dvec3 unit_vector(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
}

// Rays from a sphere of radius 4 around the origin to places inside it.
Bundle random_rays(unsigned seed) {
    std::mt19937_64 random(seed);
    Bundle bundle;
    for (std::int64_t i = 0; i < many; ++i) {
        const glm::dvec3 from = 4.0 * unit_vector(random);
        bundle.add(from, 0.9 * unit_vector(random) - from);
    }
    return bundle;
}

// Tangents at samples, moved along the normal by 1e-6 to 1e-2 to either side.
Bundle grazing_rays(const scenes::Samples& samples, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> exponent(-6.0, -2.0);
    std::uniform_int_distribution<std::size_t> sample(0, samples.points.size() / 3 - 1);
    Bundle bundle;
    for (std::int64_t i = 0; i < many; ++i) {
        const std::size_t at = 3 * sample(random);
        const glm::dvec3 p(samples.points[at], samples.points[at + 1], samples.points[at + 2]);
        const glm::dvec3 n(samples.normals[at], samples.normals[at + 1], samples.normals[at + 2]);
        const glm::dvec3 along = glm::normalize(glm::cross(n, unit_vector(random)));
        const double lift = std::pow(10.0, exponent(random)) * (i % 2 == 0 ? 1.0 : -1.0);
        bundle.add(p + lift * n - 3.0 * along, along);
    }
    return bundle;
}

// Expects the hits of the march. Returns the number of hits.
std::int64_t expect_same(const Model& model, const Bundle& bundle, hrbfnpr_cast_desc desc) {
    Error error;
    const Hits hits = cast(model, bundle, desc);
    EXPECT_OK(hrbfnpr_model_lipschitz(model.get(), &desc.lipschitz, nullptr, error));
    const Hits wanted = cast(model, bundle, desc);
    EXPECT_EQ(hits.count, wanted.count);
    EXPECT_EQ(hits.status, wanted.status);
    EXPECT_EQ(hits.entering, wanted.entering);
    EXPECT_NE(hits.t, wanted.t) << "the rays were marched";
    auto info = made(hrbfnpr_model_info_init);
    EXPECT_OK(hrbfnpr_model_get_info(model.get(), &info, error));
    const double diagonal = std::hypot(info.bounds_max[0] - info.bounds_min[0], info.bounds_max[1] - info.bounds_min[1],
                                       info.bounds_max[2] - info.bounds_min[2]);
    const auto room = static_cast<std::size_t>(desc.maximum_hits);
    std::int64_t found = 0;
    for (std::size_t i = 0; i < bundle.size(); ++i)
        for (std::size_t h = i * room; h < i * room + std::min(hits.count[i], wanted.count[i]); ++h, ++found)
            for (std::size_t c = 3 * h; c < 3 * h + 3; ++c) {
                EXPECT_NEAR(hits.position[c], wanted.position[c], 2e-9 * diagonal) << i;
                EXPECT_NEAR(hits.normal[c], wanted.normal[c], 1e-6) << i;
            }
    return found;
}

TEST(ManyRays, HaveTheHitsOfTheMarch) {
    const Context context = make_context();
    const scenes::Samples samples = hrbfnpr::test::bumpy(1200);
    const Model model = fit(context, samples);
    EXPECT_GT(expect_same(model, random_rays(1), at_most(1)), many / 2);
    EXPECT_GT(expect_same(model, random_rays(2), at_most(4)), many);
    EXPECT_GT(expect_same(model, grazing_rays(samples, 3), at_most(1)), many / 3);
    EXPECT_GT(expect_same(model, grazing_rays(samples, 4), at_most(6)), many / 2);
}

TEST(ManyRays, FindAllHitsOfATorus) {
    const Context context = make_context();
    const scenes::Samples samples = scenes::torus(1500);
    const Model model = fit(context, samples);
    for (const std::int32_t room : {2, 3, 4, 5}) expect_same(model, random_rays(5), at_most(room));
    EXPECT_GT(expect_same(model, grazing_rays(samples, 6), at_most(5)), many / 2);
}

TEST(ManyRays, StayWithinTheirRange) {
    const Context context = make_context();
    const Model model = fit(context, scenes::torus(1500));
    hrbfnpr_cast_desc desc = at_most(4);
    for (const double t_min : {-1.0, 0.6, 0.8}) {
        desc.t_min = t_min;
        desc.t_max = 1.05;
        EXPECT_GT(expect_same(model, random_rays(7), desc), many / 4) << t_min;
    }
}

// Such rays lie in faces of the cells that divide the region, or nearly so.
TEST(ManyRays, MayBeParallelToTheAxes) {
    const Context context = make_context();
    const Model model = fit(context, hrbfnpr::test::bumpy(1200));
    Error error;
    auto info = made(hrbfnpr_model_info_init);
    EXPECT_OK(hrbfnpr_model_get_info(model.get(), &info, error));
    const glm::dvec3 low(info.bounds_min[0], info.bounds_min[1], info.bounds_min[2]);
    const glm::dvec3 size = glm::dvec3(info.bounds_max[0], info.bounds_max[1], info.bounds_max[2]) - low;
    const double margin = 0.05 * glm::length(size);
    const double width = (std::max({size.x, size.y, size.z}) + 2.0 * margin) / 16.0;
    Bundle bundle;
    for (int i = 0; i < 17; ++i)
        for (int j = 0; j < 17; ++j)
            for (const double slant : {0.0, 1e-17, -1e-17, 1e-15, 1e-13, -1e-11, -1e-9}) {
                const glm::dvec3 place = low - margin + width * glm::dvec3(i, j, -20);
                bundle.add(place, {slant, -slant, 1.0});
                bundle.add({place.y, place.z, place.x}, {slant, 1.0, slant});
            }
    EXPECT_GT(expect_same(model, bundle, at_most(3)), 1000);
}

// The bounds of second derivatives are coarse for samples with noise, where the surface is rough.
TEST(ManyRays, HaveTheHitsOfTheMarchOnARoughSurface) {
    const Context context = make_context();
    for (const double noise : {0.003, 0.02}) {
        const scenes::Samples samples = hrbfnpr::test::with_noise(hrbfnpr::test::bumpy(1200), noise);
        const Model model = fit_whole(context, samples);
        EXPECT_GT(expect_same(model, random_rays(8), at_most(4)), many) << noise;
        EXPECT_GT(expect_same(model, grazing_rays(samples, 9), at_most(4)), many / 2) << noise;
    }
}

TEST(ManyRays, EndWhereTheSurfaceWasTrimmed) {
    const Context context = make_context();
    const Model open = fit(context, zone(-0.9, 0.6));
    ASSERT_EQ(info_of(open).is_trimmed, 1U);
    EXPECT_GT(expect_same(open, random_rays(10), at_most(3)), many / 2);
}

TEST(ManyRays, KeepTheirBits) {
    const scenes::Samples samples = hrbfnpr::test::bumpy(1200);
    const Bundle bundle = random_rays(11);
    const Context one = make_context(1);
    const Context two = make_context(2);
    const Hits alone = cast(fit(one, samples), bundle, at_most(2));
    const Model model = fit(two, samples);
    const Hits both = cast(model, bundle, at_most(2));
    EXPECT_EQ(std::memcmp(alone.position.data(), both.position.data(), sizeof(double) * both.position.size()), 0);
    Bundle turned;
    for (std::size_t i = bundle.size(); i-- > 0;)
        turned.add({bundle.origin[3 * i], bundle.origin[3 * i + 1], bundle.origin[3 * i + 2]},
                   {bundle.direction[3 * i], bundle.direction[3 * i + 1], bundle.direction[3 * i + 2]});
    const Hits back = cast(model, turned, at_most(2));
    for (std::size_t i = 0; i < bundle.size(); ++i)
        for (std::size_t h = 0; h < 2; ++h) EXPECT_EQ(back.t[2 * (bundle.size() - 1 - i) + h], both.t[2 * i + h]);
}

} // namespace
} // namespace api_test::many_rays_test
