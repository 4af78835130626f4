// SPDX-License-Identifier: MIT
// What a file holds: a mesh, or points with or without normals.
#pragma once

#include "../handles.h"

#include <functional>
#include <string_view>

namespace viewer {

struct Shape {
    std::vector<Vec> points;
    std::vector<Vec> normals;                           // of a cloud: none, or one for each point
    std::vector<std::array<std::int32_t, 3>> triangles; // none: a cloud
    std::string format;
};

// Reads PLY, OBJ, STL (both kinds of each) and text of columns, as the file's beginning or its name says.  A Failure
// names the file, the line where there are lines, and what to do.
Shape read_shape(const std::string& path, const std::string& data);

Shape read_ply(const std::string& data);
Shape read_obj(const std::string& data);
Shape read_stl(const std::string& data);
Shape read_xyz(const std::string& data);

// Lines of a text, one after the other, without their ends.
class Lines {
public:
    explicit Lines(std::string_view text) : text_(text) {}
    bool next(std::string_view& line);
    std::size_t number() const { return number_; }
    std::size_t offset() const { return offset_; }
    // A Failure that names the line.
    [[noreturn]] void refuse(const std::string& what) const;

private:
    std::string_view text_;
    std::size_t offset_ = 0, number_ = 0;
};

// Words between blanks, commas, semicolons and tabs.
std::vector<std::string_view> words_of(std::string_view line);
bool parse_number(std::string_view word, double& number);
bool parse_number(std::string_view word, std::int64_t& number);

// A polygon as triangles about its first corner; numbers of vertices must be below `count`.
void add_polygon(Shape& shape, const std::vector<std::int64_t>& corners, std::size_t count,
                 const std::function<void(const std::string&)>& refuse);

} // namespace viewer
