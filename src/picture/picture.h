// SPDX-License-Identifier: MIT
// Defines the handle of a picture: the plan for a source, ready to be drawn.
//
// A picture is made in this order:
//
//   options.cpp         checks the descriptor and completes it by settings
//   sources.cpp         turns arrays into shapes
//   points.cpp          points: repairs, normals, samples, fit, end of the surface
//   mesh_surface.cpp    meshes: repairs, edges, division of coarse faces, groups of parts, fit, end of the surface
//   up.cpp, look.cpp    find the up direction and the camera
//   plan.cpp            sizes the style for the picture, and plans the marks that fill its darkest tone
//   lines.cpp           traces lines of the surface
//   ground.cpp          finds the ground, and places its marks
//   blank.cpp           checks whether anything can be seen
//   plate.cpp, page.cpp add the scale bar and section, and put the drawing on paper
//   report.cpp          reports all of it
#pragma once

#include "picture/call.h"
#include "picture/ground.h"
#include "picture/look.h"
#include "picture/mark_fields.h"
#include "picture/plan.h"
#include "picture/source_fields.h"
#include "picture/sources.h"
#include "picture/style.h"

#include "api/handles.h"

#include <array>
#include <mutex>

struct hrbfnpr_settings : hrbfnpr::api::Child {
    explicit hrbfnpr_settings(hrbfnpr_context& context) : Child(context), pool(context.runtime.memory) {}

    hrbfnpr::picture::Pool pool;
    std::shared_ptr<const hrbfnpr::picture::Settings> settings;
};

namespace hrbfnpr::picture {

// The surfaces of all sources. Pictures with different styles share them.
struct Surfaces {
    explicit Surfaces(Pool& pool) : list(&pool), values(pool), probes(&pool), places(&pool), name(&pool) {}

    // The surfaces, source by source; the largest surface of each source comes first. Empty for a point set.
    Vector<Surface> list;
    SourceFields values;  // the values at the points of each source
    Vector<Probe> probes; // One probe for each surface. Empty if the picture has only surfaces (SURFACE_ONLY).
    PointSet marks;       // marks that were given without a model, else null
    Points places;        // places spread over all surfaces
    glm::dvec3 up{0.0, 1.0, 0.0};
    String name; // the name of the first source
};

// The marks and lines of one surface.
struct Part {
    PointSet marks; // For a still picture, only the marks that the planned camera needs.
    PointSet whole; // All marks of a still picture, once another camera needed them; else null.
    LineSet lines;
    std::uint32_t sides = HRBFNPR_SIDES_FRONT;
};

// The light that reaches the marks of each part.
struct ShadedMarks {
    explicit ShadedMarks(Pool& pool) : of_part(&pool) {}

    Vector<Shading> of_part;       // empty if it is not known
    std::array<double, 16> view{}; // the view matrix of the camera whose lights cast the shadows
};

// Marks and lines that pictures of the same surfaces reuse.
struct MadeParts {
    explicit MadeParts(Pool& pool) : still_key(&pool), lines_key(&pool), parts(&pool) {}

    std::optional<Marks> marks; // the marks as they were planned
    Vector<double> still_key;   // the key of the drawing, see key_of_still(); empty if all marks were placed
    String lines_key;           // the key of the lines, see key_of_lines()
    bool has_lines = false;
    Vector<Part> parts;
};

} // namespace hrbfnpr::picture

struct hrbfnpr_picture : hrbfnpr::api::Child {
    // `root` is the picture whose surfaces this picture shares. If it is null, this picture has separate surfaces.
    hrbfnpr_picture(hrbfnpr_context& context, const hrbfnpr_picture_desc& desc, const hrbfnpr_picture* root)
        : Child(context), root_(root), settings_(desc.settings), pool(context.runtime.memory),
          options(desc, settings_ != nullptr ? settings_->settings : nullptr, pool),
          report(pool, desc.wording, desc.on_event, desc.event_user, context, nullptr), own_surfaces(pool),
          parts(&pool), shaded(pool), shaded_whole(pool), shaded_ground(pool), shaded_whole_ground(pool), made(&pool) {}

    [[nodiscard]] const hrbfnpr_picture& root() const noexcept { return root_ != nullptr ? *root_ : *this; }
    [[nodiscard]] const hrbfnpr::picture::Surfaces& surfaces() const noexcept { return root().own_surfaces; }
    [[nodiscard]] hrbfnpr::geometry::Bounds bounds() const;
    [[nodiscard]] hrbfnpr::picture::Call call() noexcept { return {context(), options, report, pool}; }
    [[nodiscard]] std::int64_t mark_count() const;
    // Returns whether at first only the marks that the planned camera needs are placed.
    [[nodiscard]] bool is_still() const noexcept;

private:
    // These references are destroyed last, because the members below use memory of the root and of the settings.
    const hrbfnpr_picture* root_;
    hrbfnpr::api::HandleHold<const hrbfnpr_picture> root_hold_{root_};
    const hrbfnpr_settings* settings_;
    hrbfnpr::api::HandleHold<const hrbfnpr_settings> settings_hold_{settings_};

public:
    mutable hrbfnpr::picture::Pool pool; // Several threads may allocate from the pool at the same time.
    hrbfnpr::picture::Options options;
    hrbfnpr::picture::Report report;
    hrbfnpr::picture::Surfaces own_surfaces; // empty if this picture shares the surfaces of the root
    hrbfnpr::picture::View view;
    hrbfnpr_camera camera{};
    std::optional<hrbfnpr::picture::Style> style; // empty if the picture has only surfaces (SURFACE_ONLY)
    // The fields that the marks need; empty if the style uses none.
    std::optional<hrbfnpr::picture::MarkFields> fields;
    hrbfnpr_style style_view{};                   // a view of `style` for callers, with the layers of `fields`
    std::optional<hrbfnpr::picture::Marks> marks; // the planned marks; empty if marks were given
    hrbfnpr_generate_desc marks_view{};
    hrbfnpr::picture::Vector<hrbfnpr::picture::Part> parts;
    // What casts shadows, and the light that reaches the marks, and all marks of a still picture. Null and empty if the
    // style needs none.
    hrbfnpr::picture::Occluders occluders;
    hrbfnpr::picture::ShadedMarks shaded, shaded_whole;
    std::optional<hrbfnpr::picture::Ground> ground; // empty if no ground is drawn
    hrbfnpr::picture::ShadedMarks shaded_ground, shaded_whole_ground;
    hrbfnpr::picture::Renderer renderer;
    double pen = 0.0;
    double seconds = 0.0;

    // Guards the marks and lines for reuse by pictures of the same surfaces. The root keeps them.
    mutable std::mutex making;
    mutable hrbfnpr::picture::Vector<hrbfnpr::picture::MadeParts> made;
};
