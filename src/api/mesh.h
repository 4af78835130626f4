// SPDX-License-Identifier: MIT
// A mesh as a handle.
#pragma once

#include "api/handles.h"
#include "mesh/face_tree.h"
#include "mesh/mesh.h"
#include "mesh/pieces/has_creases.h"

#include <memory>

struct hrbfnpr_mesh : hrbfnpr::api::Child {
    hrbfnpr_mesh(hrbfnpr_context& context, hrbfnpr::mesh::Mesh&& made, const hrbfnpr::base::Progress& progress)
        : Child(context), mesh(std::move(made)),
          tree(context.runtime, mesh.vertex, mesh.triangle, progress.part(0.0, 0.7)),
          creases(hrbfnpr::mesh::look_for_creases(context.runtime, mesh, hrbfnpr::mesh::default_crease_angle,
                                                  progress.part(0.7, 1.0))) {}

    const hrbfnpr::mesh::Mesh mesh;
    const hrbfnpr::mesh::FaceTree tree;
    const hrbfnpr::mesh::CreaseEvidence creases; // at the default angle
};
