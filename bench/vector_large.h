// SPDX-License-Identifier: MIT
// A drawing of a million dots and 100 000 strokes: the speed and the memory of writing it.
#pragma once

#include "stroke_painter.h"
#include "timing.h"
#include "vector_page.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bench {

constexpr std::int64_t many_dots = 1'000'000, many_strokes = 100'000;
constexpr int marks_of_stroke = 12;
constexpr double large_size = 8000.0; // pixels

// Marks of a layer on the plane z = 0, within a square of side 2.
struct FlatLayer {
    std::vector<double> position, normal;
    std::vector<float> width;
    std::vector<std::uint32_t> first{0};

    void add(double x, double y, double share) {
        position.insert(position.end(), {x, y, 0.0});
        normal.insert(normal.end(), {0.0, 0.0, 1.0});
        width.push_back(static_cast<float>(share));
    }
    [[nodiscard]] hrbfnpr_layer_arrays arrays(const char* name) const {
        auto layer = scenes::made(hrbfnpr_layer_arrays_init);
        layer.name = name;
        layer.position = view(position);
        layer.normal = view(normal);
        if (first.size() == 1) return layer;
        layer.stroke_first = {first.data(), static_cast<std::int64_t>(first.size()), 0, HRBFNPR_SCALAR_UINT32, 1};
        layer.width = {width.data(), static_cast<std::int64_t>(width.size()), 0, HRBFNPR_SCALAR_FLOAT32, 1};
        return layer;
    }
};

// Random numbers that are the same on every machine.
class Places {
public:
    double next() { return static_cast<double>(engine_()) / 4294967296.0; }

private:
    std::mt19937 engine_{1};
};

[[nodiscard]] inline FlatLayer flat_dots(std::int64_t count) {
    FlatLayer layer;
    Places places;
    for (std::int64_t i = 0; i < count; ++i) {
        const double x = 1.98 * places.next() - 0.99, y = 1.98 * places.next() - 0.99;
        layer.add(x, y, 1.0);
    }
    return layer;
}

// Short curves whose widths swell in the middle, like hatching, or are constant.
[[nodiscard]] inline FlatLayer flat_strokes(std::int64_t count, bool swelling) {
    FlatLayer layer;
    Places places;
    for (std::int64_t i = 0; i < count; ++i) {
        double x = 1.9 * places.next() - 0.95, y = 1.9 * places.next() - 0.95, angle = 6.2831853 * places.next();
        const double bend = 0.4 * (places.next() - 0.5);
        for (int k = 0; k < marks_of_stroke; ++k, angle += bend) {
            const double middle = 1.0 - std::abs(2.0 * k / (marks_of_stroke - 1.0) - 1.0);
            layer.add(x, y, swelling ? 0.3 + 0.7 * middle : 1.0);
            x += 0.002 * std::cos(angle);
            y += 0.002 * std::sin(angle);
        }
        layer.first.push_back(static_cast<std::uint32_t>(layer.width.size()));
    }
    return layer;
}

// A drawing of these layers, and the objects that it was made with.
class LargeDrawing {
public:
    LargeDrawing(hrbfnpr_context* context, const std::vector<hrbfnpr_layer_arrays>& layers)
        : set_(set_of(context, layers)), painter_(context, set_.get(), style()) {
        const double low[3] = {-1.0, -1.0, -0.1}, high[3] = {1.0, 1.0, 0.1}, direction[3] = {0.0, 0.0, -1.0};
        const double up[3] = {0.0, 1.0, 0.0};
        scenes::Check check;
        auto camera = scenes::made(hrbfnpr_camera_init);
        check(hrbfnpr_camera_fit_bounds(&camera, low, high, direction, up, 0.0, large_size, large_size, 0.0,
                                        check.error()));
        painter_.draw(camera);
    }
    [[nodiscard]] const hrbfnpr_drawing* get() const { return painter_.drawing(); }
    [[nodiscard]] hrbfnpr_drawing_info info() const {
        scenes::Check check;
        auto info = scenes::made(hrbfnpr_drawing_info_init);
        check(hrbfnpr_drawing_get_info(get(), &info, check.error()));
        return info;
    }

private:
    static scenes::PointSet set_of(hrbfnpr_context* context, const std::vector<hrbfnpr_layer_arrays>& layers) {
        scenes::Check check;
        auto desc = scenes::made(hrbfnpr_point_set_desc_init);
        desc.layers = layers.data();
        desc.layer_count = static_cast<std::int64_t>(layers.size());
        hrbfnpr_point_set* set = nullptr;
        check(hrbfnpr_point_set_create(context, &desc, &set, check.error()));
        return scenes::PointSet(set);
    }
    static Style style() {
        Style style(HRBFNPR_PRESET_STIPPLE);
        style.tone = HRBFNPR_TONE_NONE;
        style.hidden_lines = HRBFNPR_HIDDEN_LINES_SHOW;
        auto layer = scenes::made(hrbfnpr_layer_style_init);
        layer.contours = 0;
        layer.shape = HRBFNPR_SHAPE_STROKES;
        layer.radius = 2.0F;
        style.layer = {layer};
        return style;
    }
    scenes::PointSet set_;
    StrokePainter painter_;
};

// ---- Speed ------------------------------------------------------------------------------------

