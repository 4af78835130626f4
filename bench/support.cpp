// SPDX-License-Identifier: MIT
// Trimmed surfaces: how much of the surface that a fit invents is removed, how much of the rest is lost, and how even
// borders are.
// --models=DIR: a folder of OBJ and PLY meshes instead of generated ones; --named=TEXT: only meshes with TEXT in the
// name.
#include "calls.h"
#include "near_points.h"
#include "read_meshes.h"
#include "timing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace {

using bench::Triangles;
using bench::Vec3;
using hrbfnpr::test::made;
using Named = std::pair<std::string, Triangles>;

struct Samples {
    explicit Samples(std::size_t count) : points(3 * count), normals(3 * count) {}
    std::vector<double> points, normals;
};

Samples sampled(const hrbfnpr_mesh* mesh, std::int64_t count, std::int64_t candidates) {
    scenes::Check check;
    Samples samples(static_cast<std::size_t>(count));
    auto desc = made(hrbfnpr_sample_desc_init);
    desc.candidates = candidates;
    const hrbfnpr_array_out to{samples.points.data(), count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    const hrbfnpr_array_out along{samples.normals.data(), count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    check(hrbfnpr_mesh_sample(mesh, &desc, &to, &along, nullptr, check.error()));
    return samples;
}

scenes::Model trimmed(const scenes::Model& model, const Samples* samples, double closest) {
    scenes::Check check;
    auto desc = made(hrbfnpr_trim_desc_init);
    if (samples != nullptr) {
        desc.points = bench::view(samples->points);
        desc.normals = bench::view(samples->normals);
    }
    if (closest > 0.0) desc.hole = desc.closest = 0.9 * closest;
    hrbfnpr_model* out = nullptr;
    check(hrbfnpr_model_trim(model.get(), &desc, nullptr, &out, check.error()));
    return scenes::Model(out);
}

// Returns whether the model has its surface at each place: a short ray along the normal hits it.
std::vector<bool> held(const scenes::Model& model, const std::vector<double>& places,
                       const std::vector<double>& normals, double reach) {
    scenes::Check check;
    std::vector<double> from(places.size()), way(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        from[i] = places[i] + reach * normals[i];
        way[i] = -normals[i];
    }
    std::vector<std::uint32_t> count(places.size() / 3);
    const auto rays = static_cast<std::int64_t>(count.size());
    const hrbfnpr_array origins = bench::view(from), directions = bench::view(way);
    auto desc = made(hrbfnpr_cast_desc_init);
    desc.t_max = 2.0 * reach;
    auto hits = made(hrbfnpr_ray_hits_init);
    hits.count = {count.data(), rays, 0, HRBFNPR_SCALAR_UINT32, 1};
    check(hrbfnpr_model_cast_rays(model.get(), &origins, &directions, &desc, &hits, nullptr, check.error()));
    std::vector<bool> result;
    for (const std::uint32_t n : count) result.push_back(n > 0);
    return result;
}

Samples stipples(hrbfnpr_context* context, const scenes::Model& model, std::int64_t budget) {
    scenes::Check check;
    const scenes::PointSet set =
        bench::generate(context, model.get(), hrbfnpr::test::one_layer(HRBFNPR_LAYER_KIND_STIPPLES, budget));
    auto info = made(hrbfnpr_point_set_info_init);
    check(hrbfnpr_point_set_get_info(set.get(), &info, check.error()));
    const auto copy = [&](std::uint32_t attribute, bool place) {
        hrbfnpr_array view{};
        check(hrbfnpr_point_set_view(set.get(), 0, attribute, &view, check.error()));
        const auto* const from = static_cast<const float*>(view.data);
        std::vector<double> to(3 * static_cast<std::size_t>(view.count));
        for (std::size_t i = 0; i < to.size(); ++i) to[i] = double{from[i]} + (place ? info.origin[i % 3] : 0.0);
        return to;
    };
    Samples marks(0);
    marks.points = copy(HRBFNPR_MARK_ATTRIBUTE_POSITION, true);
    marks.normals = copy(HRBFNPR_MARK_ATTRIBUTE_NORMAL, false);
    return marks;
}

struct Totals {
    double bad = 0.0, caught = 0.0, good = 0.0, lost = 0.0, worst = 0.0;
    double over = 0.0, lost_over = 0.0; // good places over the mesh, not beyond its border
    int fits = 0;
};

// Returns whether a place is beside the nearest of dense samples rather than over it: beyond the border of an open
// mesh.
bool is_beside(const bench::NearPoints& nearest, const Samples& truth, const double* p, double reach, double beside) {
    double least = 2.0 * reach;
    std::size_t at = 0;
    nearest.visit(p, reach, [&](std::size_t i, double distance) {
        if (distance < least) {
            least = distance;
            at = 3 * i;
        }
        return true;
    });
    double along = 0.0;
    for (std::size_t c = 0; c < 3; ++c) along += (p[c] - truth.points[at + c]) * truth.normals[at + c];
    return least * least - along * along > beside * beside;
}

// Fits even samples of a mesh, and trims the fit by dense samples.
void run_mesh(hrbfnpr_context* context, const Named& named, Totals& totals) {
    constexpr double off = 0.01; // diagonals
    constexpr std::int64_t dense = 60'000, truth = 300'000, marks = 20'000;
    scenes::Check check;
    auto desc = made(hrbfnpr_mesh_desc_init);
    desc.vertices = bench::view(named.second.vertices);
    desc.triangles = {named.second.triangles.data(), static_cast<std::int64_t>(named.second.faces()), 0,
                      HRBFNPR_SCALAR_INT32, 3};
    hrbfnpr_mesh* raw = nullptr;
    check(hrbfnpr_mesh_create(context, &desc, nullptr, &raw, check.error()));
    const hrbfnpr::test::Mesh mesh(raw);
    auto info = made(hrbfnpr_mesh_info_init);
    check(hrbfnpr_mesh_get_info(raw, &info, check.error()));
    Vec3 size{};
    for (std::size_t c = 0; c < 3; ++c) size[c] = info.bounds_max[c] - info.bounds_min[c];
    const double diagonal = bench::length(size);
    const Samples around = sampled(raw, dense, dense);
    const Samples dense_truth = sampled(raw, truth, truth);
    const bench::NearPoints nearest(dense_truth.points, 0.5 * off * diagonal);
    for (const std::int64_t count : {500, 1000, 4096}) {
        const Samples samples = sampled(raw, count, 0);
        const scenes::Model model = bench::fit(context, samples.points, samples.normals, HRBFNPR_TRIM_NEVER);
        scenes::Model ended;
        const double seconds = bench::seconds([&] { ended = trimmed(model, &around, off); });
        const Samples all = stipples(context, model, marks);
        const std::vector<bool> stays = held(ended, all.points, all.normals, 1e-4 * diagonal);
        Totals here;
        for (std::size_t i = 0; i < stays.size(); ++i) {
            const bool is_bad = !nearest.is_within(all.points.data() + 3 * i, off * diagonal);
            (is_bad ? here.bad : here.good) += 1.0;
            if (!stays[i]) (is_bad ? here.caught : here.lost) += 1.0;
            if (is_bad || (info.boundary_edges > 0 && is_beside(nearest, dense_truth, all.points.data() + 3 * i,
                                                                off * diagonal, 0.3 * off * diagonal)))
                continue;
            here.over += 1.0;
            here.lost_over += stays[i] ? 0.0 : 1.0;
        }
        const double lost = here.lost / std::max(here.good, 1.0);
        std::printf("%-20s %6lld %9.0f %9.4f %9.4f %9.4f %8.2f\n", named.first.c_str(), static_cast<long long>(count),
                    here.bad, here.bad > 0.0 ? here.caught / here.bad : 1.0, lost,
                    here.lost_over / std::max(here.over, 1.0), seconds);
        std::fflush(stdout);
        totals.bad += here.bad;
        totals.caught += here.caught;
        totals.good += here.good;
        totals.lost += here.lost;
        totals.over += here.over;
        totals.lost_over += here.lost_over;
        totals.worst = std::max(totals.worst, lost);
        ++totals.fits;
    }
}

// ---- Borders ----------------------------------------------------------------------------------

// Places of the unit sphere with x + z > 0, on a spiral or at random.
Samples half_sphere(int count, bool even) {
    Samples samples(0);
    std::uint64_t state = 7;
    const auto random = [&] {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state >> 11U) * 0x1p-53;
    };
    for (int i = 0; i < 2 * count; ++i) {
        const double z = even ? 1.0 - (2.0 * i + 1.0) / (2.0 * count) : 2.0 * random() - 1.0;
        const double turn = even ? 2.399963229728653 * i : 2.0 * std::numbers::pi * random();
        const double r = std::sqrt(1.0 - z * z);
        const Vec3 p{r * std::cos(turn), r * std::sin(turn), z};
        if (!(p[0] + p[2] > 0.0)) continue;
        samples.points.insert(samples.points.end(), p.begin(), p.end());
    }
    samples.normals = samples.points;
    return samples;
}

struct Border {
    double mean = 0.0, deviation = 0.0, farthest = 0.0; // beyond the true border, spacings
};

// Measures how far the surface goes beyond the true border, all around it.
Border border_of(const scenes::Model& model, double spacing) {
    constexpr int places = 720;
    constexpr int steps = 200;
    const double half = std::sqrt(0.5);
    std::vector<double> offsets;
    for (int i = 0; i < places; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / places;
        const Vec3 rim{half * std::cos(turn), std::sin(turn), -half * std::cos(turn)}; // across (1, 0, 1)
        std::vector<double> at, along;
        for (int k = 0; k < steps; ++k) {
            const double beyond = spacing * (-1.0 + 4.0 * k / steps);
            for (std::size_t c = 0; c < 3; ++c)
                at.push_back(std::cos(beyond) * rim[c] - std::sin(beyond) * (c == 1 ? 0.0 : half));
        }
        along = at;
        const std::vector<bool> there = held(model, at, along, 0.5 * spacing);
        int last = 0;
        while (last + 1 < steps && there[static_cast<std::size_t>(last) + 1]) ++last;
        offsets.push_back(-1.0 + 4.0 * last / steps);
    }
    Border border;
    for (const double x : offsets) border.mean += x / places;
    for (const double x : offsets) border.deviation += (x - border.mean) * (x - border.mean) / places;
    border.deviation = std::sqrt(border.deviation);
    border.farthest = *std::max_element(offsets.begin(), offsets.end());
    return border;
}

Border run_border(hrbfnpr_context* context, int count, bool even) {
    const Samples samples = half_sphere(count, even);
    const scenes::Model model =
        trimmed(bench::fit(context, samples.points, samples.normals, HRBFNPR_TRIM_NEVER), nullptr, 0.0);
    const double spacing = std::sqrt(2.0 * std::numbers::pi / count);
    const Border border = border_of(model, spacing);
    std::printf("%6d %-6s samples: %.2f spacings beyond, deviation %.2f, at most %.2f\n", count,
                even ? "even" : "random", border.mean, border.deviation, border.farthest);
    return border;
}

} // namespace

