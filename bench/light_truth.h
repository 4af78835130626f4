// SPDX-License-Identifier: MIT
// Occlusion and soft shadows against rays that are tested with closed forms, on scenes of balls, bowls and walls.
#pragma once

#include "light/light.h"
#include "mesh_rays.h"

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace bench {

// Random places on a surface, its mesh, and the closed form of its first hit by a ray.
struct TrueScene {
    std::string name;
    Triangles mesh;
    std::function<void(std::mt19937_64&, glm::dvec3& place, glm::dvec3& normal)> draw;
    std::function<double(const glm::dvec3& origin, const glm::dvec3& direction)> hit;
    double reach; // the reach of occlusion
};

[[nodiscard]] inline double uniform(std::mt19937_64& random) {
    return std::uniform_real_distribution<double>(0.0, 1.0)(random);
}

// A unit ball, or its lower half.
[[nodiscard]] inline Triangles ball_mesh(int rows, double from, double to) {
    Triangles mesh;
    const int columns = 2 * rows;
    for (int i = 0; i <= rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const double a = from + (to - from) * i / rows, b = 6.283185307179586 * j / columns;
            static_cast<void>(mesh.add(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)));
        }
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const int a = i * columns + j, b = i * columns + (j + 1) % columns;
            mesh.face(a, a + columns, b);
            mesh.face(b, a + columns, b + columns);
        }
    return mesh;
}

// A parallelogram.
inline void add_quad(Triangles& mesh, const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v) {
    std::int32_t at[4];
    int k = 0;
    for (const glm::dvec3& p : {corner, corner + u, corner + u + v, corner + v}) at[k++] = mesh.add(p.x, p.y, p.z);
    mesh.face(at[0], at[1], at[2]);
    mesh.face(at[0], at[2], at[3]);
}

// Returns the t at which a ray meets the rectangle of all places whose coordinate `axis` is `level` and whose others
// are within `half` of 0.
[[nodiscard]] inline double hit_square(const glm::dvec3& origin, const glm::dvec3& direction, int axis, double level,
                                       double half) {
    const double t = (level - origin[axis]) / direction[axis];
    const glm::dvec3 at = origin + t * direction;
    const bool inside = std::abs(at[(axis + 1) % 3]) <= half && std::abs(at[(axis + 2) % 3]) <= half;
    return t > 0.0 && inside ? t : std::numeric_limits<double>::infinity();
}

// Returns the t at which a ray meets the part of the unit sphere below z = `below`.
[[nodiscard]] inline double hit_ball(const glm::dvec3& origin, const glm::dvec3& direction, double below) {
    const double b = glm::dot(origin, direction);
    const double root = std::sqrt(b * b - glm::dot(origin, origin) + 1.0); // NaN if the ray misses the ball
    for (const double t : {-b - root, -b + root})
        if (t > 1e-9 && origin.z + t * direction.z <= below) return t;
    return std::numeric_limits<double>::infinity();
}

inline glm::dvec3 on_sphere(std::mt19937_64& random, double lowest, double highest) {
    const double z = lowest + (highest - lowest) * uniform(random);
    const double turn = 6.283185307179586 * uniform(random), r = std::sqrt(1.0 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
}

[[nodiscard]] inline std::vector<TrueScene> true_scenes() {
    constexpr double pi = 3.14159265358979323846;
    std::vector<TrueScene> scenes(4);
    const auto in_square = [](std::mt19937_64& random, double half) { return half * (2.0 * uniform(random) - 1.0); };

    scenes[0] = {"ball_on_floor", ball_mesh(200, 1e-3, pi - 1e-3), {}, {}, 2.0};
    add_quad(scenes[0].mesh, {-4, -4, -1}, {8, 0, 0}, {0, 8, 0});
    scenes[0].draw = [in_square](std::mt19937_64& random, glm::dvec3& place, glm::dvec3& normal) {
        if (uniform(random) < 0.5) {
            place = normal = on_sphere(random, -0.98, 1.0);
            return;
        }
        do place = {in_square(random, 3.0), in_square(random, 3.0), -1.0};
        while (std::hypot(place.x, place.y) < 0.15);
        normal = {0, 0, 1};
    };
    scenes[0].hit = [](const glm::dvec3& o, const glm::dvec3& d) {
        return std::min(hit_ball(o, d, 2.0), hit_square(o, d, 2, -1.0, 4.0));
    };

    scenes[1] = {"bowl", ball_mesh(200, 0.5 * pi, pi - 1e-3), {}, {}, 2.0};
    scenes[1].draw = [](std::mt19937_64& random, glm::dvec3& place, glm::dvec3& normal) {
        place = on_sphere(random, -1.0, -0.02);
        normal = -place;
    };
    scenes[1].hit = [](const glm::dvec3& o, const glm::dvec3& d) { return hit_ball(o, d, 0.0); };

    scenes[2] = {"two_walls", {}, {}, {}, 1.5};
    for (const double z : {0.0, 0.6}) add_quad(scenes[2].mesh, {-1, -1, z}, {2, 0, 0}, {0, 2, 0});
    scenes[2].draw = [in_square](std::mt19937_64& random, glm::dvec3& place, glm::dvec3& normal) {
        const bool upper = uniform(random) < 0.5;
        place = {in_square(random, 1.0), in_square(random, 1.0), upper ? 0.6 : 0.0};
        normal = {0, 0, upper ? -1 : 1};
    };
    scenes[2].hit = [](const glm::dvec3& o, const glm::dvec3& d) {
        return std::min(hit_square(o, d, 2, 0.0, 1.0), hit_square(o, d, 2, 0.6, 1.0));
    };

    scenes[3] = {"corner", {}, {}, {}, 1.5};
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 u(0.0), v(0.0);
        u[(axis + 1) % 3] = v[(axis + 2) % 3] = 2.0;
        add_quad(scenes[3].mesh, glm::dvec3(-1.0), u, v);
    }
    scenes[3].draw = [in_square](std::mt19937_64& random, glm::dvec3& place, glm::dvec3& normal) {
        const int axis = static_cast<int>(3.0 * uniform(random)) % 3;
        place = {in_square(random, 1.0), in_square(random, 1.0), in_square(random, 1.0)};
        place[axis] = -1.0;
        normal = glm::dvec3(0.0);
        normal[axis] = 1.0;
    };
    scenes[3].hit = [](const glm::dvec3& o, const glm::dvec3& d) {
        double first = std::numeric_limits<double>::infinity();
        for (int axis = 0; axis < 3; ++axis) first = std::min(first, hit_square(o, d, axis, -1.0, 1.0));
        return first;
    };
    return scenes;
}

