// SPDX-License-Identifier: MIT
// Models of sheets fitted to meshes with edges: the errors of their edges, of normals and signs beside the edges, and
// the time of an evaluation.
#pragma once

#include "calls.h"
#include "edge_places.h"
#include "edges_creases.h"
#include "read_meshes.h"
#include "support/screw.h"
#include "support/sharp_meshes.h"
#include "timing.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace bench {

using hrbfnpr::test::made;

struct EdgeShape {
    std::string name;
    Triangles mesh;
    std::int64_t most = 0; // centres
    std::vector<double> round;
};

struct EdgeSpread {
    double p95 = 0.0, most = 0.0;
};

inline EdgeSpread edge_spread(std::vector<double> values, double unit) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    return {values[values.size() * 95 / 100] / unit, values.back() / unit};
}

// A mesh, a model of it, and the measurements; lengths are in % of the diagonal.
class PiecesRun {
public:
    PiecesRun(hrbfnpr_context* context, const EdgeShape& shape, std::uint32_t edges)
        : context_(context), shape_(shape), brute_(shape.mesh), places_(edge_places(shape.mesh, shape.round)) {
        scenes::Check check;
        auto desc = made(hrbfnpr_mesh_desc_init);
        desc.vertices = view(shape.mesh.vertices);
        desc.triangles = {shape.mesh.triangles.data(), static_cast<std::int64_t>(shape.mesh.faces()), 0,
                          HRBFNPR_SCALAR_INT32, 3};
        desc.crease_angle = 30.0;
        hrbfnpr_mesh* mesh = nullptr;
        check(hrbfnpr_mesh_create(context, &desc, nullptr, &mesh, check.error()));
        mesh_ = hrbfnpr::test::Mesh(mesh);
        auto fit = made(hrbfnpr_mesh_fit_desc_init);
        fit.maximum_centres = shape.most;
        fit.edges = edges;
        info = made(hrbfnpr_mesh_fit_info_init);
        hrbfnpr_model* model = nullptr;
        check(hrbfnpr_model_fit_mesh(mesh_.get(), &fit, nullptr, &info, nullptr, &model, check.error()));
        model_ = scenes::Model(model);
        auto box = made(hrbfnpr_model_info_init);
        check(hrbfnpr_model_get_info(model, &box, check.error()));
        double square = 0.0;
        for (std::size_t c = 0; c < 3; ++c) {
            low_[c] = box.bounds_min[c];
            size_[c] = box.bounds_max[c] - box.bounds_min[c];
            square += size_[c] * size_[c];
        }
        unit_ = 0.01 * std::sqrt(square);
    }

    // For each place on an edge, the distance to the nearest sign change within 2 % along the edge's `out` direction.
    [[nodiscard]] EdgeSpread edges() const {
        constexpr int steps = 400;
        std::vector<double> points;
        for (const EdgePlace& place : places_)
            for (int i = -steps; i <= steps; ++i)
                for (std::size_t c = 0; c < 3; ++c)
                    points.push_back(place.place[c] + 2.0 * unit_ * i / steps * place.out[c]);
        const std::vector<double> value = values(points);
        std::vector<double> off;
        for (std::size_t k = 0; k < places_.size(); ++k) {
            const double* const v = value.data() + k * (2 * steps + 1) + steps;
            double best = 2.0;
            for (int i = -steps; i < steps; ++i) {
                if ((v[i] > 0.0) == (v[i + 1] > 0.0)) continue;
                const double at = (i + v[i] / (v[i] - v[i + 1])) * 2.0 / steps;
                best = std::min(best, std::abs(at));
            }
            off.push_back(best);
        }
        return edge_spread(off, 1.0);
    }

    // The errors of the creases that a line set traces.
    [[nodiscard]] CreaseErrors creases() const {
        return crease_errors(context_, model_.get(), edge_places(shape_.mesh, shape_.round, 20.0));
    }

