// SPDX-License-Identifier: MIT
// Reads and writes settings files, which hold a descriptor as JSON (docs/settings.md).
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

// The camera in a file: an eye and a target, or two matrices.
struct SavedCamera {
    bool has_matrices = false;
    std::array<double, 3> eye{};
    std::array<double, 3> target{};
    std::array<double, 3> up{};
    double vertical_angle = 0.0; // in radians; 0 for an orthographic camera
    double view_height = 0.0;    // only for orthographic cameras
    double near_plane = 0.0;
    double far_plane = 0.0;
    std::array<double, 16> view{}; // in column-major order
    std::array<double, 16> projection{};
};

struct Settings {
    explicit Settings(Pool& pool)
        : style(preset, pool), marks(pool), fields(&pool), lines(&pool), dabs(&pool), texts(pool) {}
    Settings(const Settings&) = delete;
    Settings& operator=(const Settings&) = delete;

    std::uint32_t preset = HRBFNPR_PRESET_CONTOUR_AND_STIPPLE;
    std::optional<std::array<std::int32_t, 2>> size;
    double pen = 0.0; // The pen's radius; 0 asks for an automatic choice.
    Style style;
    bool has_layers = false; // true if `marks` has layers
    Marks marks;             // Only the layers are used. The fields of `marks.base` are in `fields`.
    // All other fields, as paths and texts of changes: "fit.kernel", "mesh_fit.edges", "line_set.support",
    // "marks.distribution". "fit.regularization" is "auto" if the file has that mode.
    Vector<std::pair<String, String>> fields;
    bool has_lines = false; // True if the file gives `lines`, the lines that are found once.
    Vector<hrbfnpr_line_desc> lines;
    Vector<hrbfnpr_dab> dabs;
    std::optional<SavedCamera> saved_camera;
    bool has_ground = false;
    std::optional<double> ground_height; // Without it, the ground is at the lowest place.
    KeptTexts texts;                     // Owns the texts that `lines` points to.

    // Returns the camera for a picture of this size, or nullopt if the file has none. Throws Error{invalid_argument} if
    // the camera is impossible.
    [[nodiscard]] std::optional<hrbfnpr_camera> camera(std::int32_t width, std::int32_t height) const;
};

// Reads a settings file. Throws Error{invalid_argument} that names the key and its valid values.
[[nodiscard]] std::shared_ptr<const Settings> read_settings(std::string_view json, Pool& pool);

// The parts of a picture that settings store, besides its options.
struct PictureParts {
    std::uint32_t preset;
    const hrbfnpr_camera& camera;                // the planned camera; its viewport is the whole picture
    const Style& style;                          // the style as planned, in pixels of this picture
    const Marks* marks;                          // the marks as planned; null if none were made
    std::span<const hrbfnpr_line_desc> lines;    // the lines that are found once, except the caller's own lines
    const hrbfnpr_layer_style* ground = nullptr; // the layer of the ground; null without a ground
};

struct WrittenSettings {
    String json;
    // The given options that settings cannot store, as markers for in_words(): "{samples}, {flip!}".
    String not_held;
};

// Writes settings that make the same picture from the same source.
[[nodiscard]] WrittenSettings write_settings(const Options& options, const PictureParts& parts, Pool& pool);

} // namespace hrbfnpr::picture
