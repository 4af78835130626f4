// SPDX-License-Identifier: MIT
// Defines classes for a style and for marks, which own their lists.
#pragma once

#include "picture/memory.h"

#include <hrbfnpr.h>

#include <array>
#include <list>
#include <memory>
#include <string_view>

namespace hrbfnpr::picture {

// Owns texts and numbers that the elements of a list point to. Their addresses never change. A copy also copies the
// texts and numbers, so copies share no mutable data.
class KeptTexts {
public:
    explicit KeptTexts(Pool& pool) noexcept : texts_(&pool), numbers_(&pool), held_(&pool) {}
    KeptTexts(KeptTexts&&) noexcept = default;
    KeptTexts(const KeptTexts&) = delete;
    KeptTexts& operator=(const KeptTexts&) = delete;

    [[nodiscard]] const char* text(std::string_view text) { return texts_.emplace_back(text).c_str(); }
    // Stores `count` elements of `components` packed doubles.
    [[nodiscard]] hrbfnpr_array numbers(const double* first, std::size_t count, std::uint32_t components = 1);
    // Keeps the data of a callback alive while this object and its copies live. Copies may outlive the pool.
    void hold(std::shared_ptr<const void> owner) { held_.push_back(std::move(owner)); }
    void hold_all_of(const KeptTexts& other) { held_.insert(held_.end(), other.held_.begin(), other.held_.end()); }

private:
    List<String> texts_;
    List<Vector<double>> numbers_;
    Vector<std::shared_ptr<const void>> held_;
};

// The texts of elements of lists. They point to kept texts.
inline constexpr const char* hrbfnpr_layer_style::*layer_style_texts[] = {
    &hrbfnpr_layer_style::name,        &hrbfnpr_layer_style::density_field, &hrbfnpr_layer_style::tone_field,
    &hrbfnpr_layer_style::width_field, &hrbfnpr_layer_style::ink_field,     &hrbfnpr_layer_style::mask_field};
[[nodiscard]] constexpr const auto& texts_of(const hrbfnpr_layer_style&) noexcept { return layer_style_texts; }
inline constexpr const char* hrbfnpr_line_style::*line_style_texts[] = {&hrbfnpr_line_style::name};
[[nodiscard]] constexpr const auto& texts_of(const hrbfnpr_line_style&) noexcept { return line_style_texts; }
inline constexpr const char* hrbfnpr_layer_desc::*layer_desc_texts[] = {&hrbfnpr_layer_desc::name};
[[nodiscard]] constexpr const auto& texts_of(const hrbfnpr_layer_desc&) noexcept { return layer_desc_texts; }

// An hrbfnpr_style that owns its layers, lines, lights, inks, texts and levels. It corresponds to the class Style in
// Python.
class Style {
public:
    explicit Style(Pool& pool);                    // a copy of the library's default style
    Style(std::uint32_t preset, Pool& pool);       // a copy of a named style
    Style(const hrbfnpr_style& given, Pool& pool); // a copy of the caller's style; throws if a list is invalid
    Style(const Style& other, Pool& pool);         // a copy in another pool
    Style(const Style& other) : Style(other, *other.pool_) {}
    Style(Style&& other) noexcept = default;
    Style& operator=(Style other) noexcept;
    ~Style() = default;

    hrbfnpr_style base;                 // The style without its lists, which are the members below.
    Vector<hrbfnpr_layer_style> layers; // The layers; their texts point to kept texts.
    Vector<hrbfnpr_line_style> lines;   // The lines; their names and levels point to kept texts and numbers.
    Vector<hrbfnpr_light> lights;
    Vector<std::array<float, 4>> palette; // inks for ink fields, straight sRGB

    // Returns the element for a kind of layers (HRBFNPR_LAYER_KIND_*). If the element applies to several kinds, a copy
    // for this kind is inserted before it. The reference is valid until `layers` grows.
    [[nodiscard]] hrbfnpr_layer_style& layer(std::uint32_t kind);
    // Returns the style for a layer of marks: the first matching element, or defaults. `name` may be null.
    [[nodiscard]] hrbfnpr_layer_style style_of(std::uint32_t kind, const char* name) const noexcept;
    // Sets the ink of all layers, lines and contours.
    void set_ink(const float (&ink)[4]);

    // These functions store texts and numbers for elements of this style.
    [[nodiscard]] const char* keep(std::string_view text) { return kept_.text(text); }
    [[nodiscard]] hrbfnpr_array keep_levels(const double* levels, std::size_t count) {
        return kept_.numbers(levels, count);
    }
    void hold(std::shared_ptr<const void> owner) { kept_.hold(std::move(owner)); }

    // Returns the style with its lists. The result is valid until this object changes.
    [[nodiscard]] hrbfnpr_style view() const noexcept;

private:
    void take_lists(const hrbfnpr_style& given);
    // Replaces the texts of a layer by copies.
    void keep_texts(hrbfnpr_layer_style& layer);

    Pool* pool_;
    KeptTexts kept_;
};

// A hrbfnpr_generate_desc that owns its layers and names.
class Marks {
public:
    explicit Marks(Pool& pool);
    Marks(const Marks& other, Pool& pool);
    Marks(const Marks& other) : Marks(other, *other.pool_) {}
    Marks(Marks&& other) noexcept = default;
    Marks& operator=(Marks other) noexcept;
    ~Marks() = default;

    hrbfnpr_generate_desc base; // The descriptor without its list of layers, but with its seed_points.
    Vector<hrbfnpr_layer_desc> layers;
    String direction_field;   // the name of the source's values that hatching follows; may be empty
    Vector<hrbfnpr_dab> dabs; // the dabs that fields of the layers are made of

    [[nodiscard]] const char* keep(std::string_view text) { return kept_.text(text); }
    void hold(std::shared_ptr<const void> owner) { kept_.hold(std::move(owner)); }
    // Copies an array of n points as the seed points.
    void set_seed_points(const hrbfnpr_array& points);
    [[nodiscard]] hrbfnpr_generate_desc view() const noexcept;
    // Returns whether this object and `other` make the same marks on a surface.
    [[nodiscard]] bool same_as(const Marks& other) const noexcept;

private:
    Pool* pool_;
    KeptTexts kept_;
};

} // namespace hrbfnpr::picture