    // Errors at places on the mesh within 2 % of its edges: distances of the surface, and angles of normals from 0.1 %
    // on.
    void beside(EdgeSpread& surface, EdgeSpread& normal) const {
        std::vector<double> points, normals;
        sample(20000, points, normals);
        std::vector<double> gradient(points.size());
        const std::vector<double> value = values(points, &gradient);
        std::vector<double> off, angle;
        for (std::size_t i = 0; i < value.size(); ++i) {
            const BruteMesh::Point p{points[3 * i], points[3 * i + 1], points[3 * i + 2]};
            const double d = to_edges(p);
            if (d > 2.0 * unit_) continue;
            const BruteMesh::Point g{gradient[3 * i], gradient[3 * i + 1], gradient[3 * i + 2]};
            const BruteMesh::Point n{normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]};
            off.push_back(std::abs(value[i]) / BruteMesh::length(g));
            if (d < 0.1 * unit_) continue;
            const double cosine = BruteMesh::dot(g, n) / BruteMesh::length(g);
            angle.push_back(57.29577951308232 * std::acos(std::clamp(cosine, -1.0, 1.0)));
        }
        surface = edge_spread(off, unit_);
        normal = edge_spread(angle, 1.0);
    }

    // Counts places with a wrong sign among places farther than 0.1 % from the mesh; half of all places are within
    // about 3 % of it.
    [[nodiscard]] int wrong_signs() const {
        constexpr std::size_t count = 4000;
        std::vector<double> points, normals;
        sample(count / 2, points, normals);
        for (std::size_t i = 0; i < points.size(); ++i) points[i] += 3.0 * unit_ * random(i, 1);
        for (std::size_t i = 0; i < 3 * count / 2; ++i)
            points.push_back(low_[i % 3] + size_[i % 3] * (0.5 + 0.6 * random(i, 2)));
        const std::vector<double> value = values(points);
        int wrong = 0;
        for (std::size_t i = 0; i < value.size(); ++i) {
            const BruteMesh::Point p{points[3 * i], points[3 * i + 1], points[3 * i + 2]};
            if ((value[i] < 0.0) != brute_.inside(p) && brute_.distance(p) > 0.1 * unit_) ++wrong;
        }
        return wrong;
    }

    // Returns the evaluations per second, relative to one smooth fit of as many samples, at places beside the surface.
    [[nodiscard]] double speed() const {
        std::vector<double> points, normals;
        sample(static_cast<int>(info.centres), points, normals);
        const scenes::Model smooth = bench::fit(context_, points, normals, HRBFNPR_TRIM_NEVER);
        std::vector<double> queries, ignored;
        sample(60000, queries, ignored);
        for (std::size_t i = 0; i < queries.size(); ++i) queries[i] += unit_ * random(i, 3);
        std::vector<double> gradient(queries.size());
        const Comparison times = compare(
            5, [&] { (void)values_of(smooth, queries, &gradient); },
            [&] { (void)values_of(model_, queries, &gradient); });
        return times.ratio;
    }

    hrbfnpr_mesh_fit_info info{};

