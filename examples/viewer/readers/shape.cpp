// SPDX-License-Identifier: MIT
#include "shape.h"

#include <algorithm>
#include <charconv>

namespace viewer {

namespace {

const char* const remedy = "; python3 -m hrbfnpr check FILE says more, and reads other formats";

std::string ending_of(const std::string& path) {
    const std::size_t dot = path.find_last_of("./");
    std::string ending = dot == std::string::npos || path[dot] == '/' ? "" : path.substr(dot + 1);
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

Shape read_as(const std::string& ending, const std::string& data) {
    if (data.rfind("ply", 0) == 0 && data.size() > 3 && (data[3] == '\n' || data[3] == '\r')) return read_ply(data);
    if (ending == "ply") throw Failure("it is not a PLY file, because it does not begin with \"ply\"");
    if (ending == "obj") return read_obj(data);
    if (ending == "stl") return read_stl(data);
    const bool is_text = ending == "xyz" || ending == "xyzn" || ending == "txt" || ending == "csv" || ending == "asc" ||
                         ending == "pts" || ending == "npts";
    if (is_text) return read_xyz(data);
    throw Failure("the ending \"" + ending + "\" is not read here, only .ply, .obj, .stl, .xyz, .hrbf and .hrbm");
}

} // namespace

Shape read_shape(const std::string& path, const std::string& data) {
    try {
        Shape shape = read_as(ending_of(path), data);
        if (shape.points.empty()) throw Failure("it has no points");
        return shape;
    } catch (const Failure& failure) {
        throw Failure(path + ": " + failure.what() + remedy);
    }
}

bool Lines::next(std::string_view& line) {
    if (offset_ >= text_.size()) return false;
    const std::size_t end = std::min(text_.find_first_of("\n\r", offset_), text_.size());
    line = text_.substr(offset_, end - offset_);
    offset_ = std::min(end + 1, text_.size());
    if (end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n') ++offset_;
    ++number_;
    return true;
}

void Lines::refuse(const std::string& what) const { throw Failure("line " + std::to_string(number_) + ": " + what); }

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    std::size_t begin = 0;
    while ((begin = line.find_first_not_of(" \t,;", begin)) != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(" \t,;", begin), line.size());
        words.push_back(line.substr(begin, end - begin));
        begin = end;
    }
    return words;
}

bool parse_number(std::string_view word, double& number) {
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    const auto result = std::from_chars(word.data(), word.data() + word.size(), number);
    return result.ec == std::errc() && result.ptr == word.data() + word.size();
}

bool parse_number(std::string_view word, std::int64_t& number) {
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    const auto result = std::from_chars(word.data(), word.data() + word.size(), number);
    return result.ec == std::errc() && result.ptr == word.data() + word.size();
}

void add_polygon(Shape& shape, const std::vector<std::int64_t>& corners, std::size_t count,
                 const std::function<void(const std::string&)>& refuse) {
    for (const std::int64_t corner : corners)
        if (corner < 0 || corner >= static_cast<std::int64_t>(count))
            refuse("a face names vertex " + std::to_string(corner) + ", but there are " + std::to_string(count) +
                   " vertices");
    for (std::size_t k = 2; k < corners.size(); ++k)
        shape.triangles.push_back({static_cast<std::int32_t>(corners[0]), static_cast<std::int32_t>(corners[k - 1]),
                                   static_cast<std::int32_t>(corners[k])});
}

} // namespace viewer
