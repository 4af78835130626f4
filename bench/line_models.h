// SPDX-License-Identifier: MIT
// The surfaces whose contours are drawn: generated samples, and files of a folder.
#pragma once

#include "line_calls.h"
#include "read_models.h"
#include "samples.h"
#include "scenes/shapes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace bench {

// A surface, its line set, and the few marks that an item needs.
struct LineModel {
    std::string name;
    scenes::Model model;
    LineSet lines;
    scenes::PointSet marks;
    double fit_seconds = 0.0;
};

[[nodiscard]] inline LineModel line_model(hrbfnpr_context* context, const std::string& name, scenes::Model model) {
    LineModel made{name, std::move(model), {}, {}, 0.0};
    made.lines = make_line_set(context, made.model.get());
    made.marks = generate(context, made.model.get(), one_layer(HRBFNPR_LAYER_KIND_STIPPLES, 64));
    return made;
}

// Fits at most `most` centres.
[[nodiscard]] inline scenes::Model fit_centres(hrbfnpr_context* context, const Samples& samples, std::int64_t most) {
    scenes::Check check;
    auto desc = scenes::made(hrbfnpr_fit_desc_init);
    desc.points = view(samples.points);
    desc.normals = view(samples.normals);
    if (samples.count() > most) desc.maximum_centres = most;
    hrbfnpr_model* model = nullptr;
    check(hrbfnpr_model_fit(context, &desc, nullptr, &model, check.error()));
    return scenes::Model(model);
}

// Samples to fit.
struct Source {
    std::string name;
    std::function<Samples()> samples;
    std::int64_t centres;
};

[[nodiscard]] inline std::string numbered(std::string name, std::int64_t number) {
    name += ' ';
    name += std::to_string(number);
    return name;
}

[[nodiscard]] inline std::vector<Source> generated_sources() {
    std::vector<Source> sources;
    for (const int count : {1000, 4000}) {
        sources.push_back({numbered("bumpy", count), [count] { return bumpy(count); }, count});
        sources.push_back({numbered("torus", count), [count] { return hrbfnpr::test::even_torus(count); }, count});
        sources.push_back({numbered("knot tube", count), [count] { return scenes::trefoil(count); }, count});
        sources.push_back({numbered("linked tori", count), [count] { return scenes::linked_tori(count / 2); }, count});
    }
    return sources;
}

// Tells whether a file has a surface without a border that is small enough to read at once.
[[nodiscard]] inline bool is_closed_model(const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    const std::array<const char*, 3> others{"canyon", "raw", "dragon"};
    return path.extension() == ".ply" && std::none_of(others.begin(), others.end(), [&](const char* other) {
               return name.find(other) != std::string::npos;
           });
}

[[nodiscard]] inline std::vector<Source> sources_of(const std::string& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (is_closed_model(entry.path())) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<Source> sources;
    for (const std::filesystem::path& file : files) {
        const std::int64_t samples = read_ply(file.string()).count();
        for (const std::int64_t centres : {1000, 4000}) {
            const std::string name = numbered(file.stem().string(), std::min(samples, centres));
            sources.push_back({name, [file] { return read_ply(file.string()); }, centres});
            if (samples <= centres) break;
        }
    }
    return sources;
}

} // namespace bench
