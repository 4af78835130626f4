// SPDX-License-Identifier: MIT
// Stages of fits, normals, trimming, meshes and queries.
#include "stages/stages.h"

#include <cmath>

namespace api_test {

using hrbfnpr::test::Triangles;

namespace {

hrbfnpr::test::Samples half_of(const hrbfnpr::test::Samples& whole) {
    hrbfnpr::test::Samples half;
    for (std::size_t i = 0; i < whole.points.size(); i += 3)
        if (whole.points[i + 2] > 0.0)
            half.add({whole.points[i], whole.points[i + 1], whole.points[i + 2]},
                     {whole.normals[i], whole.normals[i + 1], whole.normals[i + 2]});
    return half;
}

hrbfnpr_mesh_desc mesh_desc(const Triangles& triangles) {
    auto desc = made(hrbfnpr_mesh_desc_init);
    desc.vertices = in(triangles.vertices);
    desc.triangles = in(triangles.triangles);
    return desc;
}

Mesh make_mesh(const Context& context, const Triangles& triangles) {
    Error error;
    hrbfnpr_mesh* mesh = nullptr;
    const hrbfnpr_mesh_desc desc = mesh_desc(triangles);
    EXPECT_OK(hrbfnpr_mesh_create(context.get(), &desc, nullptr, &mesh, error));
    return Mesh(mesh);
}

} // namespace

Stages::Stages(const Context& context, const StageSizes& sizes)
    : context_(context), sizes_(sizes), samples_(hrbfnpr::test::bumpy(sizes.samples)),
      dense_(hrbfnpr::test::bumpy(sizes.dense_samples)), cloud_(hrbfnpr::test::sphere(sizes.cloud)),
      half_(half_of(hrbfnpr::test::sphere(sizes.half_samples))),
      triangles_(hrbfnpr::test::torus(sizes.mesh_around, sizes.mesh_around / 2, 0.4)),
      depths_(hrbfnpr::test::seen_depths(sizes.pixels, sizes.pixels, {0.002, 0.0, 1.0})) {
    Error error;
    for (std::int64_t i = 0; i < sizes.places; ++i)
        for (const double c : hrbfnpr::test::spiral_point(i, sizes.places)) {
            places_.push_back(1.1 * c);
            directions_.push_back(-c);
        }
    uneven_ = dense_.points;
    for (std::size_t i = 0; i < uneven_.size(); ++i) uneven_[i] += 0.01 * std::sin(12.9898 * static_cast<double>(i));
    model_ = fit(context, {samples_.points, samples_.normals});
    half_model_ = fit(context, {half_.points, half_.normals});
    mesh_ = make_mesh(context, triangles_);
    solid_ = make_mesh(context, hrbfnpr::test::tetrahedron());
    Generation marks = hrbfnpr::test::three_layers(sizes.marks);
    marks.add(HRBFNPR_LAYER_KIND_HATCH, sizes.marks);
    set_ = generate(context, model_, marks);
    auto line_desc = made(hrbfnpr_line_set_desc_init);
    line_desc.flags = HRBFNPR_LINE_SET_WITH_CURVATURE;
    hrbfnpr_line_set* lines = nullptr;
    EXPECT_OK(hrbfnpr_line_set_create(context.get(), model_.get(), &line_desc, nullptr, &lines, error));
    curved_lines_.reset(lines);
    static_cast<void>(drawing());
}

std::vector<Stage> Stages::all() {
    std::vector<Stage> stages;
    add_fits(stages);
    add_meshes(stages);
    add_queries(stages);
    add_marks(stages);
    add_files(stages);
    add_frames(stages);
    add_lights(stages);
    add_fields(stages);
    add_readers(stages);
    add_pages(stages);
    add_pictures(stages);
    return stages;
}

void Stages::add_fit(std::vector<Stage>& stages, const char* name, const hrbfnpr_fit_desc& desc) {
    add(stages, name, [this, desc](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        hrbfnpr_model* model = nullptr;
        const auto status =
            attempt([&] { return hrbfnpr_model_fit(context_.get(), &desc, attempt.operation, &model, error); });
        EXPECT_EQ(model != nullptr, status == HRBFNPR_STATUS_OK);
        if (const Model owned(model); owned) append(bytes, owned);
        return status;
    });
}

void Stages::add_fits(std::vector<Stage>& stages) {
    auto desc = made(hrbfnpr_fit_desc_init);
    desc.points = in(samples_.points);
    desc.normals = in(samples_.normals);
    auto direct = desc;
    direct.solver = HRBFNPR_SOLVER_DIRECT;
    add_fit(stages, "fit.direct", direct);
    auto linear = direct;
    linear.polynomial_degree = -1; // uses a pivoted LU
    add_fit(stages, "fit.pivoted", linear);
    auto gaussian = direct;
    gaussian.kernel = HRBFNPR_KERNEL_GAUSSIAN;
    add_fit(stages, "fit.gaussian", gaussian);
    auto iterative = desc;
    iterative.points = in(dense_.points);
    iterative.normals = in(dense_.normals);
    iterative.solver = HRBFNPR_SOLVER_ITERATIVE;
    add_fit(stages, "fit.iterative", iterative);
    auto compact = iterative;
    compact.kernel = HRBFNPR_KERNEL_WENDLAND_C2;
    add_fit(stages, "fit.compact", compact);
    auto choosing = iterative;
    choosing.tolerance = 0.01;
    add_fit(stages, "fit.choosing", choosing);
    auto noisy = choosing;
    noisy.points = in(uneven_);
    noisy.regularization_mode = HRBFNPR_REGULARIZATION_AUTO;
    noisy.outliers = HRBFNPR_REPAIR_DROP;
    noisy.flipped_normals = HRBFNPR_REPAIR_REORIENT;
    noisy.tolerance = 0.05;
    add_fit(stages, "fit.noise", noisy);
    auto none = desc; // few points, since finding normals asks for memory thousands of times
    none.points = in(cloud_.points);
    none.normal_mode = HRBFNPR_NORMALS_NONE;
    none.normals = {};
    add_fit(stages, "fit.without_normals", none);
    auto open = desc;
    open.points = in(half_.points);
    open.normals = in(half_.normals);
    add_fit(stages, "fit.open", open);
    add(stages, "orient", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        auto orient = made(hrbfnpr_orient_desc_init);
        orient.mode = HRBFNPR_NORMALS_NONE;
        orient.points = in(cloud_.points);
        std::vector<double> normals(cloud_.points.size());
        const hrbfnpr_array_out to = out(normals);
        const auto status =
            attempt([&] { return hrbfnpr_orient(context_.get(), &orient, attempt.operation, &to, nullptr, error); });
        if (status == HRBFNPR_STATUS_OK) append(bytes, normals);
        return status;
    });
    add(stages, "smooth_depth_image", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        auto image = made(hrbfnpr_depth_image_desc_init);
        image.columns = depths_.columns;
        image.rows = depths_.rows;
        image.points = in(depths_.points);
        std::vector<double> points(depths_.points.size()), normals(points);
        const hrbfnpr_array_out to = out(points), normals_to = out(normals);
        const auto status = attempt([&] {
            return hrbfnpr_smooth_depth_image(context_.get(), &image, attempt.operation, &to, &normals_to, nullptr,
                                              error);
        });
        if (status == HRBFNPR_STATUS_OK) append(bytes, points), append(bytes, normals);
        return status;
    });
    add(stages, "trim", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        hrbfnpr_model* trimmed = nullptr;
        const auto status =
            attempt([&] { return hrbfnpr_model_trim(half_model_.get(), nullptr, attempt.operation, &trimmed, error); });
        const Model owned(trimmed);
        EXPECT_EQ(trimmed != nullptr, status == HRBFNPR_STATUS_OK);
        if (!owned) return status;
        auto info = made(hrbfnpr_trim_info_init);
        EXPECT_EQ(hrbfnpr_model_get_trim_info(trimmed, &info, nullptr), HRBFNPR_STATUS_OK);
        append(bytes, std::vector<double>{info.share, info.farthest, info.spacing});
        append_value(bytes, info.parts);
        return status;
    });
}