// Writes to a stream, as a program would.
[[nodiscard]] inline std::int32_t to_stream(void* user, const void* data, std::uint64_t size) {
    return std::fwrite(data, 1, size, static_cast<std::FILE*>(user)) == size ? 0 : 1;
}

struct WriteSpeed {
    double seconds, of_printf; // of_printf: the time that printf takes for the same numbers, over `seconds`
    hrbfnpr_page_info info;
    std::size_t numbers;
};

[[nodiscard]] inline WriteSpeed write_speed(hrbfnpr_context* context, const hrbfnpr_drawing* drawing) {
    Page page(drawing, large_size);
    const std::vector<double> numbers = numbers_of(page.text(context));
    std::FILE* const nowhere = std::fopen("/dev/null", "w");
    if (nowhere == nullptr) throw std::runtime_error("there is no /dev/null to write to");
    hrbfnpr_page_info info{};
    const Comparison time = compare(
        5,
        [&] {
            for (const double number : numbers) std::fprintf(nowhere, "%g ", number);
        },
        [&] { info = page.send(context, to_stream, nowhere); });
    std::fclose(nowhere);
    return {time.seconds, time.ratio, info, numbers.size()};
}

inline WriteSpeed print_speed(hrbfnpr_context* context, const char* what, const LargeDrawing& drawing) {
    const WriteSpeed speed = write_speed(context, drawing.get());
    std::printf("%s: %.1f MB of %lld dots, %lld paths and %lld curves in %.3f s, %.1f MB/s; fprintf(\"%%g \") of its "
                "%zu numbers takes %.3f s, %.2f times as long\n",
                what, 1e-6 * static_cast<double>(speed.info.bytes), static_cast<long long>(speed.info.dots),
                static_cast<long long>(speed.info.paths), static_cast<long long>(speed.info.segments), speed.seconds,
                1e-6 * static_cast<double>(speed.info.bytes) / speed.seconds, speed.numbers,
                speed.seconds * speed.of_printf, speed.of_printf);
    return speed;
}

// ---- Memory -----------------------------------------------------------------------------------

// Returns the memory of this process in MB: the present one, or the peak since forget_peak().  Linux; elsewhere 0.
[[nodiscard]] inline double resident_mb(const char* which) {
    std::ifstream file("/proc/self/status");
    for (std::string line; std::getline(file, line);)
        if (line.rfind(which, 0) == 0) return std::stod(line.substr(line.find(':') + 1)) * 1024e-6;
    return 0.0;
}
inline void forget_peak() { std::ofstream("/proc/self/clear_refs") << '5'; }

struct WriteMemory {
    double context_mb, resident_mb;
};

// Uses a separate context, whose peak is that of writing alone.
[[nodiscard]] inline WriteMemory write_memory(const hrbfnpr_drawing* drawing, std::uint32_t format) {
    const scenes::Context context = make_context();
    scenes::Check check;
    const auto info = [&] {
        auto now = scenes::made(hrbfnpr_context_info_init);
        check(hrbfnpr_context_get_info(context.get(), &now, check.error()));
        return now;
    };
    const std::int64_t before = info().bytes_now;
    forget_peak();
    const double resident = resident_mb("VmRSS");
    Page page(drawing, large_size);
    page.format = format;
    page.write(context.get());
    return {1e-6 * static_cast<double>(info().bytes_peak - before), resident_mb("VmHWM") - resident};
}

// ---- Both -------------------------------------------------------------------------------------

inline void write_large_drawings(hrbfnpr_context* context) {
    const FlatLayer dots = flat_dots(many_dots), strokes = flat_strokes(many_strokes, true),
                    even = flat_strokes(many_strokes, false);
    {
        const LargeDrawing both(context, {dots.arrays("dots"), strokes.arrays("strokes")});
        std::printf("a drawing of %lld dots and %lld strokes\n", static_cast<long long>(both.info().dots),
                    static_cast<long long>(both.info().strokes));
        double most = 0.0;
        for (const auto& [name, format] :
             {std::pair{"SVG", HRBFNPR_PAGE_FORMAT_SVG}, {"PDF", HRBFNPR_PAGE_FORMAT_PDF}}) {
            const WriteMemory memory = write_memory(both.get(), static_cast<std::uint32_t>(format));
            std::printf("memory beyond the drawing to write it as %s: %.3f MB of the context, %.3f MB resident\n", name,
                        memory.context_mb, memory.resident_mb);
            most = std::max({most, memory.context_mb, memory.resident_mb});
        }
        report("vector.memory_mb", most);
        const WriteSpeed speed = print_speed(context, "both", both);
        report("vector.svg_mb_per_s", 1e-6 * static_cast<double>(speed.info.bytes) / speed.seconds);
        report("vector.svg_of_printf", speed.of_printf);
    }
    print_speed(context, "dots", LargeDrawing(context, {dots.arrays("dots")}));
    print_speed(context, "strokes of one width", LargeDrawing(context, {even.arrays("strokes")}));
    const WriteSpeed speed =
        print_speed(context, "strokes that swell", LargeDrawing(context, {strokes.arrays("strokes")}));
    report("vector.strokes_per_s", static_cast<double>(many_strokes) / speed.seconds);
    report("vector.strokes_of_printf", speed.of_printf);
}

} // namespace bench
