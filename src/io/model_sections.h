// SPDX-License-Identifier: MIT
// The sections of a model file: of a fit, of a model of sheets, and of a tree with these as leaves.
#pragma once

#include "io/decoder.h"
#include "io/encoder.h"
#include "io/files.h"

namespace hrbfnpr::io {

// The first section: what kind of model, and a number that belongs to it.
using ModelKind = std::array<std::uint32_t, 2>;
// Those of fits are their kernels, with a degree; these have a 0.
inline constexpr std::uint32_t csg_kind = 4; // HRBFNPR_KERNEL_CSG
inline constexpr std::uint32_t sheets_kind = 5;

inline constexpr double coordinate_limit = 1e100;

void encode_kind(Encoder& encoder, const ModelKind& kind);
[[nodiscard]] ModelKind decode_kind(Decoder& decoder);

// One fit, with its kind; and after it.
void encode_hrbf(Encoder& encoder, const implicit::HrbfData& data);
void decode_hrbf(Decoder& decoder, const ModelKind& kind, implicit::HrbfData& data);
void check_hrbf(const Decoder& decoder, const implicit::HrbfData& data);

// Sheets, after their kind.
void encode_pieces(Encoder& encoder, const implicit::PiecesData& data);
void decode_pieces(Decoder& decoder, implicit::PiecesData& data);
// Of the whole, where the sheets are right: evaluating it is safe.
void check_pieces(const Decoder& decoder, const implicit::PiecesData& data);

// Either, with its kind, and the report; and after the kind.
void encode_fit(Encoder& encoder, const FitToSave& fit);
void decode_fit(Decoder& decoder, const ModelKind& kind, FitFile& file);
void check_fit(const Decoder& decoder, const FitFile& file);

void decode_csg(Decoder& decoder, const ModelKind& kind, ModelFile& file);
void check_csg(const Decoder& decoder, const ModelFile& file);

// At the end of any, if there is one.
void encode_trim(Encoder& encoder, const TrimFile* trim);

} // namespace hrbfnpr::io
