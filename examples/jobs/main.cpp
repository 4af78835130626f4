// SPDX-License-Identifier: MIT
// A host whose own job system runs hrbfnpr's work. The library starts no thread.
//
//     jobs PICTURE.pam [SAMPLES.xyzn]
//
// The drawing is written to PICTURE, a PAM file (a short header and raw RGBA rows).
#include "pool.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <hrbfnpr.h>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr int width = 640, height = 480;
constexpr std::size_t pool_threads = 4;

hrbfnpr_error error;

void check(hrbfnpr_status status) {
    if (status != HRBFNPR_STATUS_OK) throw std::runtime_error(error.message);
}

// Calls a hrbfnpr_..._create function and owns the handle that it makes.
template <class Handle, class Release, class Call>
auto make(Release release, Call&& call) {
    Handle* handle = nullptr;
    check(call(&handle));
    return std::unique_ptr<Handle, Release>(handle, release);
}

// Returns a descriptor with every default in place.
template <class Struct, class Init>
Struct defaults(Init init) {
    Struct result;
    check(init(&result, sizeof result));
    return result;
}

// This function is all that a job system has to provide.
void run_tasks(void* user, hrbfnpr_task_fn task, void* task_context, std::int64_t task_count) {
    static_cast<Pool*>(user)->run(task, task_context, task_count);
}

auto make_context(Pool& pool) {
    auto desc = defaults<hrbfnpr_context_desc>(hrbfnpr_context_desc_init);
    desc.thread_count = pool_threads + 1; // the calling thread works, too
    desc.run_tasks = run_tasks;
    desc.run_tasks_user = &pool;
    return make<hrbfnpr_context>(hrbfnpr_context_release,
                                 [&](auto out) { return hrbfnpr_context_create(&desc, out, &error); });
}

// Each sample is six numbers: point and normal.
std::vector<std::array<double, 6>> read_samples(const std::string& path) {
    std::ifstream file(path);
    std::vector<std::array<double, 6>> samples;
    for (std::array<double, 6> s; file >> s[0] >> s[1] >> s[2] >> s[3] >> s[4] >> s[5];) samples.push_back(s);
    if (!file.eof()) throw std::runtime_error("cannot read " + path + "; each line must be x y z nx ny nz");
    return samples;
}

std::vector<unsigned char> draw(Pool& pool, const std::string& path) {
    const auto samples = read_samples(path);
    const auto context = make_context(pool);
    const auto column = [&](std::size_t first) {
        return hrbfnpr_array{samples.empty() ? nullptr : samples[0].data() + first,
                             static_cast<std::int64_t>(samples.size()), sizeof samples[0], HRBFNPR_SCALAR_FLOAT64, 3};
    };
    auto source = defaults<hrbfnpr_picture_source>(hrbfnpr_picture_source_init);
    source.points = column(0);
    source.normals = column(3);
    auto desc = defaults<hrbfnpr_picture_desc>(hrbfnpr_picture_desc_init);
    desc.sources = &source;
    desc.source_count = 1;
    desc.width = width;
    desc.height = height;
    const double direction[] = {0, 1, -1}, up[] = {0, 0, 1};
    std::copy(direction, direction + 3, desc.direction);
    std::copy(up, up + 3, desc.up);
    const auto picture = make<hrbfnpr_picture>(hrbfnpr_picture_release, [&](auto out) {
        return hrbfnpr_picture_create(context.get(), &desc, nullptr, out, &error);
    });
    const auto drawing = make<hrbfnpr_drawing>(hrbfnpr_drawing_release, [&](auto out) {
        return hrbfnpr_picture_draw(picture.get(), nullptr, nullptr, out, &error);
    });

    std::vector<unsigned char> pixels(std::size_t{4} * width * height);
    auto image = defaults<hrbfnpr_image>(hrbfnpr_image_init);
    image.format = HRBFNPR_FORMAT_RGBA8;
    image.width = width;
    image.height = height;
    image.pixels = pixels.data();
    check(hrbfnpr_picture_rasterize(picture.get(), drawing.get(), nullptr, &image, &error));
    return pixels;
}

void write_picture(const std::string& path, const std::vector<unsigned char>& pixels) {
    std::ofstream file(path, std::ios::binary);
    file << "P7\nWIDTH " << width << "\nHEIGHT " << height << "\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n";
    file.write(reinterpret_cast<const char*>(pixels.data()), static_cast<std::streamsize>(pixels.size()));
    file.close();
    if (!file) throw std::runtime_error("cannot write " + path);
}

// Returns the number of threads of this process, as Linux counts them; 0 on other systems.
std::ptrdiff_t thread_count() {
    std::error_code none;
    const std::filesystem::directory_iterator tasks("/proc/self/task", none);
    return std::distance(begin(tasks), end(tasks));
}

} // namespace

int main(int argc, char** argv) try {
    if (argc < 2 || argc > 3) {
        std::cerr << "usage: jobs PICTURE.pam [SAMPLES.xyzn]\n";
        return 2;
    }
    check(hrbfnpr_error_init(&error, sizeof error));
    Pool pool(pool_threads);
    const auto before = thread_count();
    write_picture(argv[1], draw(pool, argc == 3 ? argv[2] : TORUS));
    const auto after = thread_count();

    const auto tasks = pool.tasks_run();
    std::cout << "tasks: " << tasks[0] << " on the main thread";
    for (std::size_t i = 1; i < tasks.size(); ++i) std::cout << ", " << tasks[i] << " on worker " << i;
    std::cout << "\nthreads: " << before << " before the work, " << after << " after it\n";
    return 0;
} catch (const std::exception& exception) {
    std::cerr << exception.what() << "\n";
    return 1;
}
