// SPDX-License-Identifier: MIT
// The content of a file: a mesh, or points with or without normals.
#pragma once

#include "../handles.h"

#include <functional>
#include <string_view>

namespace viewer {

struct Shape {
    std::vector<Vec> points;
    std::vector<Vec> normals;                           // for a point cloud: one for each point, or empty
    std::vector<std::array<std::int32_t, 3>> triangles; // empty for a point cloud
    std::string format;
};

// Reads PLY, OBJ, STL (both kinds of each) and text in columns. The beginning or the name of the file tells which. A
// Failure names the file, the line if there are lines, and what to do.
Shape read_shape(const std::string& path, const std::string& data);

Shape read_ply(const std::string& data);
Shape read_obj(const std::string& data);
Shape read_stl(const std::string& data);
Shape read_xyz(const std::string& data);

// Returns the lines of a text one after the other, without their ends.
class Lines {
public:
    explicit Lines(std::string_view text) : text_(text) {}
    bool next(std::string_view& line);
    std::size_t number() const { return number_; }
    std::size_t offset() const { return offset_; }
    // Throws a Failure that names the line.
    [[noreturn]] void refuse(const std::string& what) const;

private:
    std::string_view text_;
    std::size_t offset_ = 0, number_ = 0;
};

// Splits a line into words at blanks, commas, semicolons and tabs.
std::vector<std::string_view> words_of(std::string_view line);
bool parse_number(std::string_view word, double& number);
bool parse_number(std::string_view word, std::int64_t& number);

// Adds a polygon as a fan of triangles about its first corner. Vertex numbers must be below `count`.
void add_polygon(Shape& shape, const std::vector<std::int64_t>& corners, std::size_t count,
                 const std::function<void(const std::string&)>& refuse);

} // namespace viewer
