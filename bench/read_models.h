// SPDX-License-Identifier: MIT
// Models from files, for the benchmarks.
#pragma once

#include "samples.h"

#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace bench {

[[nodiscard]] inline std::array<double, 3> unit(const std::array<double, 3>& v) {
    const double length = std::hypot(v[0], v[1], v[2]);
    return {v[0] / length, v[1] / length, v[2] / length};
}

// Reads six float properties per vertex, ascii or little-endian.
inline Samples read_ply(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string line;
    std::size_t count = 0;
    bool binary = false;
    std::string properties;
    while (std::getline(file, line) && line != "end_header") {
        if (line.rfind("element vertex", 0) == 0) count = std::stoull(line.substr(15));
        if (line.rfind("format binary", 0) == 0) binary = true;
        if (line.rfind("property float", 0) == 0) properties += line.substr(14);
    }
    if (properties != " x y z nx ny nz") throw std::runtime_error(path + " is not a PLY of points with normals");
    std::vector<float> numbers(6 * count);
    if (binary)
        file.read(reinterpret_cast<char*>(numbers.data()), static_cast<std::streamsize>(24 * count));
    else
        for (float& number : numbers) file >> number;
    if (!file || count == 0) throw std::runtime_error(path + " is not a PLY of points with normals");
    Samples samples;
    for (std::size_t i = 0; i < count; ++i) {
        const float* at = numbers.data() + 6 * i;
        samples.add({at[0], at[1], at[2]}, unit({at[3], at[4], at[5]}));
    }
    return samples;
}

// Returns the vertices of a mesh that have a face, with normals weighted by face area.
inline Samples read_obj(const std::string& path) {
    std::ifstream file(path);
    std::vector<std::array<double, 3>> position;
    std::vector<std::array<double, 3>> normal;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "v") {
            std::array<double, 3> p{};
            words >> p[0] >> p[1] >> p[2];
            position.push_back(p);
            normal.push_back({});
        } else if (word == "f") {
            std::array<std::size_t, 3> corner{};
            for (std::size_t& c : corner) {
                words >> word;
                c = std::stoull(word) - 1;
            }
            std::array<double, 3> n{};
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t u = (c + 1) % 3;
                const std::size_t v = (c + 2) % 3;
                const auto& a = position.at(corner[0]);
                n[c] = (position.at(corner[1])[u] - a[u]) * (position.at(corner[2])[v] - a[v]) -
                       (position.at(corner[1])[v] - a[v]) * (position.at(corner[2])[u] - a[u]);
            }
            for (const std::size_t c : corner)
                for (std::size_t k = 0; k < 3; ++k) normal.at(c)[k] += n[k];
        }
    }
    Samples samples;
    for (std::size_t i = 0; i < position.size(); ++i)
        if (std::hypot(normal[i][0], normal[i][1], normal[i][2]) > 0.0) samples.add(position[i], unit(normal[i]));
    if (samples.points.empty()) throw std::runtime_error(path + " is not a mesh of triangles");
    return samples;
}

} // namespace bench
