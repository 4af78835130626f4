// SPDX-License-Identifier: MIT
// Frames: time, growth and ratios to plain code, to software OpenGL and to memory access; pops; tone. --head=FILE: a
// PLY of points with normals (default: a generated surface); --only=PART,...: any of speed, llvmpipe, growth, pops,
// tone, even.
#include "analytic.h"
#include "changes.h"
#include "llvmpipe.h"
#include "picture_evenness.h"
#include "plain_frame.h"
#include "ramp_drawing.h"
#include "read_models.h"
#include "timing.h"

#include <cstdio>
#include <exception>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using bench::Orbit;
using bench::Painter;
using bench::Samples;
using bench::Style;

constexpr std::int64_t many = 700'000;
constexpr int runs = 7;
constexpr double step = 0.7; // degrees from one frame to the next

// ---- The scenes ---------------------------------------------------------------------------

// Surfaces fitted to more or fewer samples, and marks on them: half stipples and half lines.
class Stock {
public:
    explicit Stock(Samples samples) : samples_(std::move(samples)) {}

    [[nodiscard]] hrbfnpr_context* context() const { return context_.get(); }
    [[nodiscard]] std::int64_t samples() const { return samples_.count(); }
    [[nodiscard]] const hrbfnpr_point_set* marks(std::int64_t count) { return marks(count, samples_.count()); }
    [[nodiscard]] const hrbfnpr_point_set* marks(std::int64_t count, std::int64_t samples) {
        scenes::PointSet& set = marks_[{count, samples}];
        if (set == nullptr) {
            bench::Generation desc = bench::one_layer(HRBFNPR_LAYER_KIND_STIPPLES, count / 2);
            desc.add(HRBFNPR_LAYER_KIND_HATCH, count - count / 2);
            set = bench::generate(context(), model(samples), desc);
        }
        return set.get();
    }

    [[nodiscard]] scenes::PointSet stipples(std::int64_t count) {
        return bench::generate(context(), model(samples_.count()),
                               bench::one_layer(HRBFNPR_LAYER_KIND_STIPPLES, count));
    }

private:
    [[nodiscard]] const hrbfnpr_model* model(std::int64_t count) {
        scenes::Model& model = models_[count];
        if (model == nullptr) {
            Samples some;
            for (std::int64_t i = 0; i < count; ++i) {
                const auto at = static_cast<std::size_t>(3 * (i * samples_.count() / count));
                some.add({samples_.points[at], samples_.points[at + 1], samples_.points[at + 2]},
                         {samples_.normals[at], samples_.normals[at + 1], samples_.normals[at + 2]});
            }
            model = bench::fit(context(), some.points, some.normals);
        }
        return model.get();
    }

    scenes::Context context_ = bench::make_context();
    Samples samples_;
    std::map<std::int64_t, scenes::Model> models_;
    std::map<std::pair<std::int64_t, std::int64_t>, scenes::PointSet> marks_;
};

Style full() { return bench::full_of_dots(); }

Style without_attenuation() {
    Style style = full();
    style.hidden_lines = HRBFNPR_HIDDEN_LINES_SHOW;
    return style;
}

// The tone is the share of marks that are shown.
Style as_published() {
    Style style = full();
    style.visibility = HRBFNPR_VISIBILITY_PUBLISHED;
    style.tone_curve = HRBFNPR_TONE_CURVE_LINEAR;
    return style;
}

// All marks are shown.
Style every_mark() {
    Style style = full();
    style.tone = HRBFNPR_TONE_NONE;
    style.tone_curve = HRBFNPR_TONE_CURVE_LINEAR;
    for (hrbfnpr_layer_style& layer : style.layer) layer.share = 1.0F;
    return style;
}

// Draws one frame of an orbit after the other.
template <class Picture>
class Film {
public:
    Film(Picture& picture, const Orbit& orbit) : picture_(picture), orbit_(orbit) {}
    void operator()() { picture_.draw(orbit_.at(step * frame_++)); }

private:
    Picture& picture_;
    const Orbit& orbit_;
    int frame_ = 0;
};

struct Results {
    std::vector<std::pair<std::string, double>> pairs;

    void add(const std::string& name, double value) { pairs.emplace_back("frame." + name, value); }
};

// ---- Time ----------------------------------------------------------------------------------

