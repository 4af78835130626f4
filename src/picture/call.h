// SPDX-License-Identifier: MIT
// What every step of making a picture is given: the context, the options, the report, memory.
#pragma once

#include "picture/changes.h"
#include "picture/handles.h"
#include "picture/report.h"
#include "picture/settings.h"
#include "picture/shape.h"

#include <hrbfnpr.h>

#include <optional>

namespace hrbfnpr::picture {

// hrbfnpr_picture_desc in full, with copies of its texts and lists; what it leaves at its defaults is that of its
// settings.  Kept by the picture.
class Options {
public:
    // Reads and checks.  Throws Error{invalid_argument} that names the field.
    Options(const hrbfnpr_picture_desc& given, Pool& pool);

    hrbfnpr_picture_desc desc; // sources, changes, dabs, style and settings are not to be read from it but from below
    Changes changes;
    Vector<hrbfnpr_dab> dabs;
    std::shared_ptr<const Settings> settings; // nullable

    [[nodiscard]] bool has(std::uint32_t flag) const noexcept { return (desc.flags & flag) != 0; }
    [[nodiscard]] bool is_find() const noexcept { return desc.preset == HRBFNPR_PRESET_ARCHAEOLOGICAL; }
    [[nodiscard]] bool has_up() const noexcept { return desc.up[0] != 0 || desc.up[1] != 0 || desc.up[2] != 0; }
    [[nodiscard]] bool has_direction() const noexcept {
        return desc.direction[0] != 0 || desc.direction[1] != 0 || desc.direction[2] != 0;
    }
    [[nodiscard]] bool has_eye() const noexcept { return desc.eye[0] == desc.eye[0]; }
    [[nodiscard]] bool has_target() const noexcept { return desc.target[0] == desc.target[0]; }
    [[nodiscard]] std::optional<glm::dvec3> viewpoint() const noexcept;
    // Whether a field of a fit ("kernel") was given, by a change or by settings.
    [[nodiscard]] bool gives_fit(std::string_view field) const noexcept;
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
