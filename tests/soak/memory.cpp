// SPDX-License-Identifier: MIT
#include "memory.h"

#include <cstdio>
#include <cstdlib>
#include <string>

#if defined(__GLIBC__)
#include <malloc.h>
#include <unistd.h>
#endif

namespace soak {
#if defined(__GLIBC__)
namespace {

// Returns the last size after these words in malloc's report, where the sums of all arenas come last.
std::int64_t last_size(const std::string& report, const std::string& words) {
    const std::size_t at = report.rfind(words);
    if (at == std::string::npos) return 0;
    const std::string size = " size=\"";
    return std::strtoll(report.c_str() + report.find(size, at) + size.size(), nullptr, 10);
}

std::int64_t used_bytes() {
    char* text = nullptr;
    std::size_t length = 0;
    std::FILE* const file = open_memstream(&text, &length);
    if (file == nullptr) return 0;
    const bool is_told = malloc_info(0, file) == 0;
    std::fclose(file);
    const std::string report(is_told ? text : "");
    std::free(text);
    return last_size(report, "<system type=\"current\"") + last_size(report, "<total type=\"mmap\"") -
           last_size(report, "<total type=\"fast\"") - last_size(report, "<total type=\"rest\"");
}

std::int64_t resident_bytes() {
    std::FILE* const file = std::fopen("/proc/self/statm", "r");
    if (file == nullptr) return 0;
    long long whole = 0;
    long long pages = 0;
    const int read = std::fscanf(file, "%lld %lld", &whole, &pages);
    std::fclose(file);
    return read == 2 ? pages * sysconf(_SC_PAGESIZE) : 0;
}

} // namespace

Memory measure_memory() {
    malloc_trim(0);
    return {used_bytes(), resident_bytes()};
}
#else
Memory measure_memory() { return {}; }
#endif

} // namespace soak
