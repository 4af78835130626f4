// SPDX-License-Identifier: MIT
// 192 samples of a torus become a pen-and-ink drawing: pixels, as writers of PNG take them, and torus.svg.
#include <array>
#include <cmath>
#include <fstream>
#include <hrbfnpr.h>
#include <memory>
#include <stdexcept>
#include <vector>

hrbfnpr_error error{sizeof error, HRBFNPR_STATUS_OK, ""};
void check(hrbfnpr_status status) {
    if (status != HRBFNPR_STATUS_OK) throw std::runtime_error(error.message);
}
// make<hrbfnpr_model>(hrbfnpr_model_release, [](auto made) { return hrbfnpr_model_...(..., made, &error); }) owns a
// handle.
template <class Handle, class Release, class Call>
auto make(Release release, Call&& call) {
    Handle* handle = nullptr;
    check(call(&handle));
    return std::unique_ptr<Handle, Release>(handle, release);
}

int main() {
    std::vector<std::array<double, 3>> points, normals;
    for (int i = 0; i < 192; ++i) {
        const double a = 6.283185307179586 * (i / 8) / 24, b = 6.283185307179586 * (i % 8) / 8;
        normals.push_back({std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)});
        const auto& n = normals.back();
        points.push_back({std::cos(a) + 0.4 * n[0], std::sin(a) + 0.4 * n[1], 0.4 * n[2]});
    }
    hrbfnpr_picture_source source;
    hrbfnpr_picture_source_init(&source, sizeof source);
    source.points = {points.data(), 192, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    source.normals = {normals.data(), 192, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    hrbfnpr_picture_desc desc;
    hrbfnpr_picture_desc_init(&desc, sizeof desc); // a good default for every field
    desc.sources = &source, desc.source_count = 1, desc.width = 800, desc.height = 600, desc.style_name = "engraving";

    const auto context = make<hrbfnpr_context>(hrbfnpr_context_release,
                                               [](auto made) { return hrbfnpr_context_create(nullptr, made, &error); });
    const auto picture = make<hrbfnpr_picture>(hrbfnpr_picture_release, [&](auto made) {
        return hrbfnpr_picture_create(context.get(), &desc, nullptr, made, &error);
    });
    const auto drawing = make<hrbfnpr_drawing>(hrbfnpr_drawing_release, [&](auto made) {
        return hrbfnpr_picture_draw(picture.get(), nullptr, nullptr, made, &error);
    });
    std::vector<unsigned char> rgba(800 * 600 * 4);
    const hrbfnpr_image image{sizeof image, HRBFNPR_FORMAT_RGBA8, 800, 600, rgba.data(), 0};
    check(hrbfnpr_picture_rasterize(picture.get(), drawing.get(), nullptr, &image, &error));
    std::ofstream file("torus.svg", std::ios::binary);
    const auto put = [](void* to, const void* data, std::uint64_t size) {
        auto& stream = *static_cast<std::ofstream*>(to);
        return stream.write(static_cast<const char*>(data), static_cast<std::streamsize>(size)) ? 0 : 1;
    };
    check(hrbfnpr_picture_write(picture.get(), drawing.get(), nullptr, nullptr, put, &file, nullptr, nullptr, &error));
}
