// SPDX-License-Identifier: MIT
// Compares depth, id and class outputs of frames by layers with a sphere.
#include "frame/line_of_sight.h"
#include "raster/picture.h"

#include <gtest/gtest.h>

namespace hrbfnpr::testing::layer_outputs_test {
namespace {

using drawing::DepthConvention;
using drawing::MarkClass;
using output::DrawSettings;

constexpr int size = 300;
constexpr double half = 1.25;
constexpr double pixel = 2.0 * half / size;

template <class T>
base::OutView out_view(std::vector<T>& values, base::Scalar scalar) {
    return {reinterpret_cast<std::byte*>(values.data()), static_cast<std::int64_t>(values.size()),
            std::int64_t{sizeof(T)}, scalar, 1};
}

class LayerOutputs : public ::testing::TestWithParam<DepthConvention> {
protected:
    LayerOutputs() {
        camera.depth = GetParam();
        camera.projection = frame::orthographic(2.0 * half, size, size, 1.0, 21.0, camera.depth);
        settings.depth = out_view(depth, base::Scalar::float32);
        settings.id = out_view(id, base::Scalar::uint32);
        settings.mark_class = out_view(mark_class, base::Scalar::uint8);
    }
    void draw(const Style& style, const glm::dmat4& transform = glm::dmat4(1.0)) {
        const std::array items{layered_item(set, style, transform)};
        frame.draw(items, camera);
        Picture picture(size, size);
        output::Raster(runtime).draw(frame.drawing(), picture.image(), settings);
    }
    // Returns the distance from the eye at z = 10.
    [[nodiscard]] double eye_depth(std::size_t i) const {
        const auto window = static_cast<double>(depth[i]);
        return 1.0 + 20.0 * (GetParam() == DepthConvention::reversed ? 1.0 - window : window);
    }

    base::Runtime runtime;
    marks::PointSet set = clustered(runtime, sphere(runtime.memory, 20000));
    DrawnFrame frame{runtime};
    frame::Camera camera = front_camera(size, size, half);
    std::vector<float> depth = std::vector<float>(size * size, -7.0F);
    std::vector<std::uint32_t> id = std::vector<std::uint32_t>(size * size, 77);
    std::vector<std::uint8_t> mark_class = std::vector<std::uint8_t>(size * size, 77);
    DrawSettings settings;
};

TEST_P(LayerOutputs, GiveTheNearestLayerAndItsMark) {
    draw(all_front(frame::HiddenLines::hide));
    const double reach = 10.5 * pixel; // the reach of a splat
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const auto i = static_cast<std::size_t>(y * size + x);
            const glm::dvec2 at((x + 0.5) * pixel - half, half - (y + 0.5) * pixel);
            const double off = glm::length(at);
            if (off > 1.0 + reach) {
                ASSERT_EQ(depth[i], drawing::far_depth(GetParam()));
                ASSERT_EQ(id[i], 0U);
                ASSERT_EQ(mark_class[i], 0);
            } else if (off < 0.9) {
                const double nu = std::sqrt(1.0 - off * off);
                ASSERT_NEAR(eye_depth(i), 10.0 - nu, reach * off / nu + reach * reach) << x << " " << y;
                ASSERT_EQ(mark_class[i], static_cast<std::uint8_t>(MarkClass::front));
                ASSERT_GE(id[i], 1U);
                ASSERT_LE(id[i], 20000U);
                const Mark mark = mark_of(set, id[i] - 1);
                ASSERT_LE(glm::length(glm::dvec2(mark.position) - at), reach);
                ASSERT_NEAR(10.0 - mark.position.z, eye_depth(i), 1e-4);
            }
        }
    }
}

TEST_P(LayerOutputs, GiveAVisibleInnerSide) {
    // Without the near half, the inner side of the far half is visible.
    marks::PointSet bowl(runtime.memory);
    for (int i = 0; i < 40000; ++i) {
        const glm::dvec3 n = spiral_direction(i, 40000);
        const glm::dvec3 turned(n.x, n.y, -std::abs(n.z));
        if (n.z < 0.0) add_stipple(bowl, turned, turned);
    }
    bowl.spacing = std::sqrt(4.0 * pi / 40000.0);
    set = clustered(runtime, std::move(bowl));
    Style style = all_front(frame::HiddenLines::hide);
    style.halo_width = 0.0F;
    draw(style);
    const auto at = [](double x, double y) {
        return static_cast<std::size_t>(static_cast<int>((half - y) / pixel) * size +
                                        static_cast<int>((x + half) / pixel));
    };
    EXPECT_EQ(mark_class[at(0.0, 0.0)], static_cast<std::uint8_t>(MarkClass::back));
    EXPECT_NEAR(eye_depth(at(0.0, 0.0)), 11.0, 0.02);
    for (const std::uint8_t one : mark_class) EXPECT_NE(one, static_cast<std::uint8_t>(MarkClass::silhouette));
}

TEST_P(LayerOutputs, LeaveOutPartsHiddenByTheHost) {
    std::vector<float> host(size * size);
    for (int i = 0; i < size * size; ++i) { // a wall through the middle of the sphere, on the left
        const double window = i % size < size / 2 ? 8.5 / 20.0 : 1.0;
        host[static_cast<std::size_t>(i)] =
            static_cast<float>(GetParam() == DepthConvention::reversed ? 1.0 - window : window);
    }
    settings.host_depth = {reinterpret_cast<const std::byte*>(host.data()), size * size, sizeof(float),
                           base::Scalar::float32, 1};
    draw(all_front(frame::HiddenLines::hide));
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const auto i = static_cast<std::size_t>(y * size + x);
            const double off = std::hypot((x + 0.5) * pixel - half, half - (y + 0.5) * pixel);
            const double nearest = 10.0 - std::sqrt(std::max(0.0, 1.0 - off * off));
            if (off > 0.9 || (x < size / 2 && std::abs(nearest - 9.5) < 0.15)) continue;
            ASSERT_EQ(id[i] != 0, x >= size / 2 || nearest < 9.5) << x << " " << y;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Conventions, LayerOutputs,
                         ::testing::Values(DepthConvention::negative_one_to_one, DepthConvention::zero_to_one,
                                           DepthConvention::reversed),
                         [](const auto& one) { return "number_" + std::to_string(static_cast<int>(one.param)); });

} // namespace
} // namespace hrbfnpr::testing::layer_outputs_test
