// SPDX-License-Identifier: MIT
// Fields of hand-made point sets.
#pragma once

#include "frame/hand_made.h"

#include <cstring>
#include <functional>
#include <vector>

namespace hrbfnpr::testing {

// A value at a place: one number, or three.
using ValueAt = std::function<glm::dvec3(const glm::dvec3&)>;
using WeightAt = std::function<double(const glm::dvec3&)>;

// Gives a layer a field of this name.
inline void add_field(marks::Layer& layer, const char* name, marks::FieldKind kind, const ValueAt& value,
                      const WeightAt& weight = nullptr) {
    marks::MarkField& field = layer.fields.add(layer.fields.memory());
    std::memcpy(field.name.data(), name, std::strlen(name));
    field.kind = kind;
    for (std::int64_t i = 0; i < layer.count(); ++i) {
        const glm::dvec3 place(marks::vector_at(layer.position, i));
        const glm::dvec3 own = value(place);
        for (int k = 0; k < marks::components_of(kind); ++k) field.value.push_back(static_cast<float>(own[k]));
        if (weight) field.weight.push_back(static_cast<float>(weight(place)));
    }
}
inline void add_scalar(marks::Layer& layer, const char* name, const std::function<double(const glm::dvec3&)>& value,
                       const WeightAt& weight = nullptr) {
    add_field(
        layer, name, marks::FieldKind::scalar, [&](const glm::dvec3& p) { return glm::dvec3(value(p)); }, weight);
}

// Returns the number of the ink of each mark that is drawn as a dot: 0 for the layer's own ink, 1 + k for ink k of the
// palette; -1 if the mark is not drawn.
inline std::vector<int> inks_of_dots(const drawing::Drawing& drawing, const drawing::Run& run) {
    std::vector<int> inks(static_cast<std::size_t>(run.count), -1);
    for (const drawing::IndexRange& piece : drawing.dot_ranges)
        for (std::int64_t i = piece.begin; i < piece.end; ++i)
            if (const drawing::Dot& dot = drawing.dots[i]; dot.opacity > 0.0F && drawing.run_of(dot.id) == &run)
                inks[dot.id - run.first_id] = 1 + drawing.layers[dot.layer].ink_number;
    return inks;
}

} // namespace hrbfnpr::testing
