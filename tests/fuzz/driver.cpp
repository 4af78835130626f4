// SPDX-License-Identifier: MIT
// Runs a fuzzer's inputs without libFuzzer:
//
//   fuzz_model FILE_OR_FOLDER...     runs each file, once, in the order of their names
//
// The status is 1 if a path is missing or no input was executed.  A broken contract aborts, and the
// last line that was printed names the input.
#include "fuzz.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace {

namespace fs = std::filesystem;

// Dot files are not inputs: .gitattributes.
void collect(const fs::path& path, std::vector<fs::path>& inputs) {
    if (!fs::is_directory(path)) {
        inputs.push_back(path);
        return;
    }
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path))
        if (entry.is_regular_file() && entry.path().filename().string().front() != '.') inputs.push_back(entry.path());
}

int run(const std::string& name, std::span<char*> paths) {
    std::vector<fs::path> inputs;
    for (const char* path : paths) {
        if (!fs::exists(path)) {
            std::fprintf(stderr, "%s: there is no %s\n", name.c_str(), path);
            return 1;
        }
        collect(path, inputs);
    }
    std::sort(inputs.begin(), inputs.end());
    for (const fs::path& input : inputs) {
        std::ifstream stream(input, std::ios::binary);
        if (!stream) {
            std::fprintf(stderr, "%s: cannot read %s\n", name.c_str(), input.c_str());
            return 1;
        }
        const fuzz::Bytes bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
        std::printf("%s: %s\n", name.c_str(), input.c_str());
        std::fflush(stdout);
        LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    }
    std::printf("%s: %zu inputs executed\n", name.c_str(), inputs.size());
    return inputs.empty() ? 1 : 0;
}

} // namespace

int main(int argc, char** argv) {
    const std::string name = fs::path(argv[0]).stem().string();
    try {
        return run(name, std::span(argv, static_cast<std::size_t>(argc)).subspan(1));
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "%s: %s\n", name.c_str(), failure.what());
        return 1;
    }
}