void Stages::add_meshes(std::vector<Stage>& stages) {
    add(stages, "mesh.create", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        hrbfnpr_mesh* mesh = nullptr;
        const Triangles& ball = triangles_;
        const hrbfnpr_mesh_desc desc = mesh_desc(ball);
        const auto status =
            attempt([&] { return hrbfnpr_mesh_create(context_.get(), &desc, attempt.operation, &mesh, error); });
        EXPECT_EQ(mesh != nullptr, status == HRBFNPR_STATUS_OK);
        if (const Mesh owned(mesh); owned) append(bytes, mesh);
        return status;
    });
    add(stages, "mesh.sample", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        std::vector<double> points(3 * 100), normals(3 * 100);
        const hrbfnpr_array_out to = out(points), directions = out(normals);
        const auto status = attempt(
            [&] { return hrbfnpr_mesh_sample(mesh_.get(), nullptr, &to, &directions, attempt.operation, error); });
        if (status == HRBFNPR_STATUS_OK) append(bytes, points), append(bytes, normals);
        return status;
    });
    add(stages, "mesh.edges", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        const auto faces = static_cast<std::size_t>(triangles_.triangles.size() / 3);
        std::vector<std::int32_t> patch(faces), sharp(3 * faces);
        const hrbfnpr_array_out patches = out(patch, 1), sides = out(sharp, 3);
        auto desc = made(hrbfnpr_mesh_edges_desc_init);
        desc.edges = HRBFNPR_EDGES_SHARP;
        desc.crease_angle = 20.0;
        const auto status = attempt([&] {
            return hrbfnpr_mesh_edges(mesh_.get(), &desc, &patches, &sides, nullptr, attempt.operation, error);
        });
        if (status == HRBFNPR_STATUS_OK) append(bytes, patch), append(bytes, sharp);
        return status;
    });
    add(stages, "farthest_points", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        std::vector<std::int32_t> index(50);
        std::vector<double> distance(50);
        const hrbfnpr_array from = in(dense_.points);
        const hrbfnpr_array_out to = out(index, 1), distances = out(distance, 1);
        const auto status = attempt(
            [&] { return hrbfnpr_farthest_points(context_.get(), &from, &to, &distances, attempt.operation, error); });
        if (status == HRBFNPR_STATUS_OK) append(bytes, index), append(bytes, distance);
        return status;
    });
    add(stages, "mesh.compare", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        auto desc = made(hrbfnpr_compare_desc_init);
        desc.points = 200;
        desc.cell_size = 0.6;
        auto c = made(hrbfnpr_comparison_init);
        const auto status = attempt(
            [&] { return hrbfnpr_model_compare_mesh(model_.get(), mesh_.get(), &desc, &c, attempt.operation, error); });
        if (status == HRBFNPR_STATUS_OK)
            append(bytes, std::vector<double>{c.surface_mean, c.surface_p99, c.mesh_mean, c.mesh_p99, c.invented_share,
                                              c.missed_share, c.normal_mean});
        return status;
    });
    add_mesh_fit(stages, "mesh.fit", mesh_, HRBFNPR_EDGES_SMOOTH);
    add_mesh_fit(stages, "mesh.fit.sharp", solid_, HRBFNPR_EDGES_AUTO);
}

void Stages::add_mesh_fit(std::vector<Stage>& stages, const char* name, const Mesh& mesh, std::uint32_t edges) {
    add(stages, name, [&mesh, edges](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        auto desc = made(hrbfnpr_mesh_fit_desc_init);
        desc.tolerance = 0.5;
        desc.maximum_centres = 16;
        desc.candidates = 1000;
        desc.edges = edges;
        hrbfnpr_model* model = nullptr;
        const auto status = attempt([&] {
            return hrbfnpr_model_fit_mesh(mesh.get(), &desc, nullptr, nullptr, attempt.operation, &model, error);
        });
        EXPECT_EQ(model != nullptr, status == HRBFNPR_STATUS_OK);
        if (const Model owned(model); owned) append(bytes, owned);
        return status;
    }).most_refusals = 60;
}

} // namespace api_test
