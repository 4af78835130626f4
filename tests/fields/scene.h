// SPDX-License-Identifier: MIT
// A small scene with one of every descriptor; each descriptor can be run through to a picture alone.
#pragma once

#include "api/struct_fields.h"
#include "scenes/shapes.h"
#include "support/allocator.h"
#include "support/depth_image.h"
#include "support/handles.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace fields_test {

struct Outcome {
    hrbfnpr_status status = HRBFNPR_STATUS_OK;
    std::string message;
    bool clean = true; // a failure left its outputs as they were
};

class Scene;

// A descriptor, and the function that runs the calls that begin with it.
struct Slot {
    const char* record;
    std::span<const hrbfnpr::api::FieldLayout> fields;
    std::byte* data;
    std::size_t size;
    Outcome (Scene::*run)();
};

class Scene {
public:
    Scene();
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    std::vector<Slot> slots(); // one for each descriptor
    // Cancels the calls that take an operation when `time` has passed.
    static constexpr std::chrono::milliseconds plenty{60'000}; // for calls that must end
    void take_time(std::chrono::milliseconds time);

private:
    using Clock = std::chrono::steady_clock;

    Outcome create_context();
    Outcome fit();
    Outcome orient();
    Outcome smooth_depth_image();
    Outcome create_custom();
    Outcome create_csg();
    Outcome project();
    Outcome curvature();
    Outcome cast();
    Outcome trim();
    Outcome generate();
    Outcome create_point_set();
    Outcome create_field();
    Outcome give_field();
    Outcome create_line_set();
    Outcome draw();
    Outcome draw_posed();
    Outcome shade();
    Outcome rasterize();
    Outcome write_vertices();
    Outcome mark_results();
    Outcome create_mesh();
    Outcome sample_mesh();
    Outcome find_mesh_edges();
    Outcome compare_mesh();
    Outcome fit_mesh();
    Outcome write_page();
    Outcome make_picture();
    Outcome write_picture();
    Outcome write_views();

    Outcome picture_of(hrbfnpr_context* context, const hrbfnpr_model* model);
    Outcome picture_of(const hrbfnpr_point_set* set);
    Outcome picture_of(hrbfnpr_renderer* renderer, const hrbfnpr_item& of);
    Outcome outcome(hrbfnpr_status status, bool clean = true) const;
    void connect();
    void describe_surface();
    void describe_marks();
    void describe_fields();
    void describe_style();
    void describe_output();
    void describe_pictures();
    void fill_canaries();
    bool canaries_are_whole(std::span<const std::uint8_t> bytes) const;
    static std::int32_t progress(void* user, double value);

    // Results get room for a larger scalar and more components, too.
    std::vector<double> room(std::size_t numbers) const { return std::vector<double>(16 * numbers); }

    hrbfnpr_error error_{};
    Clock::time_point end_ = Clock::time_point::max();
    hrbfnpr::test::Allocator allocator_;
    scenes::Samples samples_ = scenes::sphere_6();
    std::vector<double> points_, normals_, tangents_, triangles_, up_;
    std::vector<double> result_[6];
    std::vector<std::uint8_t> pixels_, vertices_;
    std::vector<std::uint32_t> firsts_, corners_;
    std::vector<double> numbers_;

    hrbfnpr::test::Context context_;
    hrbfnpr::test::Operation operation_;
    hrbfnpr::test::Model model_;
    hrbfnpr::test::PointSet set_;
    hrbfnpr::test::LineSet lines_;
    hrbfnpr::test::Field density_, way_;
    hrbfnpr::test::Shading shading_;
    hrbfnpr::test::Mesh mesh_;
    hrbfnpr::test::Renderer renderer_;
    hrbfnpr::test::Drawing drawing_;
    hrbfnpr::test::Picture picture_;
    hrbfnpr::test::Drawing picture_drawing_;

    hrbfnpr_context_desc context_desc_{};
    hrbfnpr_fit_desc fit_desc_{};
    hrbfnpr_orient_desc orient_desc_{};
    hrbfnpr_depth_image_desc depth_image_desc_{};
    hrbfnpr::test::SeenDepths depths_ = hrbfnpr::test::seen_depths(16, 12);
    hrbfnpr_custom_desc custom_desc_{};
    hrbfnpr_csg_node csg_node_[3]{};
    hrbfnpr_csg_desc csg_desc_{};
    hrbfnpr_project_desc project_desc_{};
    hrbfnpr_projection projection_{};
    hrbfnpr_curvature curvature_{};
    hrbfnpr_cast_desc cast_desc_{};
    hrbfnpr_ray_hits ray_hits_{};
    hrbfnpr_trim_desc trim_desc_{};
    hrbfnpr_layer_desc layer_desc_[2]{};
    hrbfnpr_generate_desc generate_desc_{};
    hrbfnpr_layer_arrays layer_arrays_{};
    hrbfnpr_point_set_desc point_set_desc_{};
    hrbfnpr_field_desc field_desc_[2]{};
    hrbfnpr_mark_field mark_field_{};
    double turn_[16]{};
    hrbfnpr_line_desc line_desc_[2]{};
    hrbfnpr_line_set_desc line_set_desc_{};
    hrbfnpr_camera camera_{};
    hrbfnpr_layer_style layer_style_{};
    hrbfnpr_line_style line_style_[2]{};
    hrbfnpr_light light_[2]{};
    hrbfnpr_style style_{};
    hrbfnpr_layer_pose pose_{};
    hrbfnpr_item item_{};
    hrbfnpr_item posed_item_{};
    hrbfnpr_item shaded_item_{};
    hrbfnpr_shading_desc shading_desc_{};
    hrbfnpr_image image_{};
    hrbfnpr_raster_desc raster_desc_{};
    hrbfnpr_vertex_attribute vertex_attribute_{};
    hrbfnpr_vertex_layout vertex_layout_{};
    hrbfnpr_mark_results mark_results_{};
    hrbfnpr_mesh_desc mesh_desc_{};
    hrbfnpr_sample_desc sample_desc_{};
    hrbfnpr_mesh_edges_desc mesh_edges_desc_{};
    hrbfnpr_compare_desc compare_desc_{};
    hrbfnpr_mesh_fit_desc mesh_fit_desc_{};
    hrbfnpr_page_item page_item_{};
    hrbfnpr_pen pen_{};
    hrbfnpr_annotation annotation_{};
    hrbfnpr_page_desc page_desc_{};
    std::array<float, 6> quality_{};
    hrbfnpr_source_field source_field_{};
    hrbfnpr_picture_source source_{};
    hrbfnpr_change change_{};
    hrbfnpr_dab dab_{};
    hrbfnpr_picture_desc picture_desc_{};
    hrbfnpr_picture_page_desc picture_page_desc_{};
    hrbfnpr_views_desc views_desc_{};
};

} // namespace fields_test
