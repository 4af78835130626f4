// SPDX-License-Identifier: MIT
// A style as a value that owns its lists, and how marks are to be made.
#pragma once

#include "picture/memory.h"

#include <hrbfnpr.h>

#include <memory>
#include <string_view>

namespace hrbfnpr::picture {

// hrbfnpr_style with its own layers, lines, names and levels: what class Style is in Python.
class Style {
public:
    explicit Style(Pool& pool) noexcept;           // the library's default style
    Style(std::uint32_t preset, Pool& pool);       // a named one
    Style(const hrbfnpr_style& given, Pool& pool); // a copy of the caller's; throws where it has a bad list
    Style(const Style& other);
    Style(Style&& other) noexcept;
    Style& operator=(Style other) noexcept;

    hrbfnpr_style base;                 // its lists are not used
    Vector<hrbfnpr_layer_style> layers; // names refer to kept texts
    Vector<hrbfnpr_line_style> lines;   // names and levels refer to kept texts and numbers

    // The element for a kind of layers (HRBFNPR_LAYER_KIND_...).  If what they take so far is for others too, a copy of
    // it for them alone is put in front of it.
    [[nodiscard]] hrbfnpr_layer_style& layer(std::uint32_t kind);
    // What a layer of marks takes: the first element that is for it, or defaults.  name: nullable.
    [[nodiscard]] hrbfnpr_layer_style style_of(std::uint32_t kind, const char* name) const noexcept;
    // Gives all layers, lines and the contours one ink.
    void set_ink(const float (&ink)[4]);

    // Texts and numbers that elements refer to, kept as long as the style and its copies.
    [[nodiscard]] const char* keep(std::string_view text);
    [[nodiscard]] hrbfnpr_array keep_levels(const double* levels, std::size_t count);

    // With its lists, valid while this is not changed.
    [[nodiscard]] hrbfnpr_style view() const noexcept;

private:
    struct Kept; // texts and numbers
    std::shared_ptr<Kept> kept_;
};

// hrbfnpr_generate_desc with its own layers and names.
class Marks {
public:
    explicit Marks(Pool& pool) noexcept;
    Marks(const Marks& other);
    Marks(Marks&& other) noexcept;
    Marks& operator=(Marks other) noexcept;

    hrbfnpr_generate_desc base;
    Vector<hrbfnpr_layer_desc> layers;

    [[nodiscard]] const char* keep(std::string_view text);
    [[nodiscard]] hrbfnpr_generate_desc view() const noexcept;
    // Whether both make the same marks of a surface.
    [[nodiscard]] bool same_as(const Marks& other) const noexcept;

private:
    struct Kept;
    std::shared_ptr<Kept> kept_;
};

} // namespace hrbfnpr::picture
