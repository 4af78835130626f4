// SPDX-License-Identifier: MIT
// Runs a fuzzer's inputs without libFuzzer, in any build:
//
//   fuzz_model FILE_OR_FOLDER...     runs each file, once, in the order of their names
//   fuzz_model --seconds N [--seed S] [--keep FILE] FILE_OR_FOLDER...
//                                    also runs random changes of them and random bytes for N seconds
//
// The status is 1 if a path is missing or no input was executed. A broken contract aborts, and the last printed line
// names the input. A generated input is written to FILE, as is one that takes more than 20 seconds of processor time.
#include "fuzz.h"
#include "random.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <sys/time.h>
#include <unistd.h>

// The fuzzers of files define their own mutator, which calls the driver's.
extern "C" __attribute__((weak)) std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                                                     std::size_t max_size, unsigned seed);
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

namespace fs = std::filesystem;
using fuzz::Bytes;

struct Options {
    double seconds = 0.0;
    std::uint64_t seed = 1;
    std::string keep = "crash";
    std::vector<fs::path> paths;
};

// The input that is being run, for the signal handler.
struct Current {
    const Bytes* bytes = nullptr;
    std::string keep;
};
Current current;

fuzz::Random* changes = nullptr; // the source of random numbers for LLVMFuzzerMutate

void keep_input(int signal) {
    const int file = open(current.keep.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (file >= 0 && current.bytes != nullptr)
        static_cast<void>(!write(file, current.bytes->data(), current.bytes->size()));
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

// Dot files such as .gitattributes are not inputs.
void collect(const fs::path& path, std::vector<fs::path>& inputs) {
    if (!fs::is_directory(path)) {
        inputs.push_back(path);
        return;
    }
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path))
        if (entry.is_regular_file() && entry.path().filename().string().front() != '.') inputs.push_back(entry.path());
}

std::vector<Bytes> run_files(const std::string& name, std::vector<fs::path> inputs) {
    std::vector<Bytes> read;
    std::sort(inputs.begin(), inputs.end());
    for (const fs::path& input : inputs) {
        std::ifstream stream(input, std::ios::binary);
        if (!stream) throw std::runtime_error("cannot read " + input.string());
        read.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
        std::printf("%s: %s\n", name.c_str(), input.c_str());
        std::fflush(stdout);
        LLVMFuzzerTestOneInput(read.back().data(), read.back().size());
    }
    return read;
}

// Returns some bytes of zeros, ones and noise.
Bytes random_bytes(fuzz::Random& random) {
    Bytes bytes(random.below(400));
    const std::size_t zeros = random.below(4);
    for (std::uint8_t& byte : bytes)
        byte = random.below(4) < zeros ? std::uint8_t{0} : static_cast<std::uint8_t>(random.next());
    return bytes;
}

Bytes next_input(const std::vector<Bytes>& known, fuzz::Random& random) {
    constexpr std::size_t most = 16384;
    if (known.empty() || (LLVMFuzzerCustomMutator == nullptr && random.below(4) == 0)) return random_bytes(random);
    Bytes bytes = known[random.below(known.size())];
    std::size_t size = bytes.size();
    bytes.resize(std::max(most, size));
    for (std::size_t edits = 1 + random.below(4); edits > 0; --edits)
        size = LLVMFuzzerCustomMutator != nullptr
                   ? LLVMFuzzerCustomMutator(bytes.data(), size, bytes.size(), static_cast<unsigned>(random.next()))
                   : LLVMFuzzerMutate(bytes.data(), size, bytes.size());
    bytes.resize(size);
    return bytes;
}

void set_timer(std::time_t seconds) {
    const itimerval timer{{0, 0}, {seconds, 0}};
    setitimer(ITIMER_VIRTUAL, &timer, nullptr);
}

std::size_t run_random(const Options& options, const std::vector<Bytes>& known) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(options.seconds);
    fuzz::Random random(options.seed);
    changes = &random;
    current.keep = options.keep;
    for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTERM, SIGVTALRM})
        std::signal(signal, keep_input);
    std::size_t executed = 0;
    for (; Clock::now() < end; ++executed) {
        const Bytes bytes = next_input(known, random);
        current.bytes = &bytes;
        set_timer(20);
        LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
        current.bytes = nullptr;
        set_timer(0);
    }
    return executed;
}

Options options_of(std::span<char*> arguments) {
    Options options;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string name = arguments[i];
        const bool has_value = i + 1 < arguments.size();
        if (name == "--seconds" && has_value)
            options.seconds = std::stod(arguments[++i]);
        else if (name == "--seed" && has_value)
            options.seed = std::stoull(arguments[++i]);
        else if (name == "--keep" && has_value)
            options.keep = arguments[++i];
        else
            options.paths.emplace_back(name);
    }
    return options;
}

int run(const std::string& name, const Options& options) {
    std::vector<fs::path> inputs;
    for (const fs::path& path : options.paths) {
        if (!fs::exists(path)) throw std::runtime_error("there is no " + path.string());
        collect(path, inputs);
    }
    const std::vector<Bytes> known = run_files(name, inputs);
    const std::size_t executed = known.size() + run_random(options, known);
    std::printf("%s: %zu inputs executed\n", name.c_str(), executed);
    return executed == 0 ? 1 : 0;
}

} // namespace

// Changes, inserts or removes a byte, or removes or doubles a few bytes.
std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size) {
    fuzz::Random& random = *changes;
    const std::size_t at = random.below(size + 1);
    const std::size_t piece = std::min({random.below(9), size - at, max_size - size});
    switch (random.below(5)) {
    case 0:
        if (size == max_size) return size;
        std::memmove(data + at + 1, data + at, size - at);
        data[at] = static_cast<std::uint8_t>(random.next());
        return size + 1;
    case 1: std::memmove(data + at, data + at + piece, size - at - piece); return size - piece;
    case 2: std::memmove(data + at + piece, data + at, size - at); return size + piece;
    default:
        if (at < size) data[at] = static_cast<std::uint8_t>(random.below(3) == 0 ? random.below(8) : random.next());
        return size;
    }
}

int main(int argc, char** argv) {
    const std::string name = fs::path(argv[0]).stem().string();
    try {
        return run(name, options_of(std::span(argv, static_cast<std::size_t>(argc)).subspan(1)));
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "%s: %s\n", name.c_str(), failure.what());
        return 1;
    }
}
