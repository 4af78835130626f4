// SPDX-License-Identifier: MIT
// The handle of a line set. It keeps the model.
#pragma once

#include "api/model.h"
#include "curves/mesh_rays.h"
#include "features/line_set.h"

#include <memory>
#include <mutex>

struct hrbfnpr_line_set : hrbfnpr::api::Child {
    hrbfnpr_line_set(hrbfnpr_context& context, const hrbfnpr_model& of,
                     const hrbfnpr::curves::LineSetSettings& settings, const hrbfnpr::base::Progress& progress);
    ~hrbfnpr_line_set();

    // Returns the mesh with a hierarchy of boxes over its triangles. The first call makes it. Any thread may call this.
    [[nodiscard]] const hrbfnpr::curves::RayMesh& ray_mesh(const hrbfnpr::base::Progress& progress) const;

    // Returns the memory of the lines and of that mesh, if it was made. Any thread may call this.
    [[nodiscard]] std::int64_t bytes() const noexcept;

    const hrbfnpr_model& model;
    const hrbfnpr::curves::LineSet lines;

private:
    mutable std::mutex preparing_;
    mutable std::unique_ptr<hrbfnpr::curves::RayMesh> ray_mesh_;
};
