// SPDX-License-Identifier: MIT
// Pages as the benchmarks write them: to nowhere, or to memory to be read again.
#pragma once

#include "calls.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace bench {

struct PagePlace {
    double x, y; // mm, y down
};
using PageLine = std::vector<PagePlace>;

constexpr double page_side = 180.0; // mm, of all pages

// A page that a drawing of `pixels` by `pixels` fills.
struct Page : hrbfnpr_page_desc {
    Page() : hrbfnpr_page_desc(scenes::made(hrbfnpr_page_desc_init)) { width = height = page_side; }
    Page(const hrbfnpr_drawing* drawing, double pixels) : Page() {
        item.drawing = drawing;
        item.scale = page_side / pixels;
    }
    // Writes the page through `to`.
    hrbfnpr_page_info send(hrbfnpr_context* context, hrbfnpr_write_fn to, void* user) {
        if (item.drawing != nullptr) {
            items = &item;
            item_count = 1;
        }
        scenes::Check check;
        auto info = scenes::made(hrbfnpr_page_info_init);
        check(hrbfnpr_page_write(context, this, to, user, &info, nullptr, check.error()));
        return info;
    }
    hrbfnpr_page_info write(hrbfnpr_context* context) { return send(context, count_bytes, nullptr); }
    std::string text(hrbfnpr_context* context) {
        std::string all;
        send(context, append, &all);
        return all;
    }

    hrbfnpr_page_item item = scenes::made(hrbfnpr_page_item_init);

private:
    static std::int32_t count_bytes(void*, const void*, std::uint64_t) { return 0; }
    static std::int32_t append(void* user, const void* data, std::uint64_t size) {
        static_cast<std::string*>(user)->append(static_cast<const char*>(data), size);
        return 0;
    }
};

// Returns the travel of a pen between the lines, starting at the lower left corner.
[[nodiscard]] inline double travel(const std::vector<PageLine>& lines) {
    PagePlace pen{0.0, page_side};
    double sum = 0.0;
    for (const PageLine& line : lines) {
        sum += std::hypot(line.front().x - pen.x, line.front().y - pen.y);
        pen = line.back();
    }
    return sum;
}

// Returns the hours that a plotter needs at the speeds of a page.
[[nodiscard]] inline double plotter_hours(const hrbfnpr_page_desc& desc, double drawn, double travelled,
                                          std::size_t lifts) {
    return (drawn / desc.draw_speed + travelled / desc.travel_speed +
            2.0 * desc.pen_seconds * static_cast<double>(lifts)) /
           3600.0;
}

// Reads the number that begins at text[at], or after one blank or comma, and moves `at` past it; false if there is
// none.
inline bool next_number(std::string_view text, std::size_t& at, double& number) {
    std::size_t begin = at;
    if (begin < text.size() && (text[begin] == ' ' || text[begin] == ',')) ++begin;
    const auto [end, error] = std::from_chars(text.data() + begin, text.data() + text.size(), number);
    if (error != std::errc{}) return false;
    at = static_cast<std::size_t>(end - text.data());
    return true;
}

// Returns all numbers of a text in order, including those in words like "h1".
[[nodiscard]] inline std::vector<double> numbers_of(std::string_view text) {
    std::vector<double> numbers;
    for (std::size_t at = 0; at < text.size();) {
        double number = 0.0;
        if (next_number(text, at, number))
            numbers.push_back(number);
        else
            ++at;
    }
    return numbers;
}

// Returns the data of each path of an SVG.
[[nodiscard]] inline std::vector<std::string_view> path_data(std::string_view svg) {
    constexpr std::string_view begin = " d=\"";
    std::vector<std::string_view> paths;
    for (std::size_t at = svg.find(begin); at != std::string_view::npos; at = svg.find(begin, at)) {
        at += begin.size();
        paths.push_back(svg.substr(at, svg.find('"', at) - at));
    }
    return paths;
}

} // namespace bench
