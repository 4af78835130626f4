// SPDX-License-Identifier: MIT
// A file of settings: a descriptor as JSON (docs/settings.md).
#pragma once

#include "picture/memory.h"
#include "picture/style.h"

#include <hrbfnpr.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace hrbfnpr::picture {

class Options;

// The camera of a file: from an eye towards a target, or as two matrices.
struct SavedCamera {
    bool has_matrices = false;
    std::array<double, 3> eye{};
    std::array<double, 3> target{};
    std::array<double, 3> up{};
    double vertical_angle = 0.0; // radians; 0: orthographic
    double view_height = 0.0;    // of orthographic ones
    double near_plane = 0.0;
    double far_plane = 0.0;
    std::array<double, 16> view{}; // column by column
    std::array<double, 16> projection{};
};

struct Settings {
    explicit Settings(Pool& pool)
        : style(preset, pool), marks(pool), fields(&pool), lines(&pool), dabs(&pool), texts(pool) {}
    Settings(const Settings&) = delete;
    Settings& operator=(const Settings&) = delete;

    std::uint32_t preset = HRBFNPR_PRESET_CONTOUR_AND_STIPPLE;
    std::optional<std::array<std::int32_t, 2>> size;
    double pen = 0.0; // 0: chosen
    Style style;
    bool has_layers = false; // of marks, below
    Marks marks;             // its layers only; the fields of its base are among those below
    // The rest, field by field, as paths and texts of changes: "fit.kernel", "mesh_fit.edges", "line_set.support",
    // "marks.distribution".  "fit.regularization" is "auto" where the file says so by the mode.
    Vector<std::pair<String, String>> fields;
    bool has_lines = false; // to be found once, below
    Vector<hrbfnpr_line_desc> lines;
    Vector<hrbfnpr_dab> dabs;
    std::optional<SavedCamera> saved_camera;
    KeptTexts texts; // that `lines` point to

    // The camera for a picture of this size; nothing: there is none in the file.  Throws Error{invalid_argument} for
    // one that cannot be.
    [[nodiscard]] std::optional<hrbfnpr_camera> camera(std::int32_t width, std::int32_t height) const;
};

// Throws Error{invalid_argument} that names the key and what would be right.
[[nodiscard]] std::shared_ptr<const Settings> read_settings(std::string_view json, Pool& pool);

// What a picture was made with, beside its options.
struct PictureParts {
    std::uint32_t preset;
    const hrbfnpr_camera& camera;             // the planned one, with the size of the picture as viewport
    const Style& style;                       // as planned, in pixels of this picture
    const Marks* marks;                       // as planned; nullptr: none were made
    std::span<const hrbfnpr_line_desc> lines; // found once; those of the caller's are left out
};

struct WrittenSettings {
    String json;
    // The options that were given and that settings cannot hold, as a report's text takes them: "{samples}, {flip!}".
    String not_held;
};

// Writes settings that draw the same picture of the same source.
[[nodiscard]] WrittenSettings write_settings(const Options& options, const PictureParts& parts, Pool& pool);

} // namespace hrbfnpr::picture
