// SPDX-License-Identifier: MIT
// Every kind of long call that takes an operation, on large data.
#pragma once

#include "calls.h"
#include "samples.h"
#include "support/depth_image.h"
#include "support/meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace bench {

// One kind of call: what must be prepared before each run, and the call itself.
struct LongCall {
    std::string name;
    std::function<void()> prepare; // may be empty
    std::function<hrbfnpr_status(hrbfnpr_operation*, hrbfnpr_error*)> call;
};

struct CallSizes {
    std::int64_t samples = 100000;
    std::int64_t marks = 1000000;
    std::int64_t dense = 2048; // samples of a direct fit
    std::int64_t faces = 1000000;
};

// The data that calls work on. Data that takes long to make is made when a call first needs it.
class LongCalls {
public:
    LongCalls(hrbfnpr_context* context, const CallSizes& sizes)
        : context_(context), sizes_(sizes), samples_(bumpy(sizes.samples)), small_(bumpy(4096)),
          dense_(bumpy(sizes.dense)) {
        for (std::int64_t i = 0; i < samples_.count(); ++i)
            if (samples_.points[static_cast<std::size_t>(3 * i + 2)] > -0.2)
                half_.add(row(samples_.points, i), row(samples_.normals, i));
        noisy_ = samples_;
        for (std::size_t i = 0; i < noisy_.points.size(); ++i)
            noisy_.points[i] += 0.004 * std::sin(12.9898 * static_cast<double>(i % 100003));
        for (std::int64_t i = 0; i < sizes.marks; ++i) {
            const auto p = hrbfnpr::test::spiral_point(i, sizes.marks);
            for (const double c : p) points_.push_back(1.01 * c);
        }
        for (const double c : points_) inward_.push_back(-c);
    }

    [[nodiscard]] std::vector<LongCall> all() {
        std::vector<LongCall> calls;
        add_fits(calls);
        add_meshes(calls);
        add_queries(calls);
        add_sets(calls);
        add_lines(calls);
        add_frame(calls, "frame", false);
        add_frame(calls, "frame.lines", true); // a new renderer must find the contours first
        return calls;
    }

private:
    using Row = std::array<double, 3>;

    static Row row(const std::vector<double>& packed, std::int64_t i) {
        const auto at = static_cast<std::size_t>(3 * i);
        return {packed[at], packed[at + 1], packed[at + 2]};
    }

    template <class Desc>
    static Desc defaults(hrbfnpr_status (*init)(Desc*, std::uint32_t)) {
        return hrbfnpr::test::made(init);
    }

    // ---- Fits ------------------------------------------------------------------------------

    static hrbfnpr_fit_desc fit_desc(const Samples& samples) {
        auto desc = defaults(hrbfnpr_fit_desc_init);
        desc.points = view(samples.points);
        desc.normals = view(samples.normals);
        return desc;
    }

    void add_fit(std::vector<LongCall>& calls, const char* name, const hrbfnpr_fit_desc& desc) {
        calls.push_back({name, {}, [this, desc](hrbfnpr_operation* operation, hrbfnpr_error* error) {
                             hrbfnpr_model* model = nullptr;
                             const auto status = hrbfnpr_model_fit(context_, &desc, operation, &model, error);
                             hrbfnpr_model_release(model);
                             return status;
                         }});
    }

