// SPDX-License-Identifier: MIT
// Gives marks the values that a style names, and paints tones over them.
#pragma once

#include "picture/call.h"
#include "picture/handles.h"
#include "picture/paint.h"
#include "picture/source_fields.h"
#include "picture/style.h"

#include <hrbfnpr.h>

#include <cstddef>
#include <memory>

namespace hrbfnpr::picture {

// Returns whether a drawing in a style, with the dabs of the options, needs values at its marks.
[[nodiscard]] bool uses_fields(const Options& options, const Style& style) noexcept;

// The fields that the marks of a picture need, and the style's layers with the names that marks know them by.
class MarkFields {
public:
    // Resolves the names in a style. `given` are marks of the caller, which may have fields; it may be null. Throws
    // Error{invalid_argument} that names the fields there are.
    MarkFields(const Call& call, const Style& style, const SourceFields& sources, const PointSet& given);

    // Returns the marks with all values. `source` is the number of the source that they lie on.
    [[nodiscard]] PointSet with_fields(const Call& call, const PointSet& marks, std::size_t source,
                                       hrbfnpr_operation* operation) const;
    // The layers of the style, with the names of fields that the marks have.
    [[nodiscard]] const Vector<hrbfnpr_layer_style>& layers() const noexcept { return layers_; }

private:
    // A tone that dabs paint over. `below` is its number among the wanted fields, or -1 for none.
    struct PaintedTone {
        std::int64_t below;
        const char* key;
    };

    [[nodiscard]] const char* key_of(const Call& call, const char* name, FieldUse use);
    [[nodiscard]] const char* painted_key_of(const Call& call, const hrbfnpr_layer_style& layer, const char* below);

    const SourceFields& sources_;
    PointSet given_;
    Field tones_; // the painted tones; null without any
    Vector<WantedField> wanted_;
    Vector<PaintedTone> painted_;
    Vector<hrbfnpr_layer_style> layers_;
    KeptTexts texts_;
};

// Chooses inks for a style that has ink fields and no palette, from the colours of the marks, and notes them.
// `layers` has the names that the marks know the fields by.
void choose_palette(const Call& call, const Vector<hrbfnpr_layer_style>& layers, const Vector<PointSet>& marks,
                    Style& style);

} // namespace hrbfnpr::picture
