// SPDX-License-Identifier: MIT
// How long calls continue after they are cancelled from another thread, and how long their callbacks are silent.
//
//   bench_cancel [--samples=100000] [--marks=1000000] [--dense=2048] [--faces=1000000] [--trials=20] [--threads=0]
//                [--named=TEXT]
//
// For each call that takes an operation, it prints the time, the longest silence between two calls of its callback (the
// call's begin and end count, too), and the worst and the median time from a cancel at random moments to its return.
// On a busy machine a thread may wait for a processor meanwhile: --threads=1 and the processor time show whether it
// did. Rasterizing takes no operation, so a host must wait for its whole time.
#include "cancel_calls.h"
#include "timing.h"

#include <atomic>
#include <cstdio>
#include <ctime>
#include <exception>
#include <random>
#include <stdexcept>
#include <thread>

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// Reads a processor clock: CLOCK_PROCESS_CPUTIME_ID for all threads, or CLOCK_THREAD_CPUTIME_ID for this one.
double processor_seconds(clockid_t clock) {
    std::timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

hrbfnpr::test::Operation make_operation(hrbfnpr_context* context) {
    scenes::Check check;
    hrbfnpr_operation* operation = nullptr;
    check(hrbfnpr_operation_create(context, &operation, check.error()));
    return hrbfnpr::test::Operation(operation);
}

// The longest silence of a callback.
struct Silence {
    Clock::time_point last = Clock::now();
    double last_processor = 0.0;
    double longest = 0.0;
    double longest_processor = 0.0; // processor time of the calling thread
    double at = 0.0;                // the progress at the end of the longest silence

    static std::int32_t heard(void* user, double progress) {
        auto& self = *static_cast<Silence*>(user);
        self.end(progress);
        return 0;
    }
    void end(double progress) {
        if (const double length = since(last); length > longest) {
            longest = length;
            at = progress;
        }
        const double now = processor_seconds(CLOCK_THREAD_CPUTIME_ID);
        longest_processor = std::max(longest_processor, now - last_processor);
        begin();
    }
    void begin() {
        last_processor = processor_seconds(CLOCK_THREAD_CPUTIME_ID);
        last = Clock::now();
    }
};

struct Undisturbed {
    double seconds;
    Silence silence;
};

Undisturbed run_undisturbed(hrbfnpr_context* context, const bench::LongCall& call) {
    if (call.prepare) call.prepare();
    scenes::Check check;
    const auto operation = make_operation(context);
    Silence silence;
    check(hrbfnpr_operation_set_callback(operation.get(), Silence::heard, &silence, check.error()));
    const auto begin = Clock::now();
    silence.begin();
    check(call.call(operation.get(), check.error()));
    silence.end(1.0);
    return {since(begin), silence};
}

struct Latency {
    double wall = 0.0;
    double processor = 0.0; // summed over all threads
};

// Cancels the call after a while; returns false if the call had ended by then.
bool cancel_after(hrbfnpr_context* context, const bench::LongCall& call, double wait, Latency& latency) {
    if (call.prepare) call.prepare();
    scenes::Check check;
    const auto operation = make_operation(context);
    std::atomic<bool> begun{false};
    hrbfnpr_status status = HRBFNPR_STATUS_OK;
    Clock::time_point end;
    double processor_end = 0.0;
    std::thread caller([&] {
        begun = true;
        status = call.call(operation.get(), check.error());
        end = Clock::now();
        processor_end = processor_seconds(CLOCK_PROCESS_CPUTIME_ID);
    });
    while (!begun) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::duration<double>(wait));
    const double processor_begin = processor_seconds(CLOCK_PROCESS_CPUTIME_ID);
    const auto cancelled = Clock::now();
    hrbfnpr_operation_cancel(operation.get());
    caller.join();
    if (status == HRBFNPR_STATUS_OK) return false;
    if (status != HRBFNPR_STATUS_CANCELLED) check(status);
    latency = {std::chrono::duration<double>(end - cancelled).count(), processor_end - processor_begin};
    return true;
}

