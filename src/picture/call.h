// SPDX-License-Identifier: MIT
// Declares the arguments of every step of making a picture: the context, the options, the report, and memory.
#pragma once

#include "picture/changes.h"
#include "picture/handles.h"
#include "picture/report.h"
#include "picture/settings.h"
#include "picture/shape.h"

#include <hrbfnpr.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string_view>

namespace hrbfnpr::picture {

// A complete hrbfnpr_picture_desc with copies of its texts and lists. Fields that the caller leaves at their defaults
// come from the settings. A picture keeps its options.
class Options {
public:
    // Reads and checks a descriptor. Throws Error{invalid_argument} that names the wrong field. Sources are read
    // elsewhere.
    Options(const hrbfnpr_picture_desc& given, std::shared_ptr<const Settings> of_file, Pool& pool);
    Options(const Options&) = delete;
    Options& operator=(const Options&) = delete;

    // The descriptor. Its texts point to copies that this object keeps. Do not read its sources, style, settings,
    // changes, dabs, camera or seed points: use the members below instead.
    hrbfnpr_picture_desc desc;
    std::shared_ptr<const Settings> settings; // may be null
    // True if the caller names no style, so that the style and layers come from the settings.
    bool takes_style_of_settings = false;
    Changes changes;                      // The changes from the settings, followed by the caller's changes.
    Vector<hrbfnpr_dab> dabs;             // The caller's dabs, or else the dabs of the settings.
    std::optional<Style> style;           // The caller's style, which is used unchanged, with lengths in pixels.
    std::optional<hrbfnpr_camera> camera; // The caller's camera, which is used unchanged.
    Points seed_points;                   // The caller's seed points; may be empty.

    [[nodiscard]] bool has(std::uint32_t flag) const noexcept { return (desc.flags & flag) != 0; }
    [[nodiscard]] bool is_find() const noexcept { return desc.preset == HRBFNPR_PRESET_ARCHAEOLOGICAL; }
    [[nodiscard]] bool has_up() const noexcept { return desc.up[0] != 0 || desc.up[1] != 0 || desc.up[2] != 0; }
    [[nodiscard]] bool has_direction() const noexcept {
        return desc.direction[0] != 0 || desc.direction[1] != 0 || desc.direction[2] != 0;
    }
    [[nodiscard]] bool has_eye() const noexcept { return !std::isnan(desc.eye[0]); }
    [[nodiscard]] bool has_target() const noexcept { return !std::isnan(desc.target[0]); }
    [[nodiscard]] std::optional<glm::dvec3> viewpoint() const noexcept {
        if (std::isnan(desc.viewpoint[0])) return std::nullopt;
        return glm::dvec3(desc.viewpoint[0], desc.viewpoint[1], desc.viewpoint[2]);
    }
    [[nodiscard]] bool wants_ground() const noexcept { return desc.ground != HRBFNPR_PICTURE_GROUND_NONE; }
    // Returns whether a change or the settings give a value to a field of the fit, such as "kernel".
    [[nodiscard]] bool gives_fit(std::string_view field) const noexcept;

private:
    void use_settings();

    Vector<String> texts_;
};

struct Call {
    hrbfnpr_context& context;
    const Options& options;
    Report& report;
    Pool& pool;
};

// A surface with the source that it was made from.
struct Surface {
    Model model;
    Mesh mesh;                                // The mesh that the model was fitted to; null without a mesh.
    std::optional<hrbfnpr_mesh_fit_info> fit; // Set if the source is a mesh and the fit chose its samples.
    std::shared_ptr<const Shape> shape;       // Null if the caller gave a model.
    std::size_t source = 0;                   // The number of the source that it was made from.
    PointSet marks;                           // The marks that the caller gave with a model; null without them.
};

} // namespace hrbfnpr::picture
