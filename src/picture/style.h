// SPDX-License-Identifier: MIT
// Defines a style as a value that owns its lists, and the marks in the same way.
#pragma once

#include "picture/memory.h"

#include <hrbfnpr.h>

#include <list>
#include <memory>
#include <string_view>

namespace hrbfnpr::picture {

// Owns the texts and numbers to which the elements of a list point. Their addresses never change. A copy of the owner
// has its own texts, so values that are copied share no mutable data.
class KeptTexts {
public:
    explicit KeptTexts(Pool& pool) noexcept : texts_(&pool), numbers_(&pool), held_(&pool) {}
    KeptTexts(KeptTexts&&) noexcept = default;
    KeptTexts(const KeptTexts&) = delete;
    KeptTexts& operator=(const KeptTexts&) = delete;

    [[nodiscard]] const char* text(std::string_view text) { return texts_.emplace_back(text).c_str(); }
    // Stores packed doubles: `components` for each of `count` elements.
    [[nodiscard]] hrbfnpr_array numbers(const double* first, std::size_t count, std::uint32_t components = 1);
    // Keeps the data of a callback alive as long as this object and copies of the owner, which may outlive the pool.
    void hold(std::shared_ptr<const void> owner) { held_.push_back(std::move(owner)); }
    void hold_all_of(const KeptTexts& other) { held_.insert(held_.end(), other.held_.begin(), other.held_.end()); }

private:
    List<String> texts_;
    List<Vector<double>> numbers_;
    Vector<std::shared_ptr<const void>> held_;
};

// An hrbfnpr_style that owns its layers, lines, names and levels. It corresponds to the class Style in Python.
class Style {
public:
    explicit Style(Pool& pool);                    // the library's default style
    Style(std::uint32_t preset, Pool& pool);       // a named style
    Style(const hrbfnpr_style& given, Pool& pool); // a copy of the caller's style; throws if a list is invalid
    Style(const Style& other, Pool& pool);         // a copy in another pool
    Style(const Style& other) : Style(other, *other.pool_) {}
    Style(Style&& other) noexcept = default;
    Style& operator=(Style other) noexcept;
    ~Style() = default;

    hrbfnpr_style base;                 // Its lists are not used.
    Vector<hrbfnpr_layer_style> layers; // Their names refer to kept texts.
    Vector<hrbfnpr_line_style> lines;   // Their names and levels refer to kept texts and numbers.

    // Returns the element for a kind of layers (HRBFNPR_LAYER_KIND_*). If that element also serves other kinds, a copy
    // for this kind alone is inserted before it. The reference is valid until `layers` grows.
    [[nodiscard]] hrbfnpr_layer_style& layer(std::uint32_t kind);
    // Returns the style of a layer of marks: the first element that matches, or defaults. `name` may be null.
    [[nodiscard]] hrbfnpr_layer_style style_of(std::uint32_t kind, const char* name) const noexcept;
    // Gives all layers, lines and contours one ink.
    void set_ink(const float (&ink)[4]);

    // Keep texts and numbers for elements of this style.
    [[nodiscard]] const char* keep(std::string_view text) { return kept_.text(text); }
    [[nodiscard]] hrbfnpr_array keep_levels(const double* levels, std::size_t count) {
        return kept_.numbers(levels, count);
    }
    void hold(std::shared_ptr<const void> owner) { kept_.hold(std::move(owner)); }

    // Returns the style with its lists. It is valid until this object changes.
    [[nodiscard]] hrbfnpr_style view() const noexcept;

private:
    void take_lists(const hrbfnpr_style& given);

    Pool* pool_;
    KeptTexts kept_;
};

// An hrbfnpr_generate_desc that owns its layers and names.
class Marks {
public:
    explicit Marks(Pool& pool);
    Marks(const Marks& other, Pool& pool);
    Marks(const Marks& other) : Marks(other, *other.pool_) {}
    Marks(Marks&& other) noexcept = default;
    Marks& operator=(Marks other) noexcept;
    ~Marks() = default;

    hrbfnpr_generate_desc base; // Its list is not used; seed_points are kept.
    Vector<hrbfnpr_layer_desc> layers;

    [[nodiscard]] const char* keep(std::string_view text) { return kept_.text(text); }
    void hold(std::shared_ptr<const void> owner) { kept_.hold(std::move(owner)); }
    // Copies an n x 3 array.
    void set_seed_points(const hrbfnpr_array& points);
    [[nodiscard]] hrbfnpr_generate_desc view() const noexcept;
    // Tells whether this and `other` make the same marks on a surface.
    [[nodiscard]] bool same_as(const Marks& other) const noexcept;

private:
    Pool* pool_;
    KeptTexts kept_;
};

} // namespace hrbfnpr::picture
