// SPDX-License-Identifier: MIT
// Measures how near a fitted surface is to its samples or its mesh.
#pragma once

#include "picture/call.h"

namespace hrbfnpr::picture {

// Returns a share as a percentage: "12.34%" for 0.1234 with two digits.
[[nodiscard]] String percent_of(double share, int digits, Pool& pool);

// Describes the distances between a surface and a mesh in both directions, as shares of the diagonal.
[[nodiscard]] String distances_in_words(const hrbfnpr_mesh_fit_info& found, double diagonal, Pool& pool);
[[nodiscard]] String distances_in_words(const hrbfnpr_comparison& found, double diagonal, Pool& pool);

// Compares a surface with its mesh, and warns if the mesh is far from it.
void tell_nearness(const Call& call, const Mesh& mesh, const Model& model);

[[nodiscard]] hrbfnpr_model_info model_info_of(const Model& model);
// Returns the diagonal of a model's bounds, or 1 if it is 0.
[[nodiscard]] double diagonal_of(const hrbfnpr_model_info& info) noexcept;
[[nodiscard]] double diagonal_of(const Model& model);

// Describes how near a surface is to the points that it was fitted to. The numbers come from the fit.
[[nodiscard]] String nearness_of_points(const hrbfnpr_model_info& info, Pool& pool);
// Reports in a note which samples the fit repaired or left out.
void tell_repaired_samples(const Call& call, const hrbfnpr_model_info& info);
// Warns of defects that the fit found in the samples but did not repair.
void tell_doubted_samples(const Call& call, const hrbfnpr_model_info& info);

} // namespace hrbfnpr::picture