    void add_fits(std::vector<LongCall>& calls) {
        add_fit(calls, "fit.iterative", fit_desc(samples_));
        auto direct = fit_desc(dense_);
        direct.solver = HRBFNPR_SOLVER_DIRECT;
        add_fit(calls, "fit.direct", direct);
        auto plain = direct;
        plain.kernel = HRBFNPR_KERNEL_GAUSSIAN;
        plain.polynomial_degree = -1;
        add_fit(calls, "fit.direct_gaussian", plain);
        auto choosing = fit_desc(samples_);
        choosing.tolerance = 2e-4;
        add_fit(calls, "fit.choosing", choosing);
        auto noise = fit_desc(noisy_);
        noise.regularization_mode = HRBFNPR_REGULARIZATION_AUTO;
        noise.outliers = HRBFNPR_REPAIR_DROP;
        noise.tolerance = 0.02;
        add_fit(calls, "fit.noise", noise);
        calls.push_back({"orient", {}, [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
                             auto desc = defaults(hrbfnpr_orient_desc_init);
                             desc.mode = HRBFNPR_NORMALS_NONE;
                             desc.points = view(samples_.points);
                             std::vector<double> normals(samples_.points.size());
                             const hrbfnpr_array_out out = writable(normals, 3);
                             return hrbfnpr_orient(context_, &desc, operation, &out, nullptr, error);
                         }});
        calls.push_back({"smooth_depth_image", [this] { make_depths(); },
                         [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
                             auto desc = defaults(hrbfnpr_depth_image_desc_init);
                             desc.columns = depths_.columns;
                             desc.rows = depths_.rows;
                             desc.points = view(depths_.points);
                             const hrbfnpr_array_out points = writable(smoothed_[0], 3);
                             const hrbfnpr_array_out normals = writable(smoothed_[1], 3);
                             return hrbfnpr_smooth_depth_image(context_, &desc, operation, &points, &normals, nullptr,
                                                               error);
                         }});
        calls.push_back({"trim", [this] { static_cast<void>(half()); },
                         [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
                             hrbfnpr_model* trimmed = nullptr;
                             const auto status = hrbfnpr_model_trim(half(), nullptr, operation, &trimmed, error);
                             hrbfnpr_model_release(trimmed);
                             return status;
                         }});
    }

    // ---- Meshes ----------------------------------------------------------------------------

    void add_meshes(std::vector<LongCall>& calls) {
        calls.push_back({"mesh_create", [this] { static_cast<void>(triangles()); },
                         [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
                             hrbfnpr_mesh* mesh = nullptr;
                             const auto desc = mesh_desc();
                             const auto status = hrbfnpr_mesh_create(context_, &desc, operation, &mesh, error);
                             hrbfnpr_mesh_release(mesh);
                             return status;
                         }});
        calls.push_back({"mesh_sample", [this] { static_cast<void>(mesh()); },
                         [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
                             std::vector<double> points(static_cast<std::size_t>(3 * sizes_.samples));
                             const hrbfnpr_array_out out = writable(points, 3);
                             return hrbfnpr_mesh_sample(mesh(), nullptr, &out, nullptr, operation, error);
                         }});
        calls.push_back({"farthest_points", {}, [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
                             std::vector<std::int32_t> index(static_cast<std::size_t>(sizes_.samples));
                             const hrbfnpr_array from = view(points_);
                             const hrbfnpr_array_out out{index.data(), sizes_.samples, 0, HRBFNPR_SCALAR_INT32, 1};
                             return hrbfnpr_farthest_points(context_, &from, &out, nullptr, operation, error);
                         }});
        calls.push_back({"compare_mesh",
                         [this] { static_cast<void>(mesh()), static_cast<void>(model(small_, small_model_)); },
                         [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
                             auto desc = defaults(hrbfnpr_compare_desc_init);
                             desc.points = sizes_.samples;
                             auto comparison = defaults(hrbfnpr_comparison_init);
                             return hrbfnpr_model_compare_mesh(model(small_, small_model_), mesh(), &desc, &comparison,
                                                               operation, error);
                         }});
        calls.push_back({"fit_mesh", [this] { static_cast<void>(mesh()); },
                         [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
                             auto desc = defaults(hrbfnpr_mesh_fit_desc_init);
                             desc.tolerance = 2e-4;
                             hrbfnpr_model* fitted = nullptr;
                             const auto status =
                                 hrbfnpr_model_fit_mesh(mesh(), &desc, nullptr, nullptr, operation, &fitted, error);
                             hrbfnpr_model_release(fitted);
                             return status;
                         }});
    }

    // ---- Queries ---------------------------------------------------------------------------

    template <class Call>
    void add_query(std::vector<LongCall>& calls, const char* name, bool fresh, Call&& call) {
        calls.push_back({name,
                         [this, fresh] {
                             static_cast<void>(large());
                             if (fresh) load_again();
                         },
                         std::forward<Call>(call)});
    }

