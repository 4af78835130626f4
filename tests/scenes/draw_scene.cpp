// SPDX-License-Identifier: MIT
// draw_scene NAME FILE [WIDTH HEIGHT [THREADS [BACKEND [baseline]]]]: draws one scene into a PAM file.
// BACKEND: auto, pool, openmp, run_tasks (a runner of this program) or serial; status 77 if the build does not have it.
// draw_scene --list: prints the names of the scenes.
#include "scenes/scenes.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iterator>
#include <string_view>
#include <thread>

namespace {

bool write_pam(const char* path, const scenes::Picture& picture) {
    std::FILE* file = std::fopen(path, "wb");
    if (file == nullptr) return false;
    std::fprintf(file, "P7\nWIDTH %d\nHEIGHT %d\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n", picture.width,
                 picture.height);
    const bool written = std::fwrite(picture.rgba.data(), 1, picture.rgba.size(), file) == picture.rgba.size();
    return (std::fclose(file) == 0) && written;
}

// The order is that of the HRBFNPR_THREAD_BACKEND_ constants.
constexpr std::string_view backends[] = {"auto", "pool", "openmp", "run_tasks", "serial"};

// A host's runner: two threads, which start from opposite ends.
void run_tasks(void* /*user*/, hrbfnpr_task_fn task, void* task_context, std::int64_t count) {
    std::thread upper([=] {
        for (std::int64_t i = count; i-- > count / 2;) task(task_context, i);
    });
    for (std::int64_t i = 0; i < count / 2; ++i) task(task_context, i);
    upper.join();
}

scenes::Context make_context(int threads, std::string_view backend, bool baseline) {
    scenes::Check check;
    hrbfnpr_context_desc desc;
    hrbfnpr_context_desc_init(&desc, sizeof desc);
    desc.thread_count = threads;
    if (baseline) desc.highest_instruction_set = HRBFNPR_INSTRUCTION_SET_BASELINE;
    desc.thread_backend =
        static_cast<std::uint32_t>(std::find(std::begin(backends), std::end(backends), backend) - std::begin(backends));
    if (desc.thread_backend == HRBFNPR_THREAD_BACKEND_RUN_TASKS) desc.run_tasks = run_tasks;
    hrbfnpr_context* handle = nullptr;
    check(hrbfnpr_context_create(&desc, &handle, check.error()));
    return scenes::Context(handle);
}

bool is_built_in(std::string_view backend) {
    char info[1024] = {};
    hrbfnpr_build_info(info, sizeof info, nullptr);
    return backend != "openmp" || std::string_view(info).find("OPENMP") != std::string_view::npos;
}

int draw(int argc, char** argv) {
    const int width = argc > 4 ? std::atoi(argv[3]) : 480;
    const int height = argc > 4 ? std::atoi(argv[4]) : 480;
    const std::string_view backend = argc > 6 ? argv[6] : "auto";
    if (!is_built_in(backend)) return 77;
    const bool baseline = argc > 7 && std::string_view(argv[7]) == "baseline";
    const scenes::Context context = make_context(argc > 5 ? std::atoi(argv[5]) : 0, backend, baseline);
    const scenes::Scene scene = scenes::make(context.get(), argv[1], width, height);
    if (write_pam(argv[2], scenes::draw(context.get(), scene))) return 0;
    std::fprintf(stderr, "draw_scene: cannot write %s\n", argv[2]);
    return 1;
}

} // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::string_view(argv[1]) == "--list") {
        for (const std::string_view name : scenes::names())
            std::printf("%.*s\n", static_cast<int>(name.size()), name.data());
        return 0;
    }
    if (argc < 3) {
        std::fprintf(stderr, "usage: draw_scene NAME FILE.pam [WIDTH HEIGHT [THREADS [BACKEND]]] | --list\n");
        return 2;
    }
    try {
        return draw(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "draw_scene: %s\n", error.what());
        return 1;
    }
}
