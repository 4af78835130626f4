// SPDX-License-Identifier: MIT
// Reads and writes files of settings, which hold a descriptor as JSON (docs/settings.md).
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

// The camera of a file: an eye and a target, or two matrices.
struct SavedCamera {
    bool has_matrices = false;
    std::array<double, 3> eye{};
    std::array<double, 3> target{};
    std::array<double, 3> up{};
    double vertical_angle = 0.0; // radians; 0 for an orthographic camera
    double view_height = 0.0;    // used by orthographic cameras
    double near_plane = 0.0;
    double far_plane = 0.0;
    std::array<double, 16> view{}; // column-major
    std::array<double, 16> projection{};
};

struct Settings {
    explicit Settings(Pool& pool)
        : style(preset, pool), marks(pool), fields(&pool), lines(&pool), dabs(&pool), texts(pool) {}
    Settings(const Settings&) = delete;
    Settings& operator=(const Settings&) = delete;

    std::uint32_t preset = HRBFNPR_PRESET_CONTOUR_AND_STIPPLE;
    std::optional<std::array<std::int32_t, 2>> size;
    double pen = 0.0; // 0 asks for an automatic choice.
    Style style;
    bool has_layers = false; // whether `marks` has layers
    Marks marks;             // Only its layers are used. The fields of its base are in `fields`.
    // The remaining fields as paths and texts of changes: "fit.kernel", "mesh_fit.edges", "line_set.support",
    // "marks.distribution". "fit.regularization" is "auto" where the file chooses this mode.
    Vector<std::pair<String, String>> fields;
    bool has_lines = false; // whether `lines` was given: the lines that are found once
    Vector<hrbfnpr_line_desc> lines;
    Vector<hrbfnpr_dab> dabs;
    std::optional<SavedCamera> saved_camera;
    KeptTexts texts; // holds the texts that `lines` points to

    // Returns the camera for a picture of this size, or nothing if the file has none. Throws Error{invalid_argument} if
    // the camera is impossible.
    [[nodiscard]] std::optional<hrbfnpr_camera> camera(std::int32_t width, std::int32_t height) const;
};

// Reads a file of settings. Throws Error{invalid_argument} that names the key and the values it may have.
[[nodiscard]] std::shared_ptr<const Settings> read_settings(std::string_view json, Pool& pool);

// The inputs of a picture besides its options.
struct PictureParts {
    std::uint32_t preset;
    const hrbfnpr_camera& camera;             // the planned camera, whose viewport is the picture
    const Style& style;                       // the style as planned, in pixels of this picture
    const Marks* marks;                       // the marks as planned; nullptr if no marks were made
    std::span<const hrbfnpr_line_desc> lines; // lines that are found once, without the caller's own
};

struct WrittenSettings {
    String json;
    // The given options that settings cannot hold, as markers for in_words(): "{samples}, {flip!}".
    String not_held;
};

// Writes settings that draw the same picture of the same source.
[[nodiscard]] WrittenSettings write_settings(const Options& options, const PictureParts& parts, Pool& pool);

} // namespace hrbfnpr::picture