    void add_queries(std::vector<LongCall>& calls) {
        add_query(calls, "evaluate.first", true, [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
            return evaluate(again_.get(), operation, error);
        });
        add_query(calls, "evaluate", false, [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
            return evaluate(large(), operation, error);
        });
        add_query(calls, "project", false, [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
            const hrbfnpr_array from = view(points_);
            auto projection = defaults(hrbfnpr_projection_init);
            return hrbfnpr_model_project(large(), &from, nullptr, &projection, operation, error);
        });
        add_query(calls, "curvature", false, [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
            const hrbfnpr_array from = view(points_);
            auto curvature = defaults(hrbfnpr_curvature_init);
            return hrbfnpr_model_curvature(large(), &from, &curvature, operation, error);
        });
        add_query(calls, "contains", false, [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
            const hrbfnpr_array from = view(points_);
            return hrbfnpr_model_contains(large(), &from, nullptr, nullptr, operation, error);
        });
        add_query(calls, "lipschitz", false, [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
            double bound = 0.0;
            return hrbfnpr_model_lipschitz(large(), &bound, operation, error);
        });
        add_query(calls, "cast_rays", false, [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
            hrbfnpr_array from = view(points_), along = view(inward_);
            from.count = along.count = std::min<std::int64_t>(from.count, 10000);
            auto hits = defaults(hrbfnpr_ray_hits_init);
            return hrbfnpr_model_cast_rays(large(), &from, &along, nullptr, &hits, operation, error);
        });
    }

    hrbfnpr_status evaluate(const hrbfnpr_model* model, hrbfnpr_operation* operation, hrbfnpr_error* error) {
        std::vector<double> values(points_.size() / 3), gradients(points_.size());
        const hrbfnpr_array from = view(points_);
        const hrbfnpr_array_out value = writable(values, 1), gradient = writable(gradients, 3);
        return hrbfnpr_model_evaluate(model, &from, &value, &gradient, nullptr, operation, error);
    }

    // ---- Marks and lines -------------------------------------------------------------------

    void add_set(std::vector<LongCall>& calls, const std::string& name, const Generation& desc) {
        calls.push_back({name, [this] { static_cast<void>(large()); },
                         [this, desc](hrbfnpr_operation* operation, hrbfnpr_error* error) {
                             Generation own = desc;
                             hrbfnpr_point_set* set = nullptr;
                             const auto status =
                                 hrbfnpr_point_set_generate(context_, large(), own.get(), operation, &set, error);
                             hrbfnpr_point_set_release(set);
                             return status;
                         }});
    }

    void add_sets(std::vector<LongCall>& calls) {
        add_set(calls, "generate.stipples", one_layer(HRBFNPR_LAYER_KIND_STIPPLES, sizes_.marks));
        Generation lines = one_layer(HRBFNPR_LAYER_KIND_HATCH, sizes_.marks);
        add_set(calls, "generate.hatch", lines);
        lines.layer[0].guide = HRBFNPR_HATCH_GUIDE_COMBING;
        add_set(calls, "generate.hatch_combing", lines);
        lines.layer[0].direction_function = along_y;
        add_set(calls, "generate.hatch_function", lines);
        Generation curved = one_layer(HRBFNPR_LAYER_KIND_STIPPLES, sizes_.marks);
        curved.layer[0].density = HRBFNPR_DENSITY_CURVATURE;
        add_set(calls, "generate.density", curved);
        for (const std::uint32_t kind : {HRBFNPR_LAYER_KIND_STIPPLES, HRBFNPR_LAYER_KIND_HATCH}) {
            Generation published = one_layer(kind, sizes_.marks);
            published.distribution = HRBFNPR_DISTRIBUTION_PUBLISHED;
            add_set(calls, kind == HRBFNPR_LAYER_KIND_STIPPLES ? "generate.published" : "generate.published_strokes",
                    published);
        }
        calls.push_back({"step_patches", [this] { static_cast<void>(large()); },
                         [this](hrbfnpr_operation* operation, hrbfnpr_error* error) {
                             std::vector<double> corners(12000);
                             const hrbfnpr_array_out out = writable(corners, 12);
                             return hrbfnpr_point_set_step_patches(context_, large(), nullptr, &out, nullptr, operation,
                                                                   error);
                         }});
    }

    void add_line_set(std::vector<LongCall>& calls, const char* name, bool curved) {
        calls.push_back({name, [this] { static_cast<void>(large()); },
                         [this, curved](hrbfnpr_operation* operation, hrbfnpr_error* error) {
                             std::array<hrbfnpr_line_desc, 3> lines{};
                             const std::array<std::uint32_t, 3> kinds{HRBFNPR_LINE_KIND_RIDGE, HRBFNPR_LINE_KIND_VALLEY,
                                                                      HRBFNPR_LINE_KIND_PARABOLIC};
                             for (std::size_t i = 0; i < 3; ++i) {
                                 lines[i] = defaults(hrbfnpr_line_desc_init);
                                 lines[i].kind = kinds[i];
                             }
                             auto desc = defaults(hrbfnpr_line_set_desc_init);
                             if (curved) {
                                 desc.flags = HRBFNPR_LINE_SET_WITH_CURVATURE;
                                 desc.lines = lines.data();
                                 desc.line_count = 3;
                             }
                             hrbfnpr_line_set* set = nullptr;
                             const auto status =
                                 hrbfnpr_line_set_create(context_, large(), &desc, operation, &set, error);
                             hrbfnpr_line_set_release(set);
                             return status;
                         }});
    }