private:
    // Returns a random number in [-1, 1].
    [[nodiscard]] static double random(std::size_t i, std::uint64_t stream) {
        std::uint64_t bits = (static_cast<std::uint64_t>(i) + 1) * 0x9E3779B97F4A7C15U + stream * 0xD1B54A32D192ED03U;
        bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9U;
        bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBU;
        return static_cast<double>((bits ^ (bits >> 31U)) >> 11U) * 0x1p-52 - 1.0;
    }

    void sample(int count, std::vector<double>& points, std::vector<double>& normals) const {
        scenes::Check check;
        points.resize(3 * static_cast<std::size_t>(count));
        normals.resize(points.size());
        auto desc = made(hrbfnpr_sample_desc_init);
        const hrbfnpr_array_out to{points.data(), count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        const hrbfnpr_array_out along{normals.data(), count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        if (count > 5000) desc.candidates = count;
        check(hrbfnpr_mesh_sample(mesh_.get(), &desc, &to, &along, nullptr, check.error()));
    }

    [[nodiscard]] static std::vector<double> values_of(const scenes::Model& model, const std::vector<double>& points,
                                                       std::vector<double>* gradient) {
        scenes::Check check;
        std::vector<double> value(points.size() / 3);
        const auto count = static_cast<std::int64_t>(value.size());
        const hrbfnpr_array at = view(points);
        const hrbfnpr_array_out to{value.data(), count, 0, HRBFNPR_SCALAR_FLOAT64, 1};
        const hrbfnpr_array_out along{gradient != nullptr ? gradient->data() : nullptr, count, 0,
                                      HRBFNPR_SCALAR_FLOAT64, 3};
        check(hrbfnpr_model_evaluate(model.get(), &at, &to, gradient != nullptr ? &along : nullptr, nullptr, nullptr,
                                     check.error()));
        return value;
    }
    [[nodiscard]] std::vector<double> values(const std::vector<double>& points,
                                             std::vector<double>* gradient = nullptr) const {
        return values_of(model_, points, gradient);
    }

    [[nodiscard]] double to_edges(const BruteMesh::Point& p) const {
        double least = 1e300;
        for (const EdgePlace& place : places_) {
            const BruteMesh::Point off = BruteMesh::less(p, place.place);
            least = std::min(least, BruteMesh::dot(off, off));
        }
        return std::sqrt(least);
    }

    hrbfnpr_context* context_;
    const EdgeShape& shape_;
    BruteMesh brute_;
    std::vector<EdgePlace> places_;
    hrbfnpr::test::Mesh mesh_;
    scenes::Model model_;
    std::array<double, 3> low_{}, size_{};
    double unit_ = 0.0;
};

inline std::vector<EdgeShape> edge_shapes() {
    using namespace hrbfnpr::test;
    return {{"cube", box(1.0, 1.0, 1.0, 8), 1400, {}},
            {"drilled cube", drilled_cube(0.5, 96), 1400, {0.5}},
            {"shaft", stepped_shaft(96), 1700, {1.0, 0.6, 0.5, 0.35}},
            {"socket", socket(96), 3000, {0.7, 1.0}},
            {"gear", gear(16, 3), 1000, {0.3}},
            {"plate", box(1.0, 1.0, 0.0042, 8), 1000, {}},
            {"screw", screw(5, trapezoidal, 72, 3), 6000, {}},
            {"screw10", screw(10, trapezoidal, 72, 3), 6000, {}}};
}

// Prints a line for each shape and reports the tracked numbers.  folder: a folder of OBJ and PLY meshes to measure as
// well.
inline void measure_pieces(hrbfnpr_context* context, const std::string& folder, const std::string& named) {
    std::vector<EdgeShape> shapes = edge_shapes();
    if (!folder.empty())
        for (auto& [name, mesh] : read_meshes(folder, named)) shapes.push_back({name, std::move(mesh), 2000, {}});
    std::printf("models of sheets; lengths in %% of the diagonal\n%-14s %8s %7s %7s %9s %9s %9s %9s %7s %7s %6s %7s "
                "%9s %9s %9s %6s\n",
                "mesh", "centres", "sheets", "cells", "edge p95", "max", "smooth", "near p95", "normal", "wrong",
                "fit s", "speed", "traced", "max", "corners", "found");
    for (const EdgeShape& shape : shapes) {
        const PiecesRun run(context, shape, HRBFNPR_EDGES_AUTO);
        EdgeShape coarse = shape;
        coarse.most = std::max<std::int64_t>(run.info.centres, 1000);
        const PiecesRun smooth(context, coarse, HRBFNPR_EDGES_SMOOTH);
        const EdgeSpread edges = run.edges();
        EdgeSpread surface, normal;
        run.beside(surface, normal);
        const int wrong = run.wrong_signs();
        const double speed = run.speed();
        const CreaseErrors creases = run.creases();
        std::printf("%-14s %8lld %7d %7lld %9.4f %9.4f %9.4f %9.4f %7.2f %7d %6.2f %7.2f %9.4f %9.4f %9.4f %6.3f\n",
                    shape.name.c_str(), static_cast<long long>(run.info.centres), run.info.sheets,
                    static_cast<long long>(run.info.cells), edges.p95, edges.most, smooth.edges().p95, surface.p95,
                    normal.p95, wrong, run.info.seconds_total, speed, creases.p95, creases.most, creases.corner_p95,
                    creases.found);
        std::string key = "edges." + shape.name.substr(0, shape.name.find(' '));
        report((key + "_p95").c_str(), edges.p95);
        report((key + "_max").c_str(), edges.most);
        report((key + "_surface_p95").c_str(), surface.p95);
        report((key + "_normal_p95").c_str(), normal.p95);
        report((key + "_wrong_signs").c_str(), wrong);
        report((key + "_speed").c_str(), speed);
        report((key + "_creases_p95").c_str(), creases.p95);
        report((key + "_creases_max").c_str(), creases.most);
        report((key + "_creases_corner_p95").c_str(), creases.corner_p95);
        report((key + "_creases_found").c_str(), creases.found);
        report((key + "_fit_seconds").c_str(), run.info.seconds_total);
    }
}

} // namespace bench
