// The rasteriser: discs into the caller's pixels, in tiles, far to near.
#pragma once

#include "base/runtime.h"
#include "base/view.h"
#include "frame/frame.h"

namespace hrbfnpr::output {

// Same numbers as HRBFNPR_FORMAT_...
enum class Format : std::uint32_t { rgba8 = 1, bgra8 = 2, rgba8_premultiplied = 3, bgra8_premultiplied = 4 };

struct Image {
    Format format = Format::rgba8;
    std::int32_t width = 0;
    std::int32_t height = 0;
    std::byte* pixels = nullptr; // top-left
    std::int64_t row_stride = 0; // bytes, never 0
};

// Views of width * height elements, or empty.
struct DrawSettings {
    bool over = false;
    bool linear_light = false;
    base::InView host_depth;
    base::OutView depth;
    base::OutView id;
    base::OutView mark_class;
};

// Keeps its tile bins from call to call: allocates nothing once warm.
class Raster {
public:
    explicit Raster(const base::Runtime& runtime);
    ~Raster();
    void draw(const frame::Frame& frame, const Image& image, const DrawSettings& settings);
    [[nodiscard]] std::int64_t scratch_bytes() const noexcept;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace hrbfnpr::output
