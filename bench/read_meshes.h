// SPDX-License-Identifier: MIT
// Triangle meshes from files, for the benchmarks: OBJ, and PLY in little-endian order as scanners write it.
#pragma once

#include "support/meshes.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bench {

using hrbfnpr::test::Triangles;

inline Triangles read_obj_mesh(const std::string& path) {
    std::ifstream file(path);
    Triangles mesh;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "v") {
            double x = 0.0, y = 0.0, z = 0.0;
            words >> x >> y >> z;
            static_cast<void>(mesh.add(x, y, z));
        } else if (word == "f") {
            std::vector<std::int32_t> corner;
            while (words >> word) corner.push_back(std::stoi(word) - 1);
            for (std::size_t k = 2; k < corner.size(); ++k) mesh.face(corner[0], corner[k - 1], corner[k]);
        }
    }
    return mesh;
}

// Vertices begin with x, y and z as float, and all further vertex properties are float; faces are uchar and int lists.
inline Triangles read_ply_mesh(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string line;
    std::size_t vertices = 0, faces = 0, properties = 0;
    bool binary = false, of_vertex = false;
    while (std::getline(file, line) && line.rfind("end_header", 0) != 0) {
        if (line.rfind("format binary_little", 0) == 0) binary = true;
        if (line.rfind("element", 0) == 0) of_vertex = line.rfind("element vertex", 0) == 0;
        if (line.rfind("element vertex", 0) == 0) vertices = std::stoull(line.substr(15));
        if (line.rfind("element face", 0) == 0) faces = std::stoull(line.substr(13));
        if (of_vertex && line.rfind("property float", 0) == 0) ++properties;
    }
    if (!binary || properties < 3) throw std::runtime_error(path + " is not a binary PLY of a mesh");
    Triangles mesh;
    std::vector<float> row(properties);
    for (std::size_t i = 0; i < vertices; ++i) {
        file.read(reinterpret_cast<char*>(row.data()), static_cast<std::streamsize>(4 * properties));
        static_cast<void>(mesh.add(row[0], row[1], row[2]));
    }
    for (std::size_t i = 0; i < faces; ++i) {
        char corners[13];
        file.read(corners, sizeof corners);
        std::int32_t corner[3];
        std::memcpy(corner, corners + 1, sizeof corner);
        mesh.face(corner[0], corner[1], corner[2]);
    }
    if (!file) throw std::runtime_error(path + " ends too early");
    return mesh;
}

// Returns all meshes of a folder with `named` in the file name, sorted by name.
inline std::vector<std::pair<std::string, Triangles>> read_meshes(const std::string& folder, const std::string& named) {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().filename().string().find(named) != std::string::npos) paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<std::pair<std::string, Triangles>> meshes;
    for (const std::filesystem::path& path : paths) {
        if (path.extension() == ".obj") meshes.emplace_back(path.stem().string(), read_obj_mesh(path.string()));
        if (path.extension() == ".ply") meshes.emplace_back(path.stem().string(), read_ply_mesh(path.string()));
    }
    return meshes;
}

} // namespace bench