int main(int argc, char** argv) {
    try {
        const scenes::Context context = bench::make_context(2);
        std::printf("the border of half a sphere\n");
        Border even, random;
        for (const int count : {300, 1000, 3000}) {
            const Border e = run_border(context.get(), count, true), r = run_border(context.get(), count, false);
            even = {std::max(even.mean, e.mean), std::max(even.deviation, e.deviation), 0.0};
            random = {std::max(random.mean, r.mean), std::max(random.deviation, r.deviation), 0.0};
        }
        const std::string folder = bench::option(argc, argv, "--models=");
        const std::vector<Named> meshes = folder.empty()
                                              ? std::vector<Named>{{"torus", hrbfnpr::test::torus(320, 156, 0.4)},
                                                                   {"ring", hrbfnpr::test::wound_ring(500, 100)},
                                                                   {"box", hrbfnpr::test::box(1.0, 0.8, 0.6, 90)},
                                                                   {"plate", hrbfnpr::test::box(1.0, 1.0, 0.02, 90)}}
                                              : bench::read_meshes(folder, bench::option(argc, argv, "--named="));
        std::printf("\nstipples of fits to even samples; bad ones are more than 1 %% of the diagonal off the mesh\n"
                    "%-20s %6s %9s %9s %9s %9s %8s\n",
                    "mesh", "samples", "bad", "caught", "lost", "over it", "seconds");
        Totals totals;
        for (const Named& named : meshes) run_mesh(context.get(), named, totals);
        bench::report("support.caught", totals.bad > 0.0 ? totals.caught / totals.bad : 1.0);
        bench::report("support.lost", totals.lost / std::max(totals.good, 1.0));
        bench::report("support.lost_over_the_mesh", totals.lost_over / std::max(totals.over, 1.0));
        bench::report("support.lost_worst", totals.worst);
        bench::report("support.border_even", even.mean);
        bench::report("support.border_even_deviation", even.deviation);
        bench::report("support.border_random", random.mean);
        bench::report("support.border_random_deviation", random.deviation);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench/support: %s\n", error.what());
        return 1;
    }
    return 0;
}
