// SPDX-License-Identifier: MIT
// The list of stages, and the objects that they share.
#pragma once

#include "stages/stage.h"
#include "support/depth_image.h"
#include "support/meshes.h"
#include "support/samples.h"

#include <array>

namespace api_test {

using hrbfnpr::test::LineSet;
using hrbfnpr::test::Occluders;
using hrbfnpr::test::Shading;

class Stages {
public:
    explicit Stages(const Context& context, const StageSizes& sizes = {});
    Stages(const Stages&) = delete;
    Stages& operator=(const Stages&) = delete;

    // Returns every kind of call, from samples to pages.
    [[nodiscard]] std::vector<Stage> all();

private:
    void add_fits(std::vector<Stage>& stages);
    void add_meshes(std::vector<Stage>& stages);
    void add_queries(std::vector<Stage>& stages);
    void add_marks(std::vector<Stage>& stages);
    void add_files(std::vector<Stage>& stages);
    void add_frames(std::vector<Stage>& stages);
    void add_lights(std::vector<Stage>& stages);
    void add_fields(std::vector<Stage>& stages);
    void add_readers(std::vector<Stage>& stages);
    void add_pages(std::vector<Stage>& stages);
    void add_pictures(std::vector<Stage>& stages);

    void add_fit(std::vector<Stage>& stages, const char* name, const hrbfnpr_fit_desc& desc);
    static void add_mesh_fit(std::vector<Stage>& stages, const char* name, const Mesh& mesh, std::uint32_t edges);
    void add_set(std::vector<Stage>& stages, const std::string& name, const Generation& desc);
    void add_line_set(std::vector<Stage>& stages, const char* name, bool curved);
    void add_frame(std::vector<Stage>& stages, const std::string& name, const hrbfnpr_style& style, bool lines,
                   std::uint32_t sides = HRBFNPR_SIDES_FRONT, const hrbfnpr_shading* shading = nullptr);
    void add_page(std::vector<Stage>& stages, const char* name, std::uint32_t format, std::uint32_t flags);
    // Adds stages that make, draw and read (as an image) a picture of one source. `picture` refers to arrays that live
    // as long as the stages. `uses` is the value of the change "style.field".
    void add_picture(std::vector<Stage>& stages, const char* name, const hrbfnpr_picture_source& source,
                     std::uint32_t preset, const char* uses = "");
    [[nodiscard]] hrbfnpr_picture_desc picture_desc() const;

    void add_field(std::vector<Stage>& stages, const char* name, const hrbfnpr_field_desc& desc);
    [[nodiscard]] hrbfnpr_field_desc vertex_field_desc(bool with_triangles) const;
    [[nodiscard]] hrbfnpr_field_desc dab_field_desc();
    [[nodiscard]] hrbfnpr_field_desc image_field_desc();

    [[nodiscard]] hrbfnpr_camera camera() const;
    [[nodiscard]] hrbfnpr_item lit_item();
    void make_shading();
    [[nodiscard]] const hrbfnpr_drawing* drawing();
    void renew_renderer();

    const Context& context_;
    StageSizes sizes_;
    hrbfnpr::test::Samples samples_, dense_, cloud_, half_;
    hrbfnpr::test::Triangles triangles_;
    hrbfnpr::test::SeenDepths depths_;
    std::vector<double> places_, directions_, uneven_;
    Model model_, half_model_;
    PointSet set_;
    LineSet curved_lines_;
    std::array<hrbfnpr_layer_style, 3> layer_styles_{};
    std::array<hrbfnpr_line_style, 4> line_styles_{};
    std::array<hrbfnpr_light, 2> lights_{};
    std::array<hrbfnpr_line_style, 2> shadow_lines_{};
    hrbfnpr_style lit_style_{};
    hrbfnpr::test::Field ways_, waves_;
    std::array<hrbfnpr_dab, 3> dabs_{};
    std::vector<std::uint8_t> pixels_;
    hrbfnpr_image image_{};
    hrbfnpr_camera image_camera_{};
    Occluders occluders_;
    Shading shading_;
    Mesh mesh_, solid_;
    Renderer renderer_;
    Drawing drawing_;
    std::array<hrbfnpr_change, 3> changes_{};
    hrbfnpr_source_field field_{};
    Picture picture_;
    Drawing picture_drawing_;
};

} // namespace api_test
