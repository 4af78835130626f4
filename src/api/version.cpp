// SPDX-License-Identifier: MIT
#include "api/barrier.h"
#include "base/instruction_set.h"
#include "base/parallel_openmp.h"
#include "geometry/vec.h"

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <string>

#define HRBFNPR_TEXT_OF(number) #number
#define HRBFNPR_TEXT(macro) HRBFNPR_TEXT_OF(macro)

namespace {

using VersionText = std::array<char, sizeof "99.99.99">;

// "major.minor.patch" of the header's constants, which are not macros.
constexpr VersionText make_version_text() {
    VersionText text{};
    std::size_t size = 0;
    for (const int part : {HRBFNPR_VERSION_MAJOR, HRBFNPR_VERSION_MINOR, HRBFNPR_VERSION_PATCH}) {
        if (size > 0) text[size++] = '.';
        if (part >= 10) text[size++] = static_cast<char>('0' + part / 10);
        text[size++] = static_cast<char>('0' + part % 10);
    }
    return text;
}

static_assert(HRBFNPR_VERSION_MAJOR < 100 && HRBFNPR_VERSION_MINOR < 100 && HRBFNPR_VERSION_PATCH < 100);
constexpr VersionText version_text = make_version_text();

constexpr const char* compiler =
#if defined(__clang__)
    "Clang " HRBFNPR_TEXT(__clang_major__) "." HRBFNPR_TEXT(__clang_minor__) "." HRBFNPR_TEXT(__clang_patchlevel__);
#elif defined(__GNUC__)
    "GCC " HRBFNPR_TEXT(__GNUC__) "." HRBFNPR_TEXT(__GNUC_MINOR__) "." HRBFNPR_TEXT(__GNUC_PATCHLEVEL__);
#else
    "unknown";
#endif

constexpr const char* glm_version =
    HRBFNPR_TEXT(GLM_VERSION_MAJOR) "." HRBFNPR_TEXT(GLM_VERSION_MINOR) "." HRBFNPR_TEXT(GLM_VERSION_PATCH);

constexpr const char* highway_version = HRBFNPR_TEXT(HWY_MAJOR) "." HRBFNPR_TEXT(HWY_MINOR) "." HRBFNPR_TEXT(HWY_PATCH);

// The values come from the library, so they need no escapes in JSON.
std::string build_info() {
    std::string json = "{\"version\": \"";
    json += version_text.data();
    json += "\", \"abi\": " + std::to_string(HRBFNPR_ABI_VERSION) + ", \"compiler\": \"";
    json += compiler;
    json += R"(", "instruction_sets": [)";
    json += hrbfnpr::base::compiled_instruction_sets();
    json += R"(], "thread_backends": ["POOL")";
    if (hrbfnpr::base::openmp_is_built_in()) json += R"(, "OPENMP")";
    json += R"(], "dependencies": {"Eigen": ")" HRBFNPR_EIGEN_VERSION R"(", "GLM": ")";
    json += glm_version;
    json += R"(", "Highway": ")";
    json += highway_version;
    json += "\"}}";
    return json;
}

} // namespace

extern "C" {

uint32_t hrbfnpr_version(void) {
    return HRBFNPR_VERSION_MAJOR * 10000 + HRBFNPR_VERSION_MINOR * 100 + HRBFNPR_VERSION_PATCH;
}

uint32_t hrbfnpr_abi_version(void) { return HRBFNPR_ABI_VERSION; }

const char* hrbfnpr_version_string(void) { return version_text.data(); }

hrbfnpr_status hrbfnpr_build_info(char* destination, int64_t capacity, int64_t* needed) {
    using namespace hrbfnpr;
    return api::guarded(nullptr, [&] {
        if (capacity < 0) fail(Status::invalid_argument, "capacity is negative");
        if (capacity > 0) api::require_pointer(destination, "destination");
        const std::string json = build_info();
        const auto size = static_cast<std::int64_t>(json.size()) + 1;
        if (needed != nullptr) *needed = size;
        if (capacity < size) fail(Status::buffer_too_small, "capacity is below *needed");
        std::memcpy(destination, json.c_str(), static_cast<std::size_t>(size));
    });
}

} // extern "C"
