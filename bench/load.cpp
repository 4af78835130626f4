// SPDX-License-Identifier: MIT
// Frames, fits, orders and drawings under load: on an idle machine and beside busy processes, for each thread backend.
// --rounds=N: default 12; --marks=N: marks of the frames, default 700000; --only=NAME,...: any of frame, fit, order,
// small.
#include "backends.h"
#include "busy.h"
#include "orbit.h"
#include "painter.h"
#include "samples.h"
#include "timing.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

using bench::Backend;

// ---- The work ------------------------------------------------------------------------------

// The data that all backends work on.
struct Stock {
    explicit Stock(std::int64_t marks)
        : context(bench::make_context()), model(bench::fit(context.get(), samples.points, samples.normals)) {
        bench::Generation desc = bench::one_layer(HRBFNPR_LAYER_KIND_STIPPLES, marks / 2);
        desc.add(HRBFNPR_LAYER_KIND_HATCH, marks - marks / 2);
        set = bench::generate(context.get(), model.get(), desc);
    }
    bench::Samples samples = bench::bumpy(4096, 0.15);
    bench::Samples few = bench::bumpy(300, 0.15);
    scenes::Context context;
    scenes::Model model;
    scenes::PointSet set;
};

bench::Style full() { return bench::Style(HRBFNPR_PRESET_FULL); }

constexpr int width = 1280, height = 720;

// One backend; each kind of work returns milliseconds.
class Worker {
public:
    Worker(const Stock& stock, const Backend& backend)
        : stock_(stock), context_(bench::make_context(backend)), orbit_(stock.set.get(), width, height),
          painter_(context_.get(), stock.set.get(), full(), width, height) {}

