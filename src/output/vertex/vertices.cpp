#include "output/vertex/vertices.h"

#include <cmath>
#include <cstring>

namespace hrbfnpr::output {
namespace {

constexpr std::int64_t grain = 4096;

using base::Scalar;

template <class T>
void put(std::byte*& to, T value) noexcept {
    std::memcpy(to, &value, sizeof value); // a layout need not be aligned
    to += sizeof value;
}

void put_vector(std::byte* to, const glm::vec3& v) noexcept {
    for (int i = 0; i < 3; ++i) put(to, v[i]);
}

void put_integer(std::byte* to, Scalar scalar, std::uint32_t value) noexcept {
    if (scalar == Scalar::uint8)
        put(to, static_cast<std::uint8_t>(value));
    else
        put(to, value);
}

void put_color(std::byte* to, Scalar scalar, const glm::vec4& color) noexcept {
    for (int i = 0; i < 4; ++i) {
        if (scalar == Scalar::uint8)
            put(to, static_cast<std::uint8_t>(std::clamp(color[i], 0.0F, 1.0F) * 255.0F + 0.5F));
        else
            put(to, color[i]);
    }
}

// A disc with what is known of the mark behind it, asked for once if any field wants it.
struct Vertex {
    const frame::Disc& disc;
    frame::Frame::MarkSource source;
};

void put_field(std::byte* to, const VertexField& field, const Vertex& vertex) noexcept {
    const frame::Disc& disc = vertex.disc;
    switch (field.attribute) {
    case VertexAttribute::position: put_vector(to, vertex.source.position); break;
    case VertexAttribute::window: put_vector(to, {disc.x, disc.y, disc.depth}); break;
    case VertexAttribute::radius: put(to, disc.radius); break;
    case VertexAttribute::color: put_color(to, field.scalar, disc.color); break;
    case VertexAttribute::normal: put_vector(to, vertex.source.normal); break;
    case VertexAttribute::direction: put_vector(to, vertex.source.direction); break;
    case VertexAttribute::id: put(to, disc.id); break;
    case VertexAttribute::mark_class: put_integer(to, field.scalar, static_cast<std::uint32_t>(disc.mark_class)); break;
    case VertexAttribute::is_paper: put_integer(to, field.scalar, disc.is_paper ? 1U : 0U); break;
    }
}

[[nodiscard]] bool wants_source(std::span<const VertexField> fields) noexcept {
    for (const VertexField& field : fields) {
        if (field.attribute == VertexAttribute::position || field.attribute == VertexAttribute::normal ||
            field.attribute == VertexAttribute::direction)
            return true;
    }
    return false;
}

} // namespace

std::int64_t size_of(const VertexField& field) noexcept {
    const bool is_float = field.scalar == Scalar::float32;
    const bool is_byte = field.scalar == Scalar::uint8;
    const bool is_integer = field.scalar == Scalar::uint32;
    switch (field.attribute) {
    case VertexAttribute::position:
    case VertexAttribute::window:
    case VertexAttribute::normal:
    case VertexAttribute::direction: return is_float ? 12 : 0;
    case VertexAttribute::radius: return is_float ? 4 : 0;
    case VertexAttribute::color: return is_float ? 16 : is_byte ? 4 : 0;
    case VertexAttribute::id: return is_integer ? 4 : 0;
    case VertexAttribute::mark_class:
    case VertexAttribute::is_paper: return is_byte ? 1 : is_integer ? 4 : 0;
    }
    return 0;
}

void write_vertices(const base::Runtime& runtime, const frame::Frame& frame, std::span<const VertexField> fields,
                    std::int64_t stride, std::byte* destination) {
    const std::span<const frame::Disc> discs = frame.discs();
    const bool sources = wants_source(fields);
    runtime.parallel.for_chunks(static_cast<std::int64_t>(discs.size()), grain,
                                [&](std::int64_t begin, std::int64_t end) {
                                    for (std::int64_t i = begin; i < end; ++i) {
                                        const frame::Disc& disc = discs[static_cast<std::size_t>(i)];
                                        Vertex vertex{disc, {}};
                                        if (sources) vertex.source = frame.source(disc);
                                        for (const VertexField& field : fields)
                                            put_field(destination + i * stride + field.offset, field, vertex);
                                    }
                                });
}

} // namespace hrbfnpr::output