// Returns the openness of a place by many random rays.
[[nodiscard]] inline double plain_openness(const TrueScene& scene, const glm::dvec3& place, const glm::dvec3& n,
                                           std::mt19937_64& random) {
    constexpr int rays = 2000;
    double hidden = 0.0;
    for (int k = 0; k < rays; ++k) {
        // A unit vector around the tip of the normal is a cosine-weighted direction.
        const glm::dvec3 direction = glm::normalize(n + on_sphere(random, -1.0, 1.0));
        const double t = scene.hit(place + 1e-6 * n, direction);
        if (t < scene.reach) hidden += 1.0 - t / scene.reach;
    }
    return 1.0 - hidden / rays;
}

// Returns the share of a lamp's disc that a place sees, by many random rays.
[[nodiscard]] inline double plain_visible(const TrueScene& scene, const lib::light::Lamp& lamp, const glm::dvec3& place,
                                          const glm::dvec3& n, std::mt19937_64& random) {
    constexpr int rays = 2000;
    const glm::dvec3 u = glm::normalize(glm::cross(lamp.place, glm::dvec3(0.0, 1.0, 0.3)));
    const glm::dvec3 v = glm::cross(lamp.place, u);
    int seen = 0;
    for (int k = 0; k < rays; ++k) {
        const double r = std::tan(lamp.softness) * std::sqrt(uniform(random));
        const double turn = 6.283185307179586 * uniform(random);
        const glm::dvec3 way = glm::normalize(lamp.place + r * std::cos(turn) * u + r * std::sin(turn) * v);
        seen += std::isfinite(scene.hit(place + 1e-6 * n, way)) ? 0 : 1;
    }
    return static_cast<double>(seen) / rays;
}

// The mean and the largest difference.
class Difference {
public:
    void add(double a, double b) {
        sum_ += std::abs(a - b);
        most_ = std::max(most_, std::abs(a - b));
        ++count_;
    }
    void report(const std::string& name) const {
        bench::report((name + ".mean").c_str(), sum_ / std::max(count_, 1));
        bench::report((name + ".largest").c_str(), most_);
    }

private:
    double sum_ = 0.0, most_ = 0.0;
    int count_ = 0;
};

inline void report_truth(const TrueScene& scene, int threads) {
    constexpr std::int64_t places = 60000;
    constexpr std::int64_t step = 61; // every 61st place is compared
    const MeshRays rays(scene.mesh, threads);
    const lib::base::Work work(rays.runtime());
    const lib::geometry::Bvh tree = rays.build();
    std::mt19937_64 random(11);
    lib::geometry::VecArray place(work.memory), normal(work.memory);
    for (std::int64_t i = 0; i < places; ++i) {
        glm::dvec3 p, n;
        scene.draw(random, p, n);
        place.push_back(p);
        normal.push_back(n);
    }
    const lib::light::Places all{place, normal, 1e-3};
    Difference occlusion;
    const lib::base::Array<float> open = lib::light::find_openness(work, tree, all, {scene.reach});
    for (std::int64_t i = 0; i < places; i += step)
        occlusion.add(double{open[i]}, plain_openness(scene, place[i], normal[i], random));
    occlusion.report("light.occlusion." + scene.name);
    Difference shadow;
    lib::light::Lamp lamp{glm::normalize(glm::dvec3(0.5, 0.3, 1.0)), false, 0.1};
    const lib::base::Array<float> visible = lib::light::find_visible(work, tree, all, lamp);
    for (std::int64_t i = 0; i < places; i += step) {
        // A lamp that sets behind the surface's own horizon is partly seen.
        if (std::abs(glm::dot(normal[i], lamp.place)) < std::sin(lamp.softness)) continue;
        const bool faces = glm::dot(normal[i], lamp.place) > 0.0;
        shadow.add(double{visible[i]}, faces ? plain_visible(scene, lamp, place[i], normal[i], random) : 0.0);
    }
    shadow.report("light.soft_shadow." + scene.name);
    std::fflush(stdout);
}

} // namespace bench