    void add_lines(std::vector<LongCall>& calls) {
        add_line_set(calls, "line_set", false);
        add_line_set(calls, "line_set.curved", true);
        add_page(calls, "page.svg", HRBFNPR_PAGE_FORMAT_SVG);
        add_page(calls, "page.pdf", HRBFNPR_PAGE_FORMAT_PDF);
        add_page(calls, "page.hpgl", HRBFNPR_PAGE_FORMAT_HPGL);
        add_page(calls, "page.dxf", HRBFNPR_PAGE_FORMAT_DXF);
    }

    void add_frame(std::vector<LongCall>& calls, const char* name, bool lines) {
        calls.push_back({name,
                         [this, lines] {
                             static_cast<void>(marks());
                             if (lines) static_cast<void>(line_set());
                             renew_renderer();
                         },
                         [this, lines](hrbfnpr_operation* operation, hrbfnpr_error* error) {
                             hrbfnpr_drawing* drawing = nullptr;
                             const auto status = draw(lines ? line_set() : nullptr, operation, &drawing, error);
                             hrbfnpr_drawing_release(drawing);
                             return status;
                         }});
    }

    void add_page(std::vector<LongCall>& calls, const char* name, std::uint32_t format) {
        calls.push_back({name, [this] { static_cast<void>(drawing()); },
                         [this, format](hrbfnpr_operation* operation, hrbfnpr_error* error) {
                             auto item = defaults(hrbfnpr_page_item_init);
                             item.drawing = drawing();
                             auto desc = defaults(hrbfnpr_page_desc_init);
                             desc.format = format;
                             desc.items = &item;
                             desc.item_count = 1;
                             return hrbfnpr_page_write(context_, &desc, ignore, nullptr, nullptr, operation, error);
                         }});
    }

    static std::int32_t along_y(void*, std::int64_t count, const double*, const double*, double* direction) {
        for (std::int64_t i = 0; i < count; ++i) {
            direction[3 * i] = direction[3 * i + 2] = 0.0;
            direction[3 * i + 1] = 1.0;
        }
        return 0;
    }
    static std::int32_t ignore(void*, const void*, std::uint64_t) { return 0; }

    // ---- Data that is made once -------------------------------------------------------------

    static hrbfnpr_array_out writable(std::vector<double>& numbers, std::uint32_t components) {
        return {numbers.data(), static_cast<std::int64_t>(numbers.size() / components), 0, HRBFNPR_SCALAR_FLOAT64,
                components};
    }

