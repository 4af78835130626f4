// SPDX-License-Identifier: MIT
// A file of settings: a descriptor as JSON (docs/settings.md).
#pragma once

#include "picture/memory.h"
#include "picture/style.h"

#include <hrbfnpr.h>

#include <memory>
#include <optional>
#include <string_view>

namespace hrbfnpr::picture {

class Options;

struct Settings {
    explicit Settings(Pool& pool);

    std::uint32_t preset = HRBFNPR_PRESET_CONTOUR_AND_STIPPLE;
    std::optional<std::array<std::int32_t, 2>> size;
    double pen = 0.0; // 0: chosen
    Style style;
    bool has_layers = false; // of marks, below
    Marks marks;
    // The rest, field by field, as paths and texts of changes: "fit.kernel", "mesh_fit.edges", "line_set.support",
    // "marks.distribution".
    Vector<std::pair<String, String>> fields;
    bool has_lines = false; // to be found once, below
    Vector<hrbfnpr_line_desc> lines;
    Vector<hrbfnpr_dab> dabs;
    // The camera for a picture of this size; nothing: there is none in the file.
    [[nodiscard]] std::optional<hrbfnpr_camera> camera(std::int32_t width, std::int32_t height) const;
};

// Throws Error{invalid_argument} that names the key and what would be right.
[[nodiscard]] std::shared_ptr<const Settings> read_settings(std::string_view json, Pool& pool);

} // namespace hrbfnpr::picture
