// SPDX-License-Identifier: MIT
// A mesh as a handle.
#pragma once

#include "api/handles.h"
#include "mesh/face_tree.h"
#include "mesh/mesh.h"

#include <memory>

struct hrbfnpr_mesh : hrbfnpr::api::Child {
    hrbfnpr_mesh(hrbfnpr_context& context, hrbfnpr::mesh::Mesh&& made, const hrbfnpr::base::Progress& progress)
        : Child(context), mesh(std::move(made)), tree(context.runtime, mesh.vertex, mesh.triangle, progress) {}

    const hrbfnpr::mesh::Mesh mesh;
    const hrbfnpr::mesh::FaceTree tree;
};
