// SPDX-License-Identifier: MIT
// CSG trees against a plain recursion: values, gradients, projections, rays.
#pragma once

#include "calls.h"
#include "edges_csg.h"
#include "edges_reach.h"
#include "timing.h"

#include <cstdio>
#include <limits>
#include <stdexcept>

namespace bench::csg {

inline constexpr int points_each = 200;
inline constexpr int projections_each = 50;
inline constexpr int rays_each = 40;
inline constexpr int levels = 6;

struct Score {
    std::int64_t trees = 0, nodes = 0, empty = 0, empty_boxes = 0, given_bounds = 0;
    std::int64_t values = 0, wrong_values = 0;
    std::int64_t gradients = 0, wrong_gradients = 0;
    std::int64_t projections = 0, off_surface = 0;
    std::int64_t bare = 0, bare_converged = 0; // projections in boxes where a dense search finds no surface
    std::int64_t reaching = 0, converged = 0;  // projections in all other boxes
    std::vector<double> farther;               // distance beyond the nearest surface, in diagonals
    std::int64_t rays = 0, hits = 0, missed = 0, wrong_hits = 0;
    double value_error = 0.0, seconds = 0.0;
};

// Returns a tree as a model, or null if it is empty.
inline scenes::Model create(hrbfnpr_context* context, const bench::CsgNodes& nodes, Score& score) {
    hrbfnpr_csg_desc desc = nodes.desc();
    hrbfnpr_error error;
    hrbfnpr_error_init(&error, sizeof error);
    hrbfnpr_model* model = nullptr;
    if (hrbfnpr_model_create_csg(context, &desc, &model, &error) == HRBFNPR_STATUS_OK) return scenes::Model(model);
    const std::string message = error.message;
    if (message.find("nothing is left") != std::string::npos) return {};
    if (message.find("no end") == std::string::npos) throw std::runtime_error(message);
    for (int axis = 0; axis < 3; ++axis) desc.bounds_min[axis] = -(desc.bounds_max[axis] = 2.5);
    scenes::Check check;
    check(hrbfnpr_model_create_csg(context, &desc, &model, check.error()));
    ++score.given_bounds;
    return scenes::Model(model);
}

struct Tree {
    const hrbfnpr_model* model;
    bench::CsgReference reference;
    glm::dvec3 low{0.0}, high{0.0};
    std::mt19937 random;

    [[nodiscard]] double number() { return static_cast<double>(random()) / 4294967296.0; }
    [[nodiscard]] double diagonal() const { return glm::length(high - low); }
    // Random places in the box and slightly beyond.
    [[nodiscard]] std::vector<double> places(int count) {
        std::vector<double> packed;
        for (int i = 0; i < 3 * count; ++i)
            packed.push_back(low[i % 3] + (1.06 * number() - 0.03) * (high - low)[i % 3]);
        return packed;
    }
};

inline glm::dvec3 at(const std::vector<double>& packed, std::size_t i) {
    return {packed[3 * i], packed[3 * i + 1], packed[3 * i + 2]};
}

inline hrbfnpr_array_out out(std::vector<double>& numbers, std::uint32_t components) {
    return {numbers.data(), static_cast<std::int64_t>(numbers.size() / components), 0, HRBFNPR_SCALAR_FLOAT64,
            components};
}

// Returns the gradient of the reference by differences; NaN at a crease, where one-sided differences disagree.
inline glm::dvec3 difference(const bench::CsgReference& f, const glm::dvec3& p, double value, double step) {
    glm::dvec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 along(0.0);
        along[axis] = step;
        const double more = f.at(p + along);
        const double less = f.at(p - along);
        if (std::abs(more + less - 2.0 * value) > 1e-3 * step) return glm::dvec3(std::nan(""));
        gradient[axis] = (more - less) / (2.0 * step);
    }
    return gradient;
}

