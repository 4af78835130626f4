// SPDX-License-Identifier: MIT
// Hashes of results of a fixed scene that every platform must reproduce bit for bit. With the instruction set BASELINE
// the results are made of additions, products, quotients and square roots, which IEEE 754 defines, in an order that the
// code defines. They use no function of the C library and no sum whose order Eigen chooses (docs/reliability.md names
// the stages that are not here, and why). HRBFNPR_WRITE_HASHES=FILE writes the hashes anew.
#include "stages/stage.h"

#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

namespace api_test::hashes_test {
namespace {

std::uint64_t fnv(const Bytes& bytes) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const std::uint8_t byte : bytes) hash = (hash ^ byte) * 0x100000001b3U;
    return hash;
}

Bytes file_of(const char* path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// Multiples of 2^-20 in [-scale, scale], the same on all platforms.
std::vector<double> random_numbers(int count, double scale) {
    std::vector<double> numbers;
    std::uint64_t state = 1;
    for (int i = 0; i < count; ++i) {
        state = state * 6364136223846793005U + 1442695040888963407U;
        numbers.push_back(scale * (static_cast<double>(state >> 43U) / 1048576.0 - 1.0));
    }
    return numbers;
}

class Scene {
public:
    explicit Scene(std::int32_t threads) {
        auto desc = made(hrbfnpr_context_desc_init);
        desc.thread_count = threads;
        desc.highest_instruction_set = HRBFNPR_INSTRUCTION_SET_BASELINE;
        context_ = make_context(desc);
        const Bytes file = file_of(HRBFNPR_GOLDEN_FILES "/sphere_6.model.v1");
        hrbfnpr_model* model = nullptr;
        EXPECT_OK(hrbfnpr_model_load_memory(context_.get(), file.data(), static_cast<std::int64_t>(file.size()), &model,
                                            error));
        model_.reset(model);
    }

    std::map<std::string, std::string> hashes() {
        std::map<std::string, std::string> result;
        const auto add = [&](const char* name, const Bytes& bytes) {
            char text[32];
            std::snprintf(text, sizeof text, "%016" PRIx64, fnv(bytes));
            result[name] = text;
            EXPECT_FALSE(bytes.empty()) << name;
        };
        add("evaluate", evaluated());
        add("project", projected());
        add("cast_rays", cast());
        add("contains", contained());
        add("lipschitz", bound());
        add("farthest_points", farthest());
        add("mesh", meshed());
        add("own_marks", own());
        return result;
    }

    Error error;

private:
    Bytes evaluated() {
        std::vector<double> value(points_.size() / 3), gradient(points_.size()), hessian(2 * points_.size());
        const hrbfnpr_array from = in(points_);
        const hrbfnpr_array_out values = out(value, 1), gradients = out(gradient), hessians = out(hessian, 6);
        EXPECT_OK(hrbfnpr_model_evaluate(model_.get(), &from, &values, &gradients, &hessians, nullptr, error));
        Bytes bytes;
        append(bytes, value);
        append(bytes, gradient);
        append(bytes, hessian);
        return bytes;
    }
    Bytes projected() {
        std::vector<double> position(points_.size()), normal(points_.size());
        const hrbfnpr_array from = in(points_);
        auto projection = made(hrbfnpr_projection_init);
        projection.position = out(position);
        projection.normal = out(normal);
        EXPECT_OK(hrbfnpr_model_project(model_.get(), &from, nullptr, &projection, nullptr, error));
        Bytes bytes;
        append(bytes, position);
        append(bytes, normal);
        return bytes;
    }
    Bytes cast() {
        std::vector<double> along(points_), t(2 * points_.size() / 3);
        for (double& c : along) c = -c;
        const hrbfnpr_array from = in(points_), directions = in(along);
        auto desc = made(hrbfnpr_cast_desc_init);
        desc.maximum_hits = 2;
        desc.t_min = -2.0;
        auto hits = made(hrbfnpr_ray_hits_init);
        hits.t = out(t, 2);
        EXPECT_OK(hrbfnpr_model_cast_rays(model_.get(), &from, &directions, &desc, &hits, nullptr, error));
        Bytes bytes;
        append(bytes, t);
        return bytes;
    }
    Bytes contained() {
        Bytes inside(points_.size() / 3);
        const hrbfnpr_array from = in(points_);
        const hrbfnpr_array_out to = out(inside, 1);
        EXPECT_OK(hrbfnpr_model_contains(model_.get(), &from, &to, nullptr, nullptr, error));
        return inside;
    }
    Bytes bound() {
        double lipschitz = 0.0;
        EXPECT_OK(hrbfnpr_model_lipschitz(model_.get(), &lipschitz, nullptr, error));
        Bytes bytes;
        append_value(bytes, lipschitz);
        return bytes;
    }
    Bytes farthest() {
        std::vector<std::int32_t> index(300);
        std::vector<double> distance(300);
        const hrbfnpr_array from = in(points_);
        const hrbfnpr_array_out to = out(index, 1), distances = out(distance, 1);
        EXPECT_OK(hrbfnpr_farthest_points(context_.get(), &from, &to, &distances, nullptr, error));
        Bytes bytes;
        append(bytes, index);
        append(bytes, distance);
        return bytes;
    }
    // A dented octahedron, welded and turned: vertices, triangles and given faces.
    Bytes meshed() {
        const std::vector<double> vertices{1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0.25, 0, -0.5, 1, 0, 0};
        const std::vector<std::int32_t> corners{0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 6, 4, 2, 0, 5, 2, 1, 5, 3, 1, 5, 0, 3, 5};
        auto desc = made(hrbfnpr_mesh_desc_init);
        desc.vertices = in(vertices);
        desc.triangles = in(corners);
        hrbfnpr_mesh* mesh = nullptr;
        EXPECT_OK(hrbfnpr_mesh_create(context_.get(), &desc, nullptr, &mesh, error));
        const Mesh owned(mesh);
        Bytes bytes;
        hrbfnpr_array view{};
        EXPECT_OK(hrbfnpr_mesh_view(mesh, HRBFNPR_MESH_ATTRIBUTE_VERTEX, &view, error));
        append(bytes, elements<double>(view));
        for (const std::uint32_t which : {HRBFNPR_MESH_ATTRIBUTE_TRIANGLE, HRBFNPR_MESH_ATTRIBUTE_GIVEN_FACE}) {
            EXPECT_OK(hrbfnpr_mesh_view(mesh, which, &view, error));
            append(bytes, elements<std::int32_t>(view));
        }
        return bytes;
    }
    // A point set with directions and ranks that the library computes.
    Bytes own() {
        const std::vector<std::uint32_t> first{0, 100, 250, 500};
        auto arrays = made(hrbfnpr_layer_arrays_init);
        arrays.position = in(points_);
        arrays.normal = in(normals_);
        arrays.position.count = arrays.normal.count = 500;
        arrays.stroke_first = in(first, 1);
        auto desc = made(hrbfnpr_point_set_desc_init);
        desc.layers = &arrays;
        desc.layer_count = 1;
        hrbfnpr_point_set* set = nullptr;
        EXPECT_OK(hrbfnpr_point_set_create(context_.get(), &desc, &set, error));
        Bytes bytes;
        append(bytes, PointSet(set));
        return bytes;
    }

    static std::vector<double> unit_vectors() {
        std::vector<double> normals = random_numbers(3 * 1000, 1.0);
        for (std::size_t i = 0; i < normals.size(); i += 3) {
            normals[i] = normals[i + 1] = 0.0;
            normals[i + 2] = 1.0;
        }
        return normals;
    }

    Context context_;
    Model model_;
    std::vector<double> points_ = random_numbers(3 * 1000, 1.25);
    std::vector<double> normals_ = unit_vectors();
};

std::map<std::string, std::string> recorded() {
    std::map<std::string, std::string> hashes;
    std::ifstream file(HRBFNPR_HASH_FILE);
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string name, hash;
        if (line.rfind('#', 0) != 0 && words >> name >> hash) hashes[name] = hash;
    }
    return hashes;
}

TEST(Hashes, MatchTheRecordedHashesOfAFixedScene) {
    const auto hashes = Scene(1).hashes();
    EXPECT_EQ(Scene(3).hashes(), hashes);
    if (const char* path = std::getenv("HRBFNPR_WRITE_HASHES"); path != nullptr) {
        std::ofstream file(path);
        file << "# Stage and FNV-1a hash of what it gives: tests/api/determinism/hashes_test.cpp\n";
        for (const auto& [name, hash] : hashes) file << name << ' ' << hash << '\n';
    }
    EXPECT_EQ(hashes, recorded());
}

} // namespace
} // namespace api_test::hashes_test
