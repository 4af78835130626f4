// SPDX-License-Identifier: MIT
// The sections of a model file: of a fit, and of a tree with fits as leaves.
#pragma once

#include "io/encoder.h"
#include "io/files.h"

namespace hrbfnpr::io {

// The first section: what kind of model, and a number that belongs to it.
using ModelKind = std::array<std::uint32_t, 2>;
inline constexpr std::uint32_t csg_kind = 4; // HRBFNPR_KERNEL_CSG; those of fits are their kernels

void encode_kind(Encoder& encoder, const ModelKind& kind);
[[nodiscard]] ModelKind decode_kind(Decoder& decoder);

// With its kind; and after it.
void encode_fit(Encoder& encoder, const implicit::HrbfData& data, std::span<const double> report);
void decode_fit(Decoder& decoder, const ModelKind& kind, FitFile& file);
void check_fit(const Decoder& decoder, const FitFile& file);

void decode_csg(Decoder& decoder, const ModelKind& kind, ModelFile& file);
void check_csg(const Decoder& decoder, const ModelFile& file);

// At the end of either, if there is one.
void encode_trim(Encoder& encoder, const TrimFile* trim);

} // namespace hrbfnpr::io
