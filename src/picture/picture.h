// SPDX-License-Identifier: MIT
// A picture as a handle: what was planned for a source, ready to be drawn.
//
// How a picture comes about, in order:
//
//   options.cpp         the descriptor is checked, and completed by settings
//   sources.cpp         arrays become shapes
//   points.cpp          points: repairs, normals, samples, fit, end of the surface
//   mesh_surface.cpp    meshes: repairs, edges, division of coarse faces, groups of parts, fit, end of the surface
//   up.cpp, look.cpp    which way is up, and the camera
//   plan.cpp            the style sized for the picture, and the marks that fill its darkest tone
//   lines.cpp           lines of the surface
//   blank.cpp           whether anything can be seen
//   plate.cpp, page.cpp what stands beside the drawing, and paper
//   report.cpp          tells all of it
#pragma once

#include "picture/call.h"
#include "picture/look.h"
#include "picture/plan.h"
#include "picture/sources.h"
#include "picture/style.h"

#include "api/handles.h"

#include <mutex>

struct hrbfnpr_settings : hrbfnpr::api::Child {
    explicit hrbfnpr_settings(hrbfnpr_context& context) : Child(context), pool(context.runtime.memory) {}

    hrbfnpr::picture::Pool pool;
    std::shared_ptr<const hrbfnpr::picture::Settings> settings;
};

namespace hrbfnpr::picture {

// The surfaces that were made of all sources, which pictures of other styles share.
struct Surfaces {
    explicit Surfaces(Pool& pool) : list(&pool), probes(&pool), places(&pool), name(&pool) {}

    Vector<Surface> list; // the largest of a source first; empty of a point set
    Vector<Probe> probes; // as many, but with SURFACE_ONLY
    PointSet marks;       // that were given alone; else null
    Points places;        // spread over all of it
    glm::dvec3 up{0.0, 1.0, 0.0};
    String name; // of the first source
};

// A surface as it is drawn.
struct Part {
    PointSet marks;
    LineSet lines;
    std::uint32_t sides = HRBFNPR_SIDES_FRONT;
};

// Marks and lines that pictures of the same surfaces use again.
struct Made {
    explicit Made(Pool& pool) : lines_key(&pool), parts(&pool) {}

    std::optional<Marks> marks; // as they were planned
    String lines_key;           // what the lines were looked for by
    bool has_lines = false;
    Vector<Part> parts;
};

} // namespace hrbfnpr::picture

struct hrbfnpr_picture : hrbfnpr::api::Child {
    // root: the picture whose surfaces this one shares; null: it has its own.
    hrbfnpr_picture(hrbfnpr_context& context, const hrbfnpr_picture_desc& desc, const hrbfnpr_picture* root)
        : Child(context), root_(root), settings_(desc.settings), pool(context.runtime.memory),
          options(desc, settings_ != nullptr ? settings_->settings : nullptr, pool),
          report(pool, desc.wording, desc.on_event, desc.event_user, context, nullptr), own_surfaces(pool),
          parts(&pool), made(&pool) {}

    [[nodiscard]] const hrbfnpr_picture& root() const noexcept { return root_ != nullptr ? *root_ : *this; }
    [[nodiscard]] const hrbfnpr::picture::Surfaces& surfaces() const noexcept { return root().own_surfaces; }
    [[nodiscard]] hrbfnpr::geometry::Bounds bounds() const;
    [[nodiscard]] hrbfnpr::picture::Call call() noexcept { return {context(), options, report, pool}; }
    [[nodiscard]] std::int64_t mark_count() const;

private:
    // Kept to the end: members below use their memory.
    const hrbfnpr_picture* root_;
    hrbfnpr::api::Hold<const hrbfnpr_picture> root_hold_{root_};
    const hrbfnpr_settings* settings_;
    hrbfnpr::api::Hold<const hrbfnpr_settings> settings_hold_{settings_};

public:
    mutable hrbfnpr::picture::Pool pool; // calls of several threads allocate from it at the same time
    hrbfnpr::picture::Options options;
    hrbfnpr::picture::Report report;
    hrbfnpr::picture::Surfaces own_surfaces; // empty where they are the root's
    hrbfnpr::picture::View view;
    hrbfnpr_camera camera{};
    std::optional<hrbfnpr::picture::Style> style; // nothing with SURFACE_ONLY
    hrbfnpr_style style_view{};                   // of it, for callers
    std::optional<hrbfnpr::picture::Marks> marks; // planned; nothing where they were given
    hrbfnpr_generate_desc marks_view{};
    hrbfnpr::picture::Vector<hrbfnpr::picture::Part> parts;
    hrbfnpr::picture::Renderer renderer;
    double pen = 0.0;
    double seconds = 0.0;

    // What pictures of the same surfaces have made, kept by the root.
    mutable std::mutex making;
    mutable hrbfnpr::picture::Vector<hrbfnpr::picture::Made> made;
};
