// SPDX-License-Identifier: MIT
// Writes, reads and checks the sections of a model file: a fit, a model of sheets, or a CSG tree with these as leaves.
#pragma once

#include "io/decoder.h"
#include "io/encoder.h"
#include "io/files.h"

namespace hrbfnpr::io {

// The first section: the kind of the model, and a number whose meaning depends on the kind.
using ModelKind = std::array<std::uint32_t, 2>;
// For a fit, the kind is that of its kernel, and the number is its polynomial degree + 1. For the kinds below, the
// number is 0.
inline constexpr std::uint32_t csg_kind = 4; // HRBFNPR_KERNEL_CSG
inline constexpr std::uint32_t sheets_kind = 5;

inline constexpr double coordinate_limit = 1e100;

void encode_kind(Encoder& encoder, const ModelKind& kind);
[[nodiscard]] ModelKind decode_kind(Decoder& decoder);

// Write and read a fit. encode_hrbf() also writes the kind; decode_hrbf() expects that the kind was read.
void encode_hrbf(Encoder& encoder, const implicit::HrbfData& data);
void decode_hrbf(Decoder& decoder, const ModelKind& kind, implicit::HrbfData& data);
void check_hrbf(const Decoder& decoder, const implicit::HrbfData& data);

// Write and read a model of sheets, without its kind.
void encode_pieces(Encoder& encoder, const implicit::SheetTreeData& data);
void decode_pieces(Decoder& decoder, implicit::SheetTreeData& data);
// Checks all sheets and the octree. A model that passes can be evaluated safely.
void check_pieces(const Decoder& decoder, const implicit::SheetTreeData& data);

// Write and read a fit or a model of sheets, with the report. encode_fit() also writes the kind; decode_fit() expects
// that the kind was read.
void encode_fit(Encoder& encoder, const FitToSave& fit);
void decode_fit(Decoder& decoder, const ModelKind& kind, FitFile& file);
void check_fit(const Decoder& decoder, const FitFile& file);

void decode_csg(Decoder& decoder, const ModelKind& kind, ModelFile& file);
void check_csg(const Decoder& decoder, const ModelFile& file);

// Writes the trim at the end of a model file. Writes nothing if there is no trim.
void encode_trim(Encoder& encoder, const TrimFile* trim);

} // namespace hrbfnpr::io