inline void compare_fields(Tree& tree, Score& score) {
    scenes::Check check;
    const std::vector<double> places = tree.places(points_each);
    std::vector<double> value(points_each);
    std::vector<double> gradient(3 * points_each);
    const hrbfnpr_array points = bench::view(places);
    const hrbfnpr_array_out values = out(value, 1);
    const hrbfnpr_array_out gradients = out(gradient, 3);
    score.seconds += bench::seconds([&] {
        check(hrbfnpr_model_evaluate(tree.model, &points, &values, &gradients, nullptr, nullptr, check.error()));
    });
    for (std::size_t i = 0; i < value.size(); ++i) {
        const glm::dvec3 p = at(places, i);
        const double expected = tree.reference.at(p);
        const double error = std::abs(value[i] - expected);
        score.value_error = std::max(score.value_error, error);
        ++score.values;
        score.wrong_values += error <= 1e-11 ? 0 : 1;
        const glm::dvec3 slope = difference(tree.reference, p, expected, 1e-5);
        if (std::isnan(slope.x)) continue;
        ++score.gradients;
        score.wrong_gradients += glm::length(slope - at(gradient, i)) <= 1e-4 ? 0 : 1;
    }
}

inline void project(Tree& tree, Score& score) {
    scenes::Check check;
    std::vector<double> places = tree.places(projections_each);
    std::vector<std::uint32_t> status(projections_each);
    const hrbfnpr_array points = bench::view(places);
    std::vector<double> place(places.size());
    hrbfnpr_projection projection;
    check(hrbfnpr_projection_init(&projection, sizeof projection));
    projection.position = out(place, 3);
    projection.status = {status.data(), projections_each, 0, HRBFNPR_SCALAR_UINT32, 1};
    check(hrbfnpr_model_project(tree.model, &points, nullptr, &projection, nullptr, check.error()));
    const double margin = 0.05 * tree.diagonal(); // the search box is larger by this
    const DenseSurface dense(tree.model, tree.low - margin, tree.high + margin);
    score.empty_boxes += dense.empty() ? 1 : 0;
    for (std::size_t i = 0; i < status.size(); ++i) {
        ++score.projections;
        ++(dense.empty() ? score.bare : score.reaching);
        if (status[i] != HRBFNPR_PROJECTION_CONVERGED) continue;
        ++(dense.empty() ? score.bare_converged : score.converged);
        if (!dense.empty())
            score.farther.push_back((glm::distance(at(places, i), at(place, i)) - dense.distance(at(places, i))) /
                                    tree.diagonal());
        score.off_surface += std::abs(tree.reference.at(at(place, i))) <= 1e-8 * tree.diagonal() ? 0 : 1;
    }
}

// Returns the first sign change at fine steps along a ray in the search box; infinity if there is none.
inline double first_change(const Tree& tree, const glm::dvec3& origin, const glm::dvec3& direction, double step) {
    const double margin = 0.05 * tree.diagonal();
    int inside = -1;
    for (double t = 0.0; t < 3.0 * tree.diagonal(); t += step) {
        const glm::dvec3 p = origin + t * direction;
        if (glm::any(glm::lessThan(p, tree.low - margin)) || glm::any(glm::greaterThan(p, tree.high + margin)))
            continue;
        const int now = tree.reference.at(p) < 0.0 ? 1 : 0;
        if (inside >= 0 && now != inside) return t;
        inside = now;
    }
    return std::numeric_limits<double>::infinity();
}

inline void cast(Tree& tree, Score& score) {
    scenes::Check check;
    std::vector<double> origin;
    std::vector<double> direction;
    const std::vector<double> targets = tree.places(rays_each);
    for (std::size_t i = 0; i < rays_each; ++i) {
        const glm::dvec3 along =
            glm::normalize(glm::dvec3(tree.number() - 0.5, tree.number() - 0.5, tree.number() - 0.49));
        const glm::dvec3 from = at(targets, i) - 1.2 * tree.diagonal() * along;
        for (int c = 0; c < 3; ++c) {
            origin.push_back(from[c]);
            direction.push_back(along[c]);
        }
    }
    std::vector<double> t(rays_each);
    const hrbfnpr_array origins = bench::view(origin);
    const hrbfnpr_array directions = bench::view(direction);
    hrbfnpr_ray_hits hits;
    check(hrbfnpr_ray_hits_init(&hits, sizeof hits));
    hits.t = out(t, 1);
    check(hrbfnpr_model_cast_rays(tree.model, &origins, &directions, nullptr, &hits, nullptr, check.error()));
    const double step = 2e-3 * tree.diagonal();
    for (std::size_t i = 0; i < rays_each; ++i) {
        const double expected = first_change(tree, at(origin, i), at(direction, i), step);
        ++score.rays;
        if (std::isfinite(t[i])) {
            ++score.hits;
            // A hit before the sampled sign change is right, too, if the sign changes there: sampling may miss a thin
            // wall.
            const double near = 1e-7 * tree.diagonal();
            const bool changes = (tree.reference.at(at(origin, i) + (t[i] - near) * at(direction, i)) < 0.0) !=
                                 (tree.reference.at(at(origin, i) + (t[i] + near) * at(direction, i)) < 0.0);
            score.wrong_hits += changes ? 0 : 1;
        }
        score.missed += t[i] > expected + 1e-7 * tree.diagonal() ? 1 : 0;
    }
}

