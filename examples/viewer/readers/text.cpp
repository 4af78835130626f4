// SPDX-License-Identifier: MIT
// OBJ, STL, and text in columns.
#include "shape.h"

#include <cstring>

namespace viewer {

namespace {

Vec vec_of(const std::vector<std::string_view>& words, std::size_t first, Lines& lines) {
    Vec result{};
    for (std::size_t k = 0; k < 3; ++k)
        if (first + k >= words.size() || !parse_number(words[first + k], result[k]))
            lines.refuse("this line needs three numbers");
    return result;
}

// Returns the vertex, counted from 0, that "7", "7/1", "7//3" or "-1" names.
std::int64_t corner_of(std::string_view word, std::size_t count, Lines& lines) {
    std::int64_t number = 0;
    if (!parse_number(word.substr(0, word.find('/')), number) || number == 0)
        lines.refuse("\"" + std::string(word) + "\" is not a corner of a face");
    return number > 0 ? number - 1 : static_cast<std::int64_t>(count) + number;
}

Shape read_ascii_stl(const std::string& data) {
    Shape shape;
    shape.format = "STL";
    Lines lines(data);
    std::string_view line;
    while (lines.next(line)) {
        const auto words = words_of(line);
        if (words.empty() || words[0] != "vertex") continue;
        shape.points.push_back(vec_of(words, 1, lines));
    }
    if (shape.points.size() % 3 != 0) lines.refuse("the last face has fewer than three vertices; the file is cut off");
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(shape.points.size()); i += 3)
        shape.triangles.push_back({i, i + 1, i + 2});
    return shape;
}

} // namespace

Shape read_obj(const std::string& data) {
    Shape shape;
    shape.format = "OBJ";
    Lines lines(data);
    std::string_view line;
    std::vector<std::int64_t> corners;
    std::vector<std::pair<std::size_t, std::vector<std::int64_t>>> faces; // a face may name vertices that come later
    while (lines.next(line)) {
        const auto words = words_of(line);
        if (words.empty()) continue;
        if (words[0] == "v") shape.points.push_back(vec_of(words, 1, lines));
        if (words[0] == "vn") shape.normals.push_back(vec_of(words, 1, lines));
        if (words[0] != "f") continue;
        if (words.size() < 4) lines.refuse("a face needs at least three corners");
        corners.clear();
        for (std::size_t k = 1; k < words.size(); ++k)
            corners.push_back(corner_of(words[k], shape.points.size(), lines));
        faces.emplace_back(lines.number(), corners);
    }
    for (const auto& [number, face] : faces)
        add_polygon(shape, face, shape.points.size(), [&, at = number](const std::string& what) {
            throw Failure("line " + std::to_string(at) + ": " + what);
        });
    if (!shape.triangles.empty() || shape.normals.size() != shape.points.size()) shape.normals.clear();
    return shape;
}

Shape read_stl(const std::string& data) {
    std::uint32_t count = 0;
    if (data.size() >= 84)
        std::memcpy(&count, data.data() + 80, 4); // little-endian, as are all machines that this runs on
    const bool is_text = data.rfind("solid", 0) == 0 && data.find("facet") != std::string::npos;
    if (is_text && data.size() != 84 + 50 * std::size_t{count}) return read_ascii_stl(data);
    if (data.size() < 84 + 50 * std::size_t{count} || data.size() < 84)
        throw Failure("it is too short for the " + std::to_string(count) +
                      " faces of its header; it is cut off, or not an STL file");
    Shape shape;
    shape.format = "STL";
    for (std::uint32_t face = 0; face < count; ++face) {
        std::array<float, 9> corners;
        std::memcpy(corners.data(), data.data() + 84 + 50 * std::size_t{face} + 12, sizeof corners);
        const auto first = static_cast<std::int32_t>(shape.points.size());
        for (std::size_t k = 0; k < 9; k += 3) shape.points.push_back({corners[k], corners[k + 1], corners[k + 2]});
        shape.triangles.push_back({first, first + 1, first + 2});
    }
    return shape;
}

Shape read_xyz(const std::string& data) {
    Shape shape;
    shape.format = "XYZ";
    Lines lines(data);
    std::string_view line;
    std::size_t columns = 0;
    while (lines.next(line)) {
        line = line.substr(0, line.find('#'));
        const auto words = words_of(line);
        double number = 0;
        const bool is_title = columns == 0 && !words.empty() && (!parse_number(words[0], number) || words.size() == 1);
        if (words.empty() || is_title) continue; // the line has names of columns or the number of lines
        if (columns == 0) columns = words.size();
        if (words.size() != columns)
            lines.refuse(std::to_string(columns) + " numbers are needed, as in the lines before, not " +
                         std::to_string(words.size()));
        shape.points.push_back(vec_of(words, 0, lines));
        if (columns == 6) shape.normals.push_back(vec_of(words, 3, lines));
    }
    if (columns == 0 && lines.number() > 0) throw Failure("it has no line with at least three numbers");
    if (columns != 0 && columns < 3) throw Failure("each line needs at least three numbers");
    return shape;
}

} // namespace viewer
