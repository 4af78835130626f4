// SPDX-License-Identifier: MIT
// What every step of making a picture is given: the context, the options, the report, memory.
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

// hrbfnpr_picture_desc in full, with copies of its texts and lists; what it leaves at its defaults is that of its
// settings.  A picture keeps it.
class Options {
public:
    // Reads and checks.  Throws Error{invalid_argument} that names the field.  Sources are read elsewhere.
    Options(const hrbfnpr_picture_desc& given, std::shared_ptr<const Settings> of_file, Pool& pool);
    Options(const Options&) = delete;
    Options& operator=(const Options&) = delete;

    // Its texts are copies that this keeps.  Its sources, style, settings, changes, dabs, camera and seed points are
    // not to be read from it but from the members below.
    hrbfnpr_picture_desc desc;
    std::shared_ptr<const Settings> settings; // nullable
    bool takes_style_of_settings = false;     // and their layers of marks: no style is named
    Changes changes;                          // the fields of the settings first, then the caller's
    Vector<hrbfnpr_dab> dabs;                 // the caller's, else those of the settings
    std::optional<Style> style;               // the caller's own, used as it is: its lengths are pixels of this picture
    std::optional<hrbfnpr_camera> camera;     // the caller's own, used as it is
    Points seed_points;                       // empty: not given

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
    // Whether a field of a fit ("kernel") was given, by a change or by settings.
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

// A surface that was made of a source, and what it comes from.
struct Surface {
    Model model;
    Mesh mesh;                                // of a mesh: as it was fitted to; else null
    std::optional<hrbfnpr_mesh_fit_info> fit; // of a mesh, where the fit chose its samples
    std::shared_ptr<const Shape> shape;       // null of a model that was given
    PointSet marks;                           // that were given with a model; else null
};

} // namespace hrbfnpr::picture
