// SPDX-License-Identifier: MIT
// Tests vertex arrays: layouts, contents, and the picture that a host makes of them.
#include "output/vertex/vertices.h"

#include "raster/reference.h"

#include <gtest/gtest.h>

#include <cstring>

namespace hrbfnpr::testing::vertices_test {
namespace {

using base::Scalar;
using output::VertexAttribute;
using output::VertexField;

constexpr int size = 130;

class Vertices : public ::testing::Test {
protected:
    void draw(const Style& style) {
        const std::array items{layers ? layered_item(set, style, transform) : item_of(set, style, transform)};
        frame.draw(items, front_camera(size, size));
    }
    [[nodiscard]] std::vector<std::byte> write(std::span<const VertexField> fields, std::int64_t stride) const {
        std::vector<std::byte> memory(static_cast<std::size_t>(stride) * frame.discs().size(), std::byte{0xCD});
        output::VertexScratch scratch(runtime);
        output::write_vertices(runtime, frame.drawing(), scratch, {output::Primitive::points, fields, stride},
                               memory.data(), nullptr);
        return memory;
    }

    base::Runtime runtime;
    marks::PointSet set = clustered(runtime, sphere(runtime.memory, 1500));
    bool layers = false; // frames by layers; false: as published
    glm::dmat4 transform{1.0};
    DrawnFrame frame{runtime};
};

template <class T>
T read(const std::vector<std::byte>& memory, std::int64_t at) {
    T value;
    std::memcpy(&value, memory.data() + at, sizeof value);
    return value;
}

TEST(VertexFieldSize, KnowsWhichTypesAnAttributeCanHave) {
    const auto bytes = [](VertexAttribute attribute, Scalar scalar) {
        return output::size_of(VertexField{attribute, scalar, 0});
    };
    for (const auto vector :
         {VertexAttribute::position, VertexAttribute::window, VertexAttribute::normal, VertexAttribute::direction}) {
        EXPECT_EQ(bytes(vector, Scalar::float32), 12);
        EXPECT_EQ(bytes(vector, Scalar::float64), 0);
        EXPECT_EQ(bytes(vector, Scalar::uint8), 0);
    }
    EXPECT_EQ(bytes(VertexAttribute::radius, Scalar::float32), 4);
    EXPECT_EQ(bytes(VertexAttribute::radius, Scalar::uint32), 0);
    EXPECT_EQ(bytes(VertexAttribute::color, Scalar::float32), 16);
    EXPECT_EQ(bytes(VertexAttribute::color, Scalar::uint8), 4);
    EXPECT_EQ(bytes(VertexAttribute::color, Scalar::uint32), 0);
    EXPECT_EQ(bytes(VertexAttribute::id, Scalar::uint32), 4);
    EXPECT_EQ(bytes(VertexAttribute::id, Scalar::uint8), 0);
    for (const auto small : {VertexAttribute::mark_class, VertexAttribute::is_paper}) {
        EXPECT_EQ(bytes(small, Scalar::uint8), 1);
        EXPECT_EQ(bytes(small, Scalar::uint32), 4);
        EXPECT_EQ(bytes(small, Scalar::float32), 0);
    }
    EXPECT_EQ(bytes(VertexAttribute::layer, Scalar::uint32), 4);
    EXPECT_EQ(bytes(VertexAttribute::layer, Scalar::uint8), 0);
    EXPECT_EQ(bytes(VertexAttribute::length, Scalar::float32), 4);
    EXPECT_EQ(bytes(VertexAttribute::length, Scalar::uint32), 0);
    EXPECT_EQ(bytes(static_cast<VertexAttribute>(11), Scalar::float32), 0);
}

class WrittenVertices : public Vertices, public ::testing::WithParamInterface<bool> {
protected:
    WrittenVertices() { layers = GetParam(); }
};

TEST_P(WrittenVertices, HoldEveryAttributeAtItsOffset) {
    transform[3] = {0.25, 0.0, -1.0, 1.0};
    transform[0][0] = -0.5;
    set.origin = {0.0, 0.5, 0.0};
    draw(Style{});
    // The offsets are odd and unordered, and some bytes are unused.
    const std::array fields{VertexField{VertexAttribute::color, Scalar::uint8, 1},
                            VertexField{VertexAttribute::window, Scalar::float32, 5},
                            VertexField{VertexAttribute::position, Scalar::float32, 17},
                            VertexField{VertexAttribute::normal, Scalar::float32, 29},
                            VertexField{VertexAttribute::direction, Scalar::float32, 41},
                            VertexField{VertexAttribute::radius, Scalar::float32, 53},
                            VertexField{VertexAttribute::id, Scalar::uint32, 57},
                            VertexField{VertexAttribute::mark_class, Scalar::uint8, 61},
                            VertexField{VertexAttribute::is_paper, Scalar::uint32, 62},
                            VertexField{VertexAttribute::color, Scalar::float32, 66},
                            VertexField{VertexAttribute::mark_class, Scalar::uint32, 82},
                            VertexField{VertexAttribute::is_paper, Scalar::uint8, 86}};
    const std::int64_t stride = 91;
    const std::vector<std::byte> memory = write(fields, stride);
    ASSERT_GT(frame.discs().size(), layers ? 300U : 1000U); // ink only, or paper as well
    for (std::size_t i = 0; i < frame.discs().size(); ++i) {
        const Disc& disc = frame.discs()[i];
        const std::int64_t at = static_cast<std::int64_t>(i) * stride;
        const auto mark = static_cast<std::int64_t>(disc.id) - 1;
        const marks::Layer& layer = set.layers[0];
        ASSERT_EQ(memory[static_cast<std::size_t>(at)], std::byte{0xCD});
        for (std::int64_t k = 87; k < 91; ++k) ASSERT_EQ(memory[static_cast<std::size_t>(at + k)], std::byte{0xCD});
        for (int c = 0; c < 4; ++c) {
            ASSERT_EQ(read<std::uint8_t>(memory, at + 1 + c), static_cast<int>(disc.color[c] * 255.0F + 0.5F));
            ASSERT_EQ(read<float>(memory, at + 66 + 4 * c), disc.color[c]);
        }
        ASSERT_EQ(read<float>(memory, at + 5), disc.x);
        ASSERT_EQ(read<float>(memory, at + 9), disc.y);
        ASSERT_EQ(read<float>(memory, at + 13), disc.depth);
        ASSERT_NEAR(read<float>(memory, at + 17), -0.5F * layer.position[3 * mark] + 0.25F, 1e-6F);
        ASSERT_NEAR(read<float>(memory, at + 21), layer.position[3 * mark + 1] + 0.5F, 1e-6F);
        ASSERT_NEAR(read<float>(memory, at + 25), layer.position[3 * mark + 2] - 1.0F, 1e-6F);
        const glm::vec3 normal(-2.0F * layer.normal[3 * mark], layer.normal[3 * mark + 1], layer.normal[3 * mark + 2]);
        const glm::vec3 direction(-0.5F * layer.direction[3 * mark], layer.direction[3 * mark + 1],
                                  layer.direction[3 * mark + 2]);
        for (int c = 0; c < 3; ++c) {
            ASSERT_NEAR(read<float>(memory, at + 29 + 4 * c), glm::normalize(normal)[c], 1e-6F);
            ASSERT_NEAR(read<float>(memory, at + 41 + 4 * c), glm::normalize(direction)[c], 1e-6F);
        }
        ASSERT_EQ(read<float>(memory, at + 53), disc.radius);
        ASSERT_EQ(read<std::uint32_t>(memory, at + 57), disc.id);
        ASSERT_EQ(read<std::uint8_t>(memory, at + 61), static_cast<std::uint8_t>(disc.mark_class));
        ASSERT_EQ(read<std::uint32_t>(memory, at + 82), static_cast<std::uint32_t>(disc.mark_class));
        ASSERT_EQ(read<std::uint32_t>(memory, at + 62), disc.is_paper ? 1U : 0U);
        ASSERT_EQ(read<std::uint8_t>(memory, at + 86), disc.is_paper ? 1U : 0U);
    }
}

TEST_P(WrittenVertices, DrawnFarToNearGiveTheRasterPicture) {
    Style style;
    style.kind[0].radius = 1.7F;
    style.silhouette_radius = 0.4F;
    style.kind[0].ink = {0.2F, 0.1F, 0.4F, 0.9F};
    for (const glm::vec4 paper : {glm::vec4(1.0F), glm::vec4(0.9F, 0.95F, 0.8F, 1.0F), glm::vec4(0.0F)}) {
        style.paper = paper;
        draw(style);
        Picture picture(size, size);
        output::Raster raster(runtime);
        raster.draw(frame.drawing(), picture.image(), {});
        for (const Scalar scalar : {Scalar::float32, Scalar::uint8}) {
            const std::array fields{VertexField{VertexAttribute::window, Scalar::float32, 0},
                                    VertexField{VertexAttribute::radius, Scalar::float32, 12},
                                    VertexField{VertexAttribute::is_paper, Scalar::uint8, 16},
                                    VertexField{VertexAttribute::color, scalar, 20}};
            const std::int64_t stride = 36;
            const std::vector<std::byte> memory = write(fields, stride);
            std::vector<ReferenceDisc> reference;
            for (std::int64_t at = 0; at < static_cast<std::int64_t>(memory.size()); at += stride) {
                ReferenceDisc s{read<float>(memory, at),
                                read<float>(memory, at + 4),
                                read<float>(memory, at + 12),
                                {},
                                read<std::uint8_t>(memory, at + 16) != 0};
                for (int c = 0; c < 4; ++c)
                    s.color[c] = scalar == Scalar::float32
                                     ? read<float>(memory, at + 20 + 4 * c)
                                     : static_cast<float>(read<std::uint8_t>(memory, at + 20 + c)) / 255.0F;
                reference.push_back(s);
            }
            const auto expected = draw_plainly(reference, size, size, paper);
            // Bytes round the opacity of each disc, and up to a dozen discs may overlap.
            EXPECT_LE(largest_difference(picture, expected), scalar == Scalar::float32 ? 0.51 : 6.0);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Visibility, WrittenVertices, ::testing::Bool(),
                         [](const auto& one) { return one.param ? "layers" : "published"; });

} // namespace
} // namespace hrbfnpr::testing::vertices_test
