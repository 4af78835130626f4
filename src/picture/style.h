// SPDX-License-Identifier: MIT
// A style as a value that owns its lists, and how marks are to be made.
#pragma once

#include "picture/memory.h"

#include <hrbfnpr.h>

#include <list>
#include <memory>
#include <string_view>

namespace hrbfnpr::picture {

// The texts and numbers that the elements of a list point to.  Their addresses never change, and a copy of the owner
// has texts of its own: values that are copied share nothing that is ever written.
class KeptTexts {
public:
    explicit KeptTexts(Pool& pool) noexcept : texts_(&pool), numbers_(&pool), held_(&pool) {}
    KeptTexts(KeptTexts&&) noexcept = default;
    KeptTexts(const KeptTexts&) = delete;
    KeptTexts& operator=(const KeptTexts&) = delete;

    [[nodiscard]] const char* text(std::string_view text) { return texts_.emplace_back(text).c_str(); }
    // Packed doubles, `components` of them for each of `count` elements.
    [[nodiscard]] hrbfnpr_array numbers(const double* first, std::size_t count, std::uint32_t components = 1);
    // Keeps what a callback is given for as long as this and the owner's copies live, which may be longer than the
    // pool.
    void hold(std::shared_ptr<const void> owner) { held_.push_back(std::move(owner)); }
    void hold_all_of(const KeptTexts& other) { held_.insert(held_.end(), other.held_.begin(), other.held_.end()); }

private:
    std::pmr::list<String> texts_;
    std::pmr::list<Vector<double>> numbers_;
    Vector<std::shared_ptr<const void>> held_;
};

// hrbfnpr_style with its own layers, lines, names and levels: what class Style is in Python.
class Style {
public:
    explicit Style(Pool& pool);                    // the library's default style
    Style(std::uint32_t preset, Pool& pool);       // a named one
    Style(const hrbfnpr_style& given, Pool& pool); // a copy of the caller's; throws where it has a bad list
    Style(const Style& other, Pool& pool);         // a copy in another pool
    Style(const Style& other) : Style(other, *other.pool_) {}
    Style(Style&& other) noexcept = default;
    Style& operator=(Style other) noexcept;
    ~Style() = default;

    hrbfnpr_style base;                 // its lists are not used
    Vector<hrbfnpr_layer_style> layers; // names refer to kept texts
    Vector<hrbfnpr_line_style> lines;   // names and levels refer to kept texts and numbers

    // The element for a kind of layers (HRBFNPR_LAYER_KIND_...).  If what they take now is for others too, a copy of it
    // for them alone is put in front of it.  Valid until `layers` grows.
    [[nodiscard]] hrbfnpr_layer_style& layer(std::uint32_t kind);
    // What a layer of marks takes: the first element that is for it, or defaults.  name: nullable.
    [[nodiscard]] hrbfnpr_layer_style style_of(std::uint32_t kind, const char* name) const noexcept;
    // Gives all layers, lines and the contours one ink.
    void set_ink(const float (&ink)[4]);

    // Texts and numbers for elements of this style.
    [[nodiscard]] const char* keep(std::string_view text) { return kept_.text(text); }
    [[nodiscard]] hrbfnpr_array keep_levels(const double* levels, std::size_t count) {
        return kept_.numbers(levels, count);
    }
    void hold(std::shared_ptr<const void> owner) { kept_.hold(std::move(owner)); }

    // With its lists, valid while this is not changed.
    [[nodiscard]] hrbfnpr_style view() const noexcept;

private:
    void take_lists(const hrbfnpr_style& given);

    Pool* pool_;
    KeptTexts kept_;
};

// hrbfnpr_generate_desc with its own layers and names.
class Marks {
public:
    explicit Marks(Pool& pool);
    Marks(const Marks& other, Pool& pool);
    Marks(const Marks& other) : Marks(other, *other.pool_) {}
    Marks(Marks&& other) noexcept = default;
    Marks& operator=(Marks other) noexcept;
    ~Marks() = default;

    hrbfnpr_generate_desc base; // its list is not used; seed_points are kept
    Vector<hrbfnpr_layer_desc> layers;

    [[nodiscard]] const char* keep(std::string_view text) { return kept_.text(text); }
    void hold(std::shared_ptr<const void> owner) { kept_.hold(std::move(owner)); }
    // Takes a copy: n x 3.
    void set_seed_points(const hrbfnpr_array& points);
    [[nodiscard]] hrbfnpr_generate_desc view() const noexcept;
    // Whether both make the same marks of a surface.
    [[nodiscard]] bool same_as(const Marks& other) const noexcept;

private:
    Pool* pool_;
    KeptTexts kept_;
};

} // namespace hrbfnpr::picture
