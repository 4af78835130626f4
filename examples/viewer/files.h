// SPDX-License-Identifier: MIT
// Files and texts, and the callbacks by which the library reads and writes them.
#pragma once

#include "handles.h"

#include <cstdio>

namespace viewer {

// A file that gets its name only when it is complete.
class Target {
public:
    explicit Target(const std::string& path);
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;
    ~Target();
    std::FILE* file() const { return file_; }
    void finish();

private:
    std::string path_, part_;
    std::FILE* file_;
};

std::string read_file(const std::string& path);

// These are hrbfnpr_write_fn callbacks for a std::FILE and for a std::string.
std::int32_t write_to_file(void* file, const void* data, std::uint64_t size);
std::int32_t write_to_text(void* text, const void* data, std::uint64_t size);

struct TextSource {
    const std::string& text;
    std::size_t done;
};
// A hrbfnpr_read_fn callback for a TextSource.
std::int64_t read_from_text(void* source, void* data, std::uint64_t size);

} // namespace viewer
