// SPDX-License-Identifier: MIT
// What model files have in common: the sections of a fit, and what they may hold.
#pragma once

#include "implicit/pieces.h"
#include "io/decoder.h"
#include "io/encoder.h"

namespace hrbfnpr::io {

// What a model of version 2 is made of; one of version 1 is a fit.
enum class ModelForm : std::uint32_t { pieces = 2 };

inline constexpr std::uint32_t tag_form = tag("FORM");
inline constexpr double coordinate_limit = 1e100;

void encode_fit(Encoder& encoder, const implicit::HrbfData& data);
void decode_fit(Decoder& decoder, implicit::HrbfData& data);
void check_fit(const Decoder& decoder, const implicit::HrbfData& data);

void encode_pieces(Encoder& encoder, const implicit::PiecesData& data);
void decode_pieces(Decoder& decoder, implicit::PiecesData& data);
// Of the whole, where the sheets are right: evaluating it is safe.
void check_pieces(const Decoder& decoder, const implicit::PiecesData& data);

} // namespace hrbfnpr::io
