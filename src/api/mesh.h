// SPDX-License-Identifier: MIT
// The handle of a mesh.
#pragma once

#include "api/handles.h"
#include "mesh/face_tree.h"
#include "mesh/mesh.h"
#include "mesh/pieces/has_creases.h"

#include <memory>

struct hrbfnpr_mesh : hrbfnpr::api::Child {
    hrbfnpr_mesh(hrbfnpr_context& context, hrbfnpr::mesh::Mesh&& made, const hrbfnpr::base::Progress& progress)
        : Child(context), mesh(std::move(made)),
          tree({context.runtime, progress.part(0.0, 0.7)}, mesh.vertex, mesh.triangle),
          creases(hrbfnpr::mesh::look_for_creases({context.runtime, progress.part(0.7, 1.0)}, mesh,
                                                  hrbfnpr::mesh::default_crease_angle)) {}

    const hrbfnpr::mesh::Mesh mesh;
    const hrbfnpr::mesh::FaceTree tree;
    const hrbfnpr::mesh::CreaseEvidence creases; // the evidence for creases at the default angle
};
