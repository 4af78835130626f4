// SPDX-License-Identifier: MIT
// Occlusion and cast shadows of a picture.
#pragma once

#include "picture/call.h"
#include "picture/handles.h"
#include "picture/memory.h"
#include "picture/style.h"

#include <span>

namespace hrbfnpr::picture {

// Tells whether a style is darker where less of the sky is seen.
[[nodiscard]] bool needs_occlusion(const hrbfnpr_style& style) noexcept;
// Tells whether a light of a style casts shadows.
[[nodiscard]] bool needs_cast_shadows(const Style& style) noexcept;
// Tells whether a style lists lines at borders of shadows.
[[nodiscard]] bool draws_shadow_lines(const Style& style) noexcept;
// Tells whether a style needs occlusion, cast shadows, or the borders of shadows.
[[nodiscard]] bool needs_shading(const Style& style) noexcept;

// Tells whether cast shadows move with the camera.
[[nodiscard]] bool shadows_follow_camera(const Style& style) noexcept;

// Gathers the surfaces of line sets. Returns null without any.
[[nodiscard]] Occluders make_occluders(const Call& call, std::span<const hrbfnpr_item> items);

// Finds the light that reaches the marks of the items, in the stage SHADE. `previous` has shadings of the same marks
// for another camera, or is empty.
[[nodiscard]] Vector<Shading> make_shadings(const Call& call, const Occluders& occluders,
                                            std::span<const hrbfnpr_item> items, const hrbfnpr_camera& camera,
                                            const Vector<Shading>& previous);

} // namespace hrbfnpr::picture
