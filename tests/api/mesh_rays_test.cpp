// SPDX-License-Identifier: MIT
// Casts rays on the mesh of a line set. The reference is the call without a line set.
#include "trimmed.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

namespace api_test::mesh_rays_test {
namespace {

using hrbfnpr::test::LineSet;

constexpr std::size_t rays = 3000;
constexpr std::size_t room = 6;

struct Bundle {
    std::vector<double> origin, direction;
};

struct Hits {
    std::vector<std::uint32_t> count = std::vector<std::uint32_t>(rays);
    std::vector<std::uint8_t> status = std::vector<std::uint8_t>(rays);
    std::vector<double> t = std::vector<double>(rays * room);
    std::vector<double> position = std::vector<double>(3 * rays * room);
    std::vector<double> normal = std::vector<double>(3 * rays * room);
    std::vector<std::uint8_t> entering = std::vector<std::uint8_t>(rays * room);

    // Returns the least |n . d| of a ray's hits.
    [[nodiscard]] double flattest(const Bundle& bundle, std::size_t ray) const {
        const double* const d = bundle.direction.data() + 3 * ray;
        double least = 1.0;
        for (std::size_t h = ray * room; h < ray * room + count[ray]; ++h) {
            const double* const n = normal.data() + 3 * h;
            least = std::min(least, std::abs(n[0] * d[0] + n[1] * d[1] + n[2] * d[2]) / std::hypot(d[0], d[1], d[2]));
        }
        return least;
    }
};

hrbfnpr_cast_desc at_most(std::size_t hits, const LineSet* lines = nullptr) {
    auto desc = made(hrbfnpr_cast_desc_init);
    desc.maximum_hits = static_cast<std::int32_t>(hits);
    if (lines != nullptr) desc.line_set = lines->get();
    return desc;
}

hrbfnpr_status try_cast(const Model& model, const Bundle& bundle, const hrbfnpr_cast_desc& desc, Hits& hits,
                        hrbfnpr_error* error) {
    const auto width = static_cast<std::uint32_t>(desc.maximum_hits);
    hits.t.resize(rays * width);
    hits.position.resize(3 * rays * width);
    hits.normal.resize(3 * rays * width);
    hits.entering.resize(rays * width);
    auto given = made(hrbfnpr_ray_hits_init);
    given.count = out(hits.count, 1);
    given.status = out(hits.status, 1);
    given.t = out(hits.t, width);
    given.position = out(hits.position, 3 * width);
    given.normal = out(hits.normal, 3 * width);
    given.entering = out(hits.entering, width);
    const hrbfnpr_array from = in(bundle.origin);
    const hrbfnpr_array along = in(bundle.direction);
    return hrbfnpr_model_cast_rays(model.get(), &from, &along, &desc, &given, nullptr, error);
}

Hits cast(const Model& model, const Bundle& bundle, const hrbfnpr_cast_desc& desc) {
    Error error;
    Hits hits;
    EXPECT_OK(try_cast(model, bundle, desc, hits, error));
    return hits;
}

// Rays from a sphere of radius 4 around the origin to places inside it.
Bundle random_rays(unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Bundle bundle;
    for (std::size_t i = 0; i < rays; ++i) {
        double from[3], to[3];
        for (double* const v : {from, to}) {
            for (int c = 0; c < 3; ++c) v[c] = normal(random);
            const double length = std::hypot(v[0], v[1], v[2]);
            for (int c = 0; c < 3; ++c) v[c] *= (v == from ? 4.0 : 0.9) / length;
        }
        for (int c = 0; c < 3; ++c) {
            bundle.origin.push_back(from[c]);
            bundle.direction.push_back(to[c] - from[c]);
        }
    }
    return bundle;
}

LineSet lined(const Context& context, const Model& model) {
    Error error;
    hrbfnpr_line_set* lines = nullptr;
    EXPECT_OK(hrbfnpr_line_set_create(context.get(), model.get(), nullptr, nullptr, &lines, error));
    return LineSet(lines);
}

hrbfnpr_line_set_info about(const LineSet& lines) {
    Error error;
    auto info = made(hrbfnpr_line_set_info_init);
    EXPECT_OK(hrbfnpr_line_set_get_info(lines.get(), &info, error));
    return info;
}

// Expects the hits of the call without a mesh, except for rays that touch the surface. Returns the number of hits.
std::size_t expect_same(const Bundle& bundle, const Hits& hits, const Hits& wanted, double near, double angle) {
    std::size_t found = 0, touching = 0;
    for (std::size_t i = 0; i < rays; ++i) {
        if (hits.count[i] != wanted.count[i]) {
            EXPECT_LT(std::min(hits.flattest(bundle, i), wanted.flattest(bundle, i)), 0.3) << i;
            ++touching;
            continue;
        }
        EXPECT_EQ(hits.status[i], wanted.status[i]);
        // The distance along the ray grows with the slope of the surface.
        const double slope = wanted.flattest(bundle, i);
        for (std::size_t h = i * room; h < i * room + hits.count[i]; ++h, ++found) {
            EXPECT_EQ(hits.entering[h], wanted.entering[h]);
            for (std::size_t c = 3 * h; c < 3 * h + 3; ++c) {
                EXPECT_NEAR(hits.position[c], wanted.position[c], near / slope) << i;
                EXPECT_NEAR(hits.normal[c], wanted.normal[c], slope > 0.1 ? angle : 2.0) << i;
            }
        }
    }
    EXPECT_LT(touching, rays / 100);
    return found;
}

TEST(MeshRays, HaveTheHitsOfTheSearch) {
    const Context context = make_context();
    Sphere sphere;
    const Model models[3] = {fit(context, hrbfnpr::test::bumpy(1200)), fit(context, scenes::torus(1500)),
                             custom_sphere(context, sphere)};
    for (const Model& model : models) {
        const LineSet lines = lined(context, model);
        const Bundle bundle = random_rays(1);
        const Hits wanted = cast(model, bundle, at_most(room));
        EXPECT_GT(expect_same(bundle, cast(model, bundle, at_most(room, &lines)), wanted, 1e-8, 1e-5), rays);
        auto on_mesh = at_most(room, &lines);
        on_mesh.refine = 0;
        const double side = about(lines).cell_size;
        const Hits rough = cast(model, bundle, on_mesh);
        EXPECT_GT(expect_same(bundle, rough, wanted, 2.0 * side * side, 0.2), rays);
        EXPECT_NE(rough.position, wanted.position);
    }
}

TEST(MeshRays, TheirMeshIsPartOfTheBytesOfTheLineSet) {
    const Context context = make_context();
    const Model model = fit(context, scenes::torus(1500));
    const LineSet lines = lined(context, model);
    const hrbfnpr_line_set_info before = about(lines);
    (void)cast(model, random_rays(5), at_most(room, &lines));
    const std::int64_t made_bytes = about(lines).bytes - before.bytes;
    EXPECT_GT(made_bytes, 12 * before.triangles);
    (void)cast(model, random_rays(6), at_most(room, &lines));
    EXPECT_EQ(about(lines).bytes - before.bytes, made_bytes);
}

TEST(MeshRays, EndAfterTheHitsThatAreWanted) {
    const Context context = make_context();
    const Model model = fit(context, scenes::torus(1500));
    const LineSet lines = lined(context, model);
    const Bundle bundle = random_rays(2);
    const Hits all = cast(model, bundle, at_most(room, &lines));
    for (const std::size_t most : {1U, 2U, 3U}) {
        const Hits some = cast(model, bundle, at_most(most, &lines));
        for (std::size_t i = 0; i < rays; ++i) {
            ASSERT_EQ(some.count[i], std::min<std::size_t>(most, all.count[i])) << i;
            const bool more = most > 1 && all.count[i] > most;
            EXPECT_EQ(some.status[i], more ? std::uint8_t{HRBFNPR_RAY_TRUNCATED} : all.status[i]);
            for (std::size_t h = 0; h < some.count[i]; ++h) EXPECT_EQ(some.t[i * most + h], all.t[i * room + h]);
        }
    }
}

TEST(MeshRays, StayWithinTheirRange) {
    const Context context = make_context();
    const Model model = fit(context, scenes::torus(1500));
    const LineSet lines = lined(context, model);
    const Bundle bundle = random_rays(3);
    for (const double t_min : {-1.0, 0.6, 0.8}) {
        hrbfnpr_cast_desc desc = at_most(room);
        desc.t_min = t_min;
        desc.t_max = 1.05;
        const Hits wanted = cast(model, bundle, desc);
        desc.line_set = lines.get();
        EXPECT_GT(expect_same(bundle, cast(model, bundle, desc), wanted, 1e-8, 1e-5), rays / 4) << t_min;
    }
}

TEST(MeshRays, EndWhereTheSurfaceWasTrimmed) {
    const Context context = make_context();
    const Model open = fit(context, zone(-0.9, 0.6));
    ASSERT_EQ(info_of(open).is_trimmed, 1U);
    const LineSet lines = lined(context, open);
    const Bundle bundle = random_rays(4);
    const Hits wanted = cast(open, bundle, at_most(room));
    const Hits hits = cast(open, bundle, at_most(room, &lines));
    std::size_t different = 0;
    for (std::size_t i = 0; i < rays; ++i) different += hits.count[i] != wanted.count[i] ? 1U : 0U;
    EXPECT_LT(different, rays / 100);
}

// The mesh has cells so large that many of its hits do not lead to the surface.
TEST(MeshRays, AreSearchedWithoutTheMeshWhereItIsCoarse) {
    Error error;
    const Context context = make_context();
    const Model model = fit(context, hrbfnpr::test::bumpy(1200));
    auto desc = made(hrbfnpr_line_set_desc_init);
    desc.cell_size = 0.5;
    hrbfnpr_line_set* raw = nullptr;
    ASSERT_OK(hrbfnpr_line_set_create(context.get(), model.get(), &desc, nullptr, &raw, error));
    const LineSet lines(raw);
    const Bundle bundle = random_rays(5);
    const Hits wanted = cast(model, bundle, at_most(room));
    const Hits hits = cast(model, bundle, at_most(room, &lines));
    for (std::size_t i = 0; i < rays; ++i) {
        if (hits.count[i] != wanted.count[i]) continue;
        const double slope = wanted.flattest(bundle, i);
        for (std::size_t h = i * room; h < i * room + hits.count[i]; ++h)
            EXPECT_NEAR(hits.position[3 * h], wanted.position[3 * h], 1e-8 / slope) << i;
    }
}

TEST(MeshRays, KeepTheirBits) {
    const Bundle bundle = random_rays(6);
    const auto with_threads = [&](int threads) {
        const Context context = make_context(threads);
        const Model model = fit(context, hrbfnpr::test::bumpy(1200));
        const LineSet lines = lined(context, model);
        return cast(model, bundle, at_most(room, &lines));
    };
    const Hits alone = with_threads(1);
    const Hits both = with_threads(2);
    EXPECT_EQ(alone.count, both.count);
    EXPECT_EQ(std::memcmp(alone.position.data(), both.position.data(), sizeof(double) * both.position.size()), 0);
    EXPECT_EQ(std::memcmp(alone.normal.data(), both.normal.data(), sizeof(double) * both.normal.size()), 0);
}

TEST(MeshRays, NeedALineSetOfTheirModel) {
    Error error;
    const Context context = make_context();
    const Model model = fit(context, hrbfnpr::test::bumpy(300));
    const Model other = fit(context, hrbfnpr::test::bumpy(300));
    const LineSet lines = lined(context, other);
    Hits hits;
    EXPECT_FAILS(try_cast(model, random_rays(7), at_most(1, &lines), hits, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "cast_desc.line_set was made for another model");
    auto desc = at_most(1);
    desc.refine = 2;
    EXPECT_FAILS(try_cast(model, random_rays(7), desc, hits, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "cast_desc.refine is 2");
}

} // namespace
} // namespace api_test::mesh_rays_test
