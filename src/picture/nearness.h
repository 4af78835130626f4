// SPDX-License-Identifier: MIT
// How near a fitted surface is to what it was fitted to.
#pragma once

#include "picture/call.h"

namespace hrbfnpr::picture {

// "12.34%", as of 0.1234 with two digits.
[[nodiscard]] String percent_of(double share, int digits, Pool& pool);

// Distances between a surface and a mesh, both ways, as shares of the diagonal.
[[nodiscard]] String distances_in_words(const hrbfnpr_mesh_fit_info& found, double diagonal, Pool& pool);
[[nodiscard]] String distances_in_words(const hrbfnpr_comparison& found, double diagonal, Pool& pool);

// Compares a surface with its mesh, and warns if the mesh is far from it.
void tell_nearness(const Call& call, const Mesh& mesh, const Model& model);

[[nodiscard]] hrbfnpr_model_info model_info_of(const Model& model);
// The diagonal of a model's bounds; 1 if it is 0.
[[nodiscard]] double diagonal_of(const hrbfnpr_model_info& info) noexcept;
[[nodiscard]] double diagonal_of(const Model& model);

// How near a surface is to the points that it was fitted to, by the fit's own figures.
[[nodiscard]] String nearness_of_points(const hrbfnpr_model_info& info, Pool& pool);
// Notes what the fit made of the samples.
void tell_repaired_samples(const Call& call, const hrbfnpr_model_info& info);
// Warns of what the fit found wrong and left as it is.
void tell_doubted_samples(const Call& call, const hrbfnpr_model_info& info);

} // namespace hrbfnpr::picture