inline void measure_csg(hrbfnpr_context* context, int trees) {
    Score score;
    for (std::uint32_t seed = 0; score.trees < trees; ++seed) {
        const bench::RandomCsg made(seed, 1 + static_cast<int>(seed % levels));
        const scenes::Model model = create(context, made.nodes, score);
        if (model == nullptr) {
            ++score.empty;
            continue;
        }
        ++score.trees;
        score.nodes += static_cast<std::int64_t>(made.nodes.nodes.size());
        Tree tree{model.get(), bench::CsgReference(made.nodes), {}, {}, std::mt19937(seed)};
        scenes::Check check;
        hrbfnpr_model_info info;
        check(hrbfnpr_model_info_init(&info, sizeof info));
        check(hrbfnpr_model_get_info(model.get(), &info, check.error()));
        for (int axis = 0; axis < 3; ++axis) {
            tree.low[axis] = info.bounds_min[axis];
            tree.high[axis] = info.bounds_max[axis];
        }
        compare_fields(tree, score);
        project(tree, score);
        cast(tree, score);
    }
    const auto print = [](const char* what, std::int64_t number) {
        std::printf("%-46s %lld\n", what, static_cast<long long>(number));
    };
    print("trees", score.trees);
    print("their nodes", score.nodes);
    print("with bounds given, as they have no end", score.given_bounds);
    print("left out, as nothing is left of them", score.empty);
    print("values", score.values);
    print("gradients, off creases", score.gradients);
    print("without a surface that a dense search finds", score.empty_boxes);
    print("projections", score.projections);
    print("of these, of trees without a surface", score.bare);
    print("  which converged, on thin walls", score.bare_converged);
    print("of trees with a surface", score.reaching);
    print("  which converged", score.converged);
    print("rays", score.rays);
    print("hits", score.hits);
    std::printf("edges.csg_value_error %.3g\n", score.value_error);
    std::printf("edges.csg_wrong_values %lld\n", static_cast<long long>(score.wrong_values));
    std::printf("edges.csg_wrong_gradients %lld\n", static_cast<long long>(score.wrong_gradients));
    std::printf("edges.csg_converged_share %.4f\n",
                static_cast<double>(score.converged) / static_cast<double>(score.reaching));
    std::sort(score.farther.begin(), score.farther.end());
    const auto farther = [&](double share) {
        return score.farther.empty()
                   ? 0.0
                   : score.farther[static_cast<std::size_t>(share * static_cast<double>(score.farther.size() - 1))];
    };
    std::printf("edges.csg_farther_than_nearest_median %.4f\n", std::max(0.0, farther(0.5)));
    std::printf("edges.csg_farther_than_nearest_p95 %.4f\n", farther(0.95));
    std::printf("edges.csg_off_surface %lld\n", static_cast<long long>(score.off_surface));
    std::printf("edges.csg_wrong_hits %lld\n", static_cast<long long>(score.wrong_hits));
    std::printf("edges.csg_missed_hits %lld\n", static_cast<long long>(score.missed));
    std::printf("edges.csg_leaf_evaluations_per_second %.3g\n", static_cast<double>(score.values) *
                                                                    static_cast<double>(score.nodes) /
                                                                    static_cast<double>(score.trees) / score.seconds);
}

} // namespace bench::csg