struct Size {
    const char* name;
    int width, height;
};
constexpr Size small{"720p", 1280, 720};
constexpr Size large{"1080p", 1920, 1080};

// A row of the table: a style on some marks, and the medians of its frame times.
struct Row {
    std::int64_t marks;
    Size size;
    std::string name;
    const hrbfnpr_point_set* set;
    Style style;
    double ms = 0.0, best = 0.0, classify = 0.0, visibility = 0.0, sort = 0.0, draw = 0.0;
    hrbfnpr_drawing_info info{};
};

void print(const Row& row) {
    std::printf("%9lld %-6s %-14s %8.2f %8.2f %8.1f %9.1fM  %8.2f %8.2f %8.2f %8.2f  %8lld %8lld\n",
                static_cast<long long>(row.marks), row.size.name, row.name.c_str(), row.ms, row.best, 1e3 / row.ms,
                1e-3 * static_cast<double>(row.info.marks) / row.ms, row.classify, row.visibility, row.sort, row.draw,
                static_cast<long long>(row.info.shown), static_cast<long long>(row.info.splats));
}

// Times a few frames of each row in turn, so that other load on the machine affects all rows.
void time(hrbfnpr_context* context, std::vector<Row>& rows) {
    constexpr int rounds = 3;
    constexpr int frames = 3; // per round, after one that does not count
    struct Bench {
        Bench(hrbfnpr_context* context, const Row& row)
            : orbit(row.set, row.size.width, row.size.height),
              painter(context, row.set, row.style, row.size.width, row.size.height), film(painter, orbit) {}
        Orbit orbit;
        Painter painter;
        Film<Painter> film;
        std::vector<double> total, classify, visibility, sort, draw;
    };
    std::vector<std::unique_ptr<Bench>> benches;
    for (const Row& row : rows) benches.push_back(std::make_unique<Bench>(context, row));
    for (int round = 0; round < rounds; ++round)
        for (const std::unique_ptr<Bench>& b : benches) {
            b->film();
            for (int frame = 0; frame < frames; ++frame) {
                b->total.push_back(1e3 * bench::seconds(b->film));
                const hrbfnpr_drawing_info info = b->painter.info();
                b->classify.push_back(1e-6 * static_cast<double>(info.nanoseconds_classify));
                b->visibility.push_back(1e-6 * static_cast<double>(info.nanoseconds_visibility));
                b->sort.push_back(1e-6 * static_cast<double>(info.nanoseconds_sort));
                b->draw.push_back(b->painter.image_ms());
            }
        }
    std::printf("%9s %-6s %-14s %8s %8s %8s %10s  %8s %8s %8s %8s  %8s %8s\n", "marks", "size", "style", "ms", "best",
                "frames/s", "marks/s", "classify", "visible", "sort", "image", "shown", "splats");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Bench& b = *benches[i];
        rows[i].ms = bench::median(b.total);
        rows[i].best = *std::min_element(b.total.begin(), b.total.end());
        rows[i].classify = bench::median(b.classify);
        rows[i].visibility = bench::median(b.visibility);
        rows[i].sort = bench::median(b.sort);
        rows[i].draw = bench::median(b.draw);
        rows[i].info = benches[i]->painter.info();
        print(rows[i]);
    }
    std::fflush(stdout);
}

std::string short_name(std::int64_t marks) {
    return marks >= 1'000'000 ? std::to_string(marks / 1'000'000) + "m" : std::to_string(marks / 1000) + "k";
}