    const hrbfnpr_model* model(const Samples& samples, scenes::Model& kept) {
        if (!kept) kept = fit(context_, samples.points, samples.normals);
        return kept.get();
    }
    const hrbfnpr_model* half() { return model(half_, half_model_); }
    void make_depths() { // and allocates the results, which are so large that it takes time, too
        if (!depths_.points.empty()) return;
        depths_ = hrbfnpr::test::seen_depths(1280, 960, {0.0014, 0.0, 1.0});
        for (auto& numbers : smoothed_) numbers.resize(depths_.points.size());
    }

public:
    [[nodiscard]] const hrbfnpr_model* large() {
        if (!large_model_) {
            static_cast<void>(model(samples_, large_model_));
            scenes::Check check;
            check(evaluate(large_model_.get(), nullptr, check.error())); // prepares the evaluation
        }
        return large_model_.get();
    }
    [[nodiscard]] const hrbfnpr_line_set* line_set() {
        if (!lines_) {
            scenes::Check check;
            const auto desc = defaults(hrbfnpr_line_set_desc_init);
            hrbfnpr_line_set* made = nullptr;
            check(hrbfnpr_line_set_create(context_, large(), &desc, nullptr, &made, check.error()));
            lines_.reset(made);
        }
        return lines_.get();
    }
    [[nodiscard]] const hrbfnpr_point_set* marks() {
        if (!marks_) marks_ = generate(context_, large(), one_layer(HRBFNPR_LAYER_KIND_STIPPLES, sizes_.marks));
        return marks_.get();
    }
    // The drawing of the marks from the front, in 1280 x 720 pixels.
    [[nodiscard]] const hrbfnpr_drawing* drawing() {
        if (!drawing_) {
            scenes::Check check;
            renew_renderer();
            drawing_ = draw();
        }
        return drawing_.get();
    }
    [[nodiscard]] scenes::Drawing draw() {
        scenes::Check check;
        hrbfnpr_drawing* made = nullptr;
        check(draw(nullptr, nullptr, &made, check.error()));
        return scenes::Drawing(made);
    }

private:
    hrbfnpr_status draw(const hrbfnpr_line_set* lines, hrbfnpr_operation* operation, hrbfnpr_drawing** drawing,
                        hrbfnpr_error* error) {
        scenes::Check check;
        auto camera = defaults(hrbfnpr_camera_init);
        const Row low{-1.2, -1.2, -1.2}, high{1.2, 1.2, 1.2}, direction{0, 0.3, -1}, up{0, 1, 0};
        check(hrbfnpr_camera_fit_bounds(&camera, low.data(), high.data(), direction.data(), up.data(), 0.6, 1280, 720,
                                        0.05, check.error()));
        static Style style(HRBFNPR_PRESET_CONTOUR_AND_STIPPLE);
        auto item = defaults(hrbfnpr_item_init);
        item.point_set = marks();
        item.style = style.get();
        item.line_set = lines;
        return hrbfnpr_renderer_draw_with_operation(renderer_.get(), &item, 1, 0, &camera, operation, drawing, error);
    }
    void renew_renderer() {
        scenes::Check check;
        hrbfnpr_renderer* made = nullptr;
        check(hrbfnpr_renderer_create(context_, &made, check.error()));
        renderer_.reset(made);
    }
    // Loads the large model from memory, so that nothing is prepared.
    void load_again() {
        scenes::Check check;
        if (saved_.empty()) {
            std::int64_t size = 0;
            hrbfnpr_model_save_memory(large(), nullptr, 0, &size, nullptr);
            saved_.resize(static_cast<std::size_t>(size));
            check(hrbfnpr_model_save_memory(large(), saved_.data(), size, &size, check.error()));
        }
        hrbfnpr_model* loaded = nullptr;
        check(hrbfnpr_model_load_memory(context_, saved_.data(), static_cast<std::int64_t>(saved_.size()), &loaded,
                                        check.error()));
        again_.reset(loaded);
    }

    const hrbfnpr::test::Triangles& triangles() {
        if (triangles_.triangles.empty()) {
            const auto along = static_cast<int>(std::sqrt(static_cast<double>(sizes_.faces) / 4.0));
            triangles_ = hrbfnpr::test::torus(2 * along, along, 0.4);
        }
        return triangles_;
    }
    hrbfnpr_mesh_desc mesh_desc() {
        auto desc = defaults(hrbfnpr_mesh_desc_init);
        desc.vertices = view(triangles().vertices);
        desc.triangles = {triangles().triangles.data(), static_cast<std::int64_t>(triangles().faces()), 0,
                          HRBFNPR_SCALAR_INT32, 3};
        return desc;
    }
    const hrbfnpr_mesh* mesh() {
        if (!mesh_) {
            scenes::Check check;
            const auto desc = mesh_desc();
            hrbfnpr_mesh* made = nullptr;
            check(hrbfnpr_mesh_create(context_, &desc, nullptr, &made, check.error()));
            mesh_.reset(made);
        }
        return mesh_.get();
    }

    hrbfnpr_context* context_;
    CallSizes sizes_;
    Samples samples_, small_, dense_, half_, noisy_;
    std::vector<double> points_, inward_;
    std::vector<unsigned char> saved_;
    hrbfnpr::test::Triangles triangles_;
    hrbfnpr::test::SeenDepths depths_;
    std::vector<double> smoothed_[2];
    hrbfnpr::test::Mesh mesh_;
    scenes::Model large_model_, small_model_, half_model_, again_;
    scenes::PointSet marks_;
    hrbfnpr::test::LineSet lines_;
    scenes::Renderer renderer_;
    scenes::Drawing drawing_;
};

} // namespace bench
