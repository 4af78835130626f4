// SPDX-License-Identifier: MIT
#include "files.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <sstream>

namespace viewer {

Target::Target(const std::string& path) : path_(path), part_(path + ".part"), file_(std::fopen(part_.c_str(), "wb")) {
    if (file_ == nullptr) throw Failure(path + ": cannot be written; does its folder exist?");
}

Target::~Target() {
    if (file_ == nullptr) return;
    std::fclose(file_);
    std::remove(part_.c_str());
}

void Target::finish() {
    const bool whole = std::fclose(file_) == 0;
    file_ = nullptr;
    if (whole && std::rename(part_.c_str(), path_.c_str()) == 0) return;
    std::remove(part_.c_str());
    throw Failure(path_ + ": cannot be written; is the disk full?");
}

std::string read_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream data;
    if (!file || !(data << file.rdbuf())) throw Failure(path + ": cannot be read, or is empty; check the name");
    return data.str();
}

std::int32_t write_to_file(void* file, const void* data, std::uint64_t size) {
    return std::fwrite(data, 1, size, static_cast<std::FILE*>(file)) == size ? 0 : 1;
}

std::int32_t write_to_text(void* text, const void* data, std::uint64_t size) {
    static_cast<std::string*>(text)->append(static_cast<const char*>(data), size);
    return 0;
}

std::int64_t read_from_text(void* user, void* data, std::uint64_t size) {
    auto& source = *static_cast<TextSource*>(user);
    const std::size_t count = std::min<std::size_t>(size, source.text.size() - source.done);
    std::memcpy(data, source.text.data() + source.done, count);
    source.done += count;
    return static_cast<std::int64_t>(count);
}

} // namespace viewer