void measure(hrbfnpr_context* context, const bench::LongCall& call, int trials) {
    const Undisturbed whole = run_undisturbed(context, call);
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> moment(0.0, 0.98 * whole.seconds);
    std::vector<double> walls, processors;
    for (int trial = 0; trial < trials; ++trial) {
        Latency latency;
        if (!cancel_after(context, call, moment(engine), latency)) continue;
        walls.push_back(1e3 * latency.wall);
        processors.push_back(1e3 * latency.processor);
    }
    if (walls.empty()) walls = processors = {0.0};
    const double worst = *std::max_element(walls.begin(), walls.end());
    const double worst_processor = *std::max_element(processors.begin(), processors.end());
    std::printf("%-28s %9.3f s  silence %7.1f ms (at %.3f, processor time %6.1f ms)  cancel: worst %7.1f ms, median "
                "%6.1f ms, worst processor time %7.1f ms, %zu of %d\n",
                call.name.c_str(), whole.seconds, 1e3 * whole.silence.longest, whole.silence.at,
                1e3 * whole.silence.longest_processor, worst, bench::median(walls), worst_processor, walls.size(),
                trials);
    bench::report(("cancel." + call.name + ".worst_ms").c_str(), worst);
    bench::report(("cancel." + call.name + ".median_ms").c_str(), bench::median(walls));
    bench::report(("cancel." + call.name + ".silence_ms").c_str(), 1e3 * whole.silence.longest);
    bench::report(("cancel." + call.name + ".worst_processor_ms").c_str(), worst_processor);
    bench::report(("cancel." + call.name + ".silence_processor_ms").c_str(), 1e3 * whole.silence.longest_processor);
    std::fflush(stdout);
}

// Measures calls that take no operation.
void measure_frame(bench::LongCalls& calls) {
    static_cast<void>(calls.drawing());
    scenes::Drawing drawing;
    std::vector<double> draws, images;
    std::vector<unsigned char> pixels(std::size_t{4} * 1280 * 720);
    auto image = scenes::made(hrbfnpr_image_init);
    image.format = HRBFNPR_FORMAT_RGBA8;
    image.width = 1280;
    image.height = 720;
    image.pixels = pixels.data();
    for (int i = 0; i < 9; ++i) {
        draws.push_back(1e3 * bench::seconds([&] { drawing = calls.draw(); }));
        images.push_back(1e3 * bench::seconds([&] {
                             scenes::Check check;
                             check(hrbfnpr_drawing_rasterize(drawing.get(), &image, nullptr, check.error()));
                         }));
    }
    bench::report("cancel.draw_ms", bench::median(draws));
    bench::report("cancel.rasterize_ms", bench::median(images));
}

void run(int argc, char** argv) {
    const auto number = [&](const char* name, std::int64_t otherwise) {
        const std::string text = bench::option(argc, argv, name);
        return text.empty() ? otherwise : static_cast<std::int64_t>(std::stoll(text));
    };
    bench::CallSizes sizes;
    sizes.samples = number("--samples=", sizes.samples);
    sizes.marks = number("--marks=", sizes.marks);
    sizes.dense = number("--dense=", sizes.dense);
    sizes.faces = number("--faces=", sizes.faces);
    const auto trials = static_cast<int>(number("--trials=", 20));
    const std::string named = bench::option(argc, argv, "--named=");
    const auto context = bench::make_context(static_cast<std::int32_t>(number("--threads=", 0)));
    bench::LongCalls calls(context.get(), sizes);
    for (const bench::LongCall& call : calls.all())
        if (call.name.find(named) != std::string::npos) measure(context.get(), call, trials);
    if (std::string("frame").find(named) != std::string::npos) measure_frame(calls);
}

} // namespace

int main(int argc, char** argv) {
    try {
        run(argc, argv);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