void run_rows(Stock& stock, Results& results) {
    std::vector<Row> rows;
    for (const std::int64_t count : {std::int64_t{100'000}, many, std::int64_t{1'000'000}})
        for (const Size& size : {small, large}) {
            rows.push_back({count, size, "full", stock.marks(count), full()});
            rows.push_back({count, size, "no attenuation", stock.marks(count), without_attenuation()});
        }
    rows.push_back({many, small, "as published", stock.marks(many), as_published()});
    rows.push_back({many, small, "every mark", stock.marks(many), every_mark()});
    std::printf("\nmilliseconds of whole frames (medians, and the best) and of their stages\n");
    time(stock.context(), rows);
    for (const Row& row : rows) {
        const std::string name = short_name(row.marks) + "." + row.size.name;
        if (row.name == "full") results.add(name + ".ms", row.ms);
        if (row.name == "every mark") results.add(name + ".every_mark.ms", row.ms);
        if (row.name == "as published") results.add(name + ".published.ms", row.ms);
    }
}

// Reads position, normal and rank of all marks once, clears the image, then reads and writes each pixel; on one thread.
void touch(const hrbfnpr_point_set* set, std::vector<std::uint8_t>& pixels) {
    std::uint32_t sum = 0;
    for (std::int64_t layer = 0; layer < bench::info_of(set).layers; ++layer)
        for (const std::uint32_t which :
             {HRBFNPR_MARK_ATTRIBUTE_POSITION, HRBFNPR_MARK_ATTRIBUTE_NORMAL, HRBFNPR_MARK_ATTRIBUTE_RANK}) {
            std::int64_t count = 0;
            // As integers, because the compiler vectorizes only their sum.
            const auto* numbers = bench::attribute<std::uint32_t>(set, layer, which, count);
            const std::int64_t all = count * (which == HRBFNPR_MARK_ATTRIBUTE_RANK ? 1 : 3);
            for (std::int64_t i = 0; i < all; ++i) sum += numbers[i];
        }
    std::fill(pixels.begin(), pixels.end(), std::uint8_t{255});
    const auto mixed = static_cast<std::uint8_t>(sum);
    for (std::uint8_t& channel : pixels) channel = static_cast<std::uint8_t>(channel ^ mixed);
}

void run_ratios(Stock& stock, Results& results) {
    const hrbfnpr_point_set* set = stock.marks(many);
    const Orbit orbit(set, small.width, small.height);
    const Style style = full();
    Painter painter(stock.context(), set, style, small.width, small.height);
    Film ours(painter, orbit);
    Painter bare(stock.context(), set, without_attenuation(), small.width, small.height);
    Film unattenuated(bare, orbit);
    std::printf("\n700 000 marks, 1280 x 720: ratios of times, in turn\n");
    const auto against_plain = [&](const char* name, bool paper, Film<Painter>& film, const std::string& result) {
        bench::PlainFrame plain(set, style, small.width, small.height, paper);
        Film theirs(plain, orbit);
        const bench::Comparison c = bench::compare(3, theirs, film);
        std::printf("plain code on one thread, %s: %.2f ms (%zu discs), %.2f times as long\n", name,
                    1e3 * c.seconds * c.ratio, plain.discs(), c.ratio);
        results.add("700k.720p." + result, c.ratio);
    };
    against_plain("paper and ink, over full", true, ours, "ratio_plain");
    against_plain("ink alone, over no attenuation", false, unattenuated, "ratio_plain_ink");
    against_plain("ink alone, over full", false, ours, "ratio_plain_ink_over_full");
    std::vector<std::uint8_t> pixels = painter.pixels();
    const bench::Comparison memory = bench::compare(runs, ours, [&] { touch(set, pixels); });
    std::printf("reading position, normal and rank of all marks once, clearing and rewriting the image once, on one "
                "thread: %.2f ms; the frame takes %.2f times as long\n",
                1e3 * memory.seconds, memory.ratio);
    results.add("700k.720p.ratio_memory", memory.ratio);
    const scenes::Context serial = bench::make_context(1);
    Painter one(serial.get(), set, style, small.width, small.height);
    Film alone(one, orbit);
    const bench::Comparison cores = bench::compare(runs, alone, ours);
    std::printf("one thread instead of all: %.2f ms, %.2f times as long\n", 1e3 * cores.seconds * cores.ratio,
                cores.ratio);
    results.add("second_core_gain", cores.ratio);
}

void run_llvmpipe(Stock& stock, Results& results) {
    const hrbfnpr_point_set* set = stock.marks(many);
    const Orbit orbit(set, small.width, small.height);
    Painter painter(stock.context(), set, full(), small.width, small.height);
    std::printf("\nsoftware OpenGL, 700 000 marks as round points, 1280 x 720, glReadPixels included\n");
    try {
        bench::Llvmpipe points(set, full().of(HRBFNPR_LAYER_KIND_STIPPLES).radius, small.width, small.height);
        Film theirs(points, orbit);
        Film ours(painter, orbit);
        const bench::Comparison c = bench::compare(runs, theirs, ours);
        std::printf("%s: %.2f ms; ours %.2f ms, %.2f times as fast\n", bench::Llvmpipe::renderer().c_str(),
                    1e3 * c.seconds * c.ratio, 1e3 * c.seconds, c.ratio);
        results.add("700k.720p.ratio_llvmpipe", c.ratio);
    } catch (const std::runtime_error& error) {
        std::printf("skipped: %s\n", error.what());
    }
}

void run_growth(Stock& stock, Results& results) {
    std::vector<Row> rows;
    for (const std::int64_t count : {100'000, 300'000, 700'000, 1'000'000})
        rows.push_back({count, small, "full", stock.marks(count), full()});
    for (const std::int64_t samples : {std::int64_t{256}, std::int64_t{1024}, stock.samples()})
        rows.push_back({many, small, std::to_string(samples) + " samples", stock.marks(many, samples), full()});
    std::printf("\ngrowth with the marks, and with the samples\n");
    time(stock.context(), rows);
    results.add("growth.1m_over_100k", rows[3].ms / rows[0].ms);
    results.add("growth.1m_over_700k", rows[3].ms / rows[2].ms);
    results.add("growth.4096_over_256_samples", rows[6].ms / rows[4].ms);
}

// ---- Coherence -----------------------------------------------------------------------------

void run_pops(Stock& stock, Results& results) {
    constexpr std::int64_t count = 200'000;
    constexpr bench::Way around{90, 0.5, 1.0};
    constexpr bench::Way closer{60, 0.0, 1.03};
    const hrbfnpr_point_set* set = stock.marks(count);
    const Orbit orbit(set, small.width, small.height);
    // No mark is hidden by another surface, and the light stays fixed to the model.
    Style style = without_attenuation();
    style.light_space = HRBFNPR_LIGHT_WORLD;
    for (hrbfnpr_layer_style& layer : style.layer) layer.radius_zoom = 0.0F;
    Style sudden = style;
    sudden.tone_fade = 0.0F;
    std::printf("\nchanges from frame to frame, %lld marks, light of the world, hidden lines shown\n",
                static_cast<long long>(count));
    std::printf("%-28s %6s %9s %9s %10s %10s %10s\n", "way", "frames", "shown", "pops", "rate", "removals", "rate");
    const auto row = [&](const char* name, const Style& of, const bench::Way& way, bool reroll) {
        const bench::Changes c = bench::follow(stock.context(), set, of, orbit, way, reroll);
        std::printf("%-28s %6.0f %9.0f %9.0f %10.6f %10.0f %10.6f\n", name, c.frames, c.shown / (c.frames - 1.0),
                    c.pops, c.pop_rate(), c.removals, c.removal_rate());
        std::fflush(stdout);
        return c;
    };
    const bench::Way still{1, 0.0, 1.0};
    const bench::Changes same = row("the same camera twice", style, still, false);
    results.add("still_changes", same.pops + same.removals);
    results.add("pop_rate", row("orbit", style, around, false).pop_rate());
    row("orbit, tone_fade 0", sudden, around, false);
    Style lamp = style;
    lamp.light_space = HRBFNPR_LIGHT_CAMERA;
    row("orbit, light of the camera", lamp, around, false);
    results.add("pop_rate_rerolled", row("orbit, new ranks", style, {15, around.degrees, 1.0}, true).pop_rate());
    results.add("zoom_in_removals", row("zoom in", style, closer, false).removal_rate());
    row("zoom in, tone_fade 0", sudden, closer, false);
    results.add("zoom_in_removals_rerolled",
                row("zoom in, new ranks", style, {15, 0.0, closer.zoom}, true).removal_rate());
}

// ---- Tone ----------------------------------------------------------------------------------

std::int32_t asked_tone(void*, std::int64_t count, const float* positions, const float*, float* tau) {
    for (std::int64_t i = 0; i < count; ++i)
        tau[i] = static_cast<float>(1.0 - std::clamp(bench::asked(bench::ramp_column(positions[3 * i])), 0.0, 1.0));
    return 0;
}

void run_tone(Stock& stock, Results& results) {
    std::printf("\ncoverage asked for from 0.05 to 0.55, marks of 1.5 px, blurred by 4 px\n");
    Style style = bench::ramp_style(asked_tone);
    // Take the worst over different numbers of marks.
    bench::ToneError worst{1e9, 0.0};
    for (const double facing : {1.0, 0.5, 0.25}) {
        const scenes::Model model = bench::custom(stock.context(), bench::plane, {2.2, 1.2 / facing, 0.4});
        for (const double all : {1.0, 2.0, 4.0}) {
            const std::int64_t budget = bench::ramp_budget(stock.context(), model.get(), all);
            const scenes::PointSet set =
                bench::generate(stock.context(), model.get(), bench::one_layer(HRBFNPR_LAYER_KIND_STIPPLES, budget));
            const bench::ToneError error =
                bench::tone_error(bench::drawn_ramp(stock.context(), set.get(), style, facing));
            std::printf("n . v %.2f, %8lld marks, area of all %.0f times the paper's: psnr %.2f dB, bias %+.4f\n",
                        facing, static_cast<long long>(budget), all, error.psnr, error.bias);
            worst.psnr = std::min(worst.psnr, error.psnr);
            if (std::abs(error.bias) > std::abs(worst.bias)) worst.bias = error.bias;
        }
    }
    results.add("tone_psnr_db", worst.psnr);
    results.add("tone_bias", worst.bias);
}

// ---- Evenness in the picture ---------------------------------------------------------------

std::int32_t one_tone(void* coverage, std::int64_t count, const float*, const float*, float* tau) {
    std::fill_n(tau, count, 1.0F - *static_cast<float*>(coverage));
    return 0;
}

void run_even(Stock& stock, Results& results) {
    constexpr int pixels = 1400;
    constexpr std::int64_t count = 400'000;
    const scenes::PointSet set = stock.stipples(count);
    const Orbit orbit(set.get(), pixels, pixels);
    std::array<bench::Nearest, 5> all;
    std::printf("\ndistances to the nearest mark in the picture, 1400 pixels, tones of 0.08 to 0.5: standard deviation "
                "over mean (fifth percentile)\n%8s",
                "covered");
    for (std::size_t i = 0; i < all.size(); ++i)
        std::printf("   n.v %.1f-%.1f", bench::facing_bands[i], bench::facing_bands[i + 1]);
    std::printf("\n");
    const auto print = [](std::array<bench::Nearest, 5>& bands) {
        for (bench::Nearest& band : bands) std::printf("  %5.3f (%5.3f)", band.variation(), band.fifth_percentile());
        std::printf("\n");
        std::fflush(stdout);
    };
    for (float coverage : {0.08F, 0.16F, 0.3F, 0.5F}) {
        Style style = bench::ramp_style(one_tone);
        style.hidden_lines = HRBFNPR_HIDDEN_LINES_HIDE;
        style.tone_user = &coverage;
        Painter painter(stock.context(), set.get(), style, pixels, pixels);
        std::array<bench::Nearest, 5> bands;
        const hrbfnpr_camera camera = orbit.at(20.0);
        bench::add_nearest(set.get(), camera, painter.discs(camera), bench::ramp_radius,
                           bench::ink_of_coverage(static_cast<double>(coverage)), bands);
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i].distance.insert(all[i].distance.end(), bands[i].distance.begin(), bands[i].distance.end());
        std::printf("%8.2f", static_cast<double>(coverage));
        print(bands);
    }
    std::printf("%8s", "all");
    print(all);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string band = std::to_string(i + 1);
        results.add("even_cv." + band, all[i].variation());
        results.add("even_radius." + band, all[i].fifth_percentile());
    }
}

void run(const std::string& head, const std::string& only) {
    Stock stock(head.empty() ? bench::bumpy(4096, 0.15) : bench::read_ply(head));
    Results results;
    // No part's name is contained in another's.
    const auto wanted = [&](const char* part) { return only.empty() || only.find(part) != std::string::npos; };
    if (wanted("speed")) {
        run_rows(stock, results);
        run_ratios(stock, results);
    }
    if (wanted("llvmpipe")) run_llvmpipe(stock, results);
    if (wanted("growth")) run_growth(stock, results);
    if (wanted("pops")) run_pops(stock, results);
    if (wanted("tone")) run_tone(stock, results);
    if (wanted("even")) run_even(stock, results);
    std::printf("\n");
    for (const auto& [name, value] : results.pairs) bench::report(name.c_str(), value);
}

} // namespace

int main(int argc, char** argv) try {
    run(bench::option(argc, argv, "--head="), bench::option(argc, argv, "--only="));
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
