// draw_scene NAME FILE [WIDTH HEIGHT [THREADS]]: draws one scene into a PAM file.
// draw_scene --list: the scenes' names.
#include "scenes/scenes.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string_view>

namespace {

bool write_pam(const char* path, const scenes::Picture& picture) {
    std::FILE* file = std::fopen(path, "wb");
    if (file == nullptr) return false;
    std::fprintf(file, "P7\nWIDTH %d\nHEIGHT %d\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n", picture.width,
                 picture.height);
    const bool written = std::fwrite(picture.rgba.data(), 1, picture.rgba.size(), file) == picture.rgba.size();
    return (std::fclose(file) == 0) && written;
}

int draw(int argc, char** argv) {
    const int width = argc > 4 ? std::atoi(argv[3]) : 480;
    const int height = argc > 4 ? std::atoi(argv[4]) : 480;
    scenes::Check check;
    hrbfnpr_context_desc desc;
    hrbfnpr_context_desc_init(&desc, sizeof desc);
    desc.thread_count = argc > 5 ? std::atoi(argv[5]) : 0;
    hrbfnpr_context* handle = nullptr;
    check(hrbfnpr_context_create(&desc, &handle, check.error()));
    const scenes::Context context(handle);
    const scenes::Scene scene = scenes::make(handle, argv[1], width, height);
    if (write_pam(argv[2], scenes::draw(handle, scene))) return 0;
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
        std::fprintf(stderr, "usage: draw_scene NAME FILE.pam [WIDTH HEIGHT [THREADS]] | --list\n");
        return 2;
    }
    try {
        return draw(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "draw_scene: %s\n", error.what());
        return 1;
    }
}