    // Appends the times of whole frames, and of the image alone.
    void frames(int count, std::vector<double>& whole, std::vector<double>& image) {
        for (int i = 0; i < count; ++i) {
            whole.push_back(1e3 * bench::seconds([&] { painter_.draw(orbit_.at(0.7 * angle_++)); }));
            image.push_back(painter_.image_ms());
        }
    }
    [[nodiscard]] double fit() {
        return 1e3 *
               bench::seconds([&] { (void)bench::fit(context_.get(), stock_.samples.points, stock_.samples.normals); });
    }
    [[nodiscard]] double order() { return generate(stock_.model.get(), 60'000); }
    // A fit, an order and a drawing, each very short.
    [[nodiscard]] double small() {
        return 1e3 * bench::seconds([&] {
                   const scenes::Model model = bench::fit(context_.get(), stock_.few.points, stock_.few.normals);
                   const scenes::PointSet set = bench::generate(context_.get(), model.get(),
                                                                bench::one_layer(HRBFNPR_LAYER_KIND_STIPPLES, 10'000));
                   const bench::Orbit orbit(set.get(), width, height);
                   bench::Painter(context_.get(), set.get(), full(), width, height).draw(orbit.at(0.0));
               });
    }

private:
    [[nodiscard]] double generate(const hrbfnpr_model* model, std::int64_t budget) {
        return 1e3 * bench::seconds([&] {
                   (void)bench::generate(context_.get(), model, bench::one_layer(HRBFNPR_LAYER_KIND_STIPPLES, budget));
               });
    }

    const Stock& stock_;
    scenes::Context context_;
    bench::Orbit orbit_;
    bench::Painter painter_;
    int angle_ = 0;
};

// ---- The machine ---------------------------------------------------------------------------

struct Condition {
    const char* name;
    const char* words;
    void (*start)(bench::Busy& busy);
};

constexpr Condition conditions[] = {
    {"idle", "idle", [](bench::Busy&) {}},
    {"busy", "beside one busy process", [](bench::Busy& busy) { busy.add(); }},
    {"pinned", "beside one on processor 0", [](bench::Busy& busy) { busy.add(0); }},
    {"background", "beside two of lowest priority",
     [](bench::Busy& busy) {
         busy.add(bench::Busy::anywhere, 19);
         busy.add(bench::Busy::anywhere, 19);
     }},
};

// ---- Measurements --------------------------------------------------------------------------

double percentile(std::vector<double> values, double share) {
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

// Milliseconds by work, condition and backend.
class Table {
public:
    std::vector<double>& at(const std::string& work, const std::string& condition, const std::string& backend) {
        return cells_[work + "/" + condition + "/" + backend];
    }
    [[nodiscard]] double value(const std::string& work, const std::string& condition, const std::string& backend,
                               double share = 0.5) const {
        const auto found = cells_.find(work + "/" + condition + "/" + backend);
        return found == cells_.end() ? 0.0 : percentile(found->second, share);
    }
    [[nodiscard]] bool has(const std::string& work) const {
        return cells_.lower_bound(work + "/") != cells_.lower_bound(work + "0"); // '0' is the character after '/'
    }

private:
    std::map<std::string, std::vector<double>> cells_;
};

struct Options {
    int rounds = 12;
    std::int64_t marks = 700'000;
    std::string only;
    [[nodiscard]] bool wants(const char* work) const { return only.empty() || only.find(work) != std::string::npos; }
};

// Runs a batch of each kind of work; the first of a batch only warms up. The sleep lets the spinning threads of other
// backends stop first.
void measure(const Options& options, const std::string& condition, const Backend& backend, Worker& worker,
             Table& table) {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    const auto cell = [&](const char* work) -> std::vector<double>& { return table.at(work, condition, backend.name); };
    if (options.wants("frame")) {
        std::vector<double> whole, image;
        worker.frames(2, whole, image);
        worker.frames(20, cell("frame"), cell("drawing"));
    }
    if (options.wants("fit")) {
        (void)worker.fit();
        for (int i = 0; i < 3; ++i) cell("fit").push_back(worker.fit());
    }
    if (options.wants("order")) {
        (void)worker.order();
        for (int i = 0; i < 2; ++i) cell("order").push_back(worker.order());
    }
    if (options.wants("small")) {
        (void)worker.small();
        for (int i = 0; i < 3; ++i) cell("small").push_back(worker.small());
    }
}

void print(const Table& table, const std::vector<Backend>& backends) {
    for (const char* work : {"frame", "drawing", "fit", "order", "small"}) {
        if (!table.has(work)) continue;
        std::printf("\n%-8s milliseconds: median (95th percentile)\n%-30s", work, "");
        for (const Backend& backend : backends) std::printf(" %18s", backend.name.c_str());
        std::printf("\n");
        for (const Condition& condition : conditions) {
            std::printf("%-30s", condition.words);
            for (const Backend& backend : backends)
                std::printf(" %9.2f (%6.1f)", table.value(work, condition.name, backend.name),
                            table.value(work, condition.name, backend.name, 0.95));
            std::printf("\n");
        }
    }
    std::printf("\n");
}

// Returns the worse ratio of two loads: a busy process that stays on one processor, and one that does not.
double under_load(const Table& table, const char* work, const std::string& backend, double share) {
    return std::max(table.value(work, "busy", backend, share), table.value(work, "pinned", backend, share)) /
           table.value(work, "idle", backend, share);
}

void report(const Table& table, const std::vector<Backend>& backends) {
    for (const Backend& backend : backends) {
        const std::string suffix = backend.name == "pool" ? "" : "." + backend.name;
        const auto pair = [&](const std::string& name, double value) {
            bench::report(("load." + name + suffix).c_str(), value);
        };
        if (table.has("frame")) {
            pair("frame_p95_ratio", under_load(table, "frame", backend.name, 0.95));
            pair("frame_ratio", under_load(table, "frame", backend.name, 0.5));
        }
        for (const char* work : {"drawing", "fit", "order", "small"})
            if (table.has(work)) pair(std::string(work) + "_ratio", under_load(table, work, backend.name, 0.5));
        if (table.has("small"))
            pair("small_background_vs_serial",
                 table.value("small", "background", backend.name) / table.value("small", "background", "serial"));
        if (backend.name == "OpenMP") continue;
        for (const char* work : {"frame", "drawing", "fit", "order", "small"})
            if (table.has(work))
                pair(std::string(work) + "_idle_vs_openmp",
                     table.value(work, "idle", backend.name) / table.value(work, "idle", "OpenMP"));
    }
}

void run(const Options& options) {
    const Stock stock(options.marks);
    const std::vector<Backend> backends = bench::backends();
    std::vector<std::unique_ptr<Worker>> workers;
    for (const Backend& backend : backends) workers.push_back(std::make_unique<Worker>(stock, backend));
    std::printf("%u processors; %lld marks, `full`, %d x %d; fits of %lld samples; orders of 60 000; small: a fit of "
                "%lld, 10 000 marks, a frame\n",
                std::thread::hardware_concurrency(), static_cast<long long>(options.marks), width, height,
                static_cast<long long>(stock.samples.count()), static_cast<long long>(stock.few.count()));
    std::fflush(stdout);
    Table table;
    for (int round = 0; round < options.rounds; ++round)
        for (const Condition& condition : conditions) {
            bench::Busy busy;
            condition.start(busy);
            for (std::size_t i = 0; i < backends.size(); ++i)
                measure(options, condition.name, backends[i], *workers[i], table);
            std::fprintf(stderr, "round %d of %d: %s\n", round + 1, options.rounds, condition.words);
        }
    print(table, backends);
    report(table, backends);
}

} // namespace

int main(int argc, char** argv) try {
    Options options;
    const std::string rounds = bench::option(argc, argv, "--rounds=");
    const std::string marks = bench::option(argc, argv, "--marks=");
    if (!rounds.empty()) options.rounds = std::max(std::atoi(rounds.c_str()), 1);
    if (!marks.empty()) options.marks = std::max(std::atoll(marks.c_str()), 1000LL);
    options.only = bench::option(argc, argv, "--only=");
    run(options);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
