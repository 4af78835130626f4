// SPDX-License-Identifier: MIT
// Makes random valid and invalid calls on several threads for a while: the calls of the fuzzers, with changed inputs.
//
//   soak --seconds N [--threads N] [--seed N] CORPUS
//
// All threads share models, marks, line sets and drawings. Each call has a context of its own with two threads. At
// first each input is run unchanged and all shared objects are made: on a slow machine chance would make some of them
// late, which looks like growth. After every tenth of the time all threads stop, and the memory of the process is
// measured. The status is 1 if that grows much after the first three tenths, or if no call was made.
#include "fuzz/fuzz.h"
#include "fuzz/random.h"
#include "fuzz/scenes.h"
#include "memory.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>

extern "C" {
int soak_model(const std::uint8_t* data, std::size_t size);
int soak_point_set(const std::uint8_t* data, std::size_t size);
int soak_fit(const std::uint8_t* data, std::size_t size);
int soak_generate(const std::uint8_t* data, std::size_t size);
int soak_frame(const std::uint8_t* data, std::size_t size);
int soak_page(const std::uint8_t* data, std::size_t size);
int soak_mesh(const std::uint8_t* data, std::size_t size);
}

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using fuzz::Bytes;

struct Kind {
    const char* name;
    int (*run)(const std::uint8_t* data, std::size_t size);
    std::vector<Bytes> inputs;
    std::atomic<std::int64_t> calls = 0;
};

struct Options {
    double seconds = 20.0;
    std::int64_t threads = 2;
    std::uint64_t seed = 1;
    fs::path corpus;
};

constexpr int rounds = 10;
constexpr int warm_up = 3; // rounds in which caches are filled
// Largest growth, in bytes given out by malloc. The buffers that shared objects keep for the next call grow by jumps of
// 0.5 to 7 MiB, which become rarer with time. This limit hides a leak of less than 1 kB per call in two minutes, and of
// 0.3 kB in half an hour.
constexpr std::int64_t room_for_growth = 24LL << 20LL;
constexpr std::int64_t room_for_pieces = 256LL << 20LL; // resident memory, which allocation fragments

std::array<Kind, 7> kinds{{{"model", soak_model, {}},
                           {"point_set", soak_point_set, {}},
                           {"fit", soak_fit, {}},
                           {"generate", soak_generate, {}},
                           {"frame", soak_frame, {}},
                           {"page", soak_page, {}},
                           {"mesh", soak_mesh, {}}}};

std::vector<Bytes> read_folder(const fs::path& folder) {
    std::vector<fs::path> paths;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().filename().string().front() != '.') paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end()); // makes the order the same on every machine
    std::vector<Bytes> inputs;
    for (const fs::path& path : paths) {
        std::ifstream stream(path, std::ios::binary);
        inputs.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    }
    if (inputs.empty()) throw std::runtime_error("there is no input in " + folder.string());
    return inputs;
}

// Returns a random input, unchanged or with up to eight bytes changed.
Bytes next_input(const std::vector<Bytes>& inputs, fuzz::Random& random) {
    Bytes bytes = inputs[random.below(inputs.size())];
    for (std::size_t edits = random.below(9); edits > 0 && !bytes.empty(); --edits)
        bytes[random.below(bytes.size())] =
            static_cast<std::uint8_t>(random.below(2) == 0 ? random.below(8) : random.next());
    return bytes;
}

void work(fuzz::Random& random, Clock::time_point end) {
    while (Clock::now() < end) {
        Kind& kind = kinds[random.below(kinds.size())];
        const Bytes bytes = next_input(kind.inputs, random);
        kind.run(bytes.data(), bytes.size());
        ++kind.calls;
    }
}

void run_round(std::vector<fuzz::Random>& randoms, double seconds) {
    const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    std::vector<std::thread> threads;
    for (fuzz::Random& random : randoms) threads.emplace_back(work, std::ref(random), end);
    for (std::thread& thread : threads) thread.join();
}

void make_what_is_shared() {
    for (std::size_t i = 0; i < fuzz::model_count; ++i) fuzz::scene_model(i);
    for (std::size_t i = 0; i < fuzz::set_count; ++i) fuzz::scene_set(i);
    for (std::size_t i = 0; i < fuzz::line_set_count; ++i) fuzz::scene_lines(i);
    for (const Kind& kind : kinds)
        for (const Bytes& bytes : kind.inputs) kind.run(bytes.data(), bytes.size());
}

// Returns whether memory stayed flat.
bool run(const Options& options) {
    for (Kind& kind : kinds) kind.inputs = read_folder(options.corpus / kind.name);
    fuzz::context_threads = 2;
    make_what_is_shared();
    std::vector<fuzz::Random> randoms;
    for (std::int64_t i = 0; i < options.threads; ++i)
        randoms.emplace_back(options.seed + 1000 * static_cast<std::uint64_t>(i));
    soak::Memory warm;
    soak::Memory last;
    for (int round = 0; round < rounds; ++round) {
        run_round(randoms, options.seconds / rounds);
        last = soak::measure_memory();
        if (round < warm_up) {
            warm.used = std::max(warm.used, last.used);
            warm.resident = std::max(warm.resident, last.resident);
        }
        std::printf("round %d of %d: %.2f MiB given out, %.2f MiB resident\n", round + 1, rounds,
                    static_cast<double>(last.used) / 1048576.0, static_cast<double>(last.resident) / 1048576.0);
        std::fflush(stdout);
    }
    for (const Kind& kind : kinds) std::printf("%s: %lld\n", kind.name, static_cast<long long>(kind.calls));
    const bool is_flat = last.used <= warm.used + room_for_growth && last.resident <= warm.resident + room_for_pieces;
    std::printf("memory %s\n", is_flat ? "stayed flat" : "GREW");
    return is_flat && std::all_of(kinds.begin(), kinds.end(), [](const Kind& kind) { return kind.calls > 0; });
}

Options options_of(std::span<char*> arguments) {
    Options options;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string name = arguments[i];
        const bool has_value = i + 1 < arguments.size();
        if (name == "--seconds" && has_value)
            options.seconds = std::stod(arguments[++i]);
        else if (name == "--threads" && has_value)
            options.threads = std::clamp<std::int64_t>(std::stoll(arguments[++i]), 1, 256);
        else if (name == "--seed" && has_value)
            options.seed = std::stoull(arguments[++i]);
        else if (options.corpus.empty() && name.substr(0, 2) != "--")
            options.corpus = name;
        else
            throw std::runtime_error("usage: soak --seconds N [--threads N] [--seed N] CORPUS, not " + name);
    }
    return options;
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(options_of(std::span(argv, static_cast<std::size_t>(argc)).subspan(1))) ? 0 : 1;
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "soak: %s\n", failure.what());
        return 1;
    }
}
