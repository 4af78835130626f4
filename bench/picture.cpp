// SPDX-License-Identifier: MIT
// Time to picture by stage, for generated inputs in four styles. Each picture is made in a process of its own, whose
// peak memory and processor time are printed, too. --only=INPUTS and --styles=NAMES: lists with commas between;
// --runs=N: medians of N pictures; --size=N: pixels of the longer side; --threads=N; --clock=processor: stages in
// processor time of all threads, for busy machines; --limit=N: seconds after which a picture counts as unfinished;
// --write=DIR: writes the inputs as files and makes no pictures.
#include "picture_process.h"
#include "picture_stages.h"

#include <numeric>

namespace {

using bench::PictureCost;
using bench::PictureInput;
using bench::PictureSettings;

struct Options {
    std::vector<std::string> inputs; // empty: all
    std::vector<std::string> styles = {"contour-and-stipple", "engraving", "etching", "stipple"};
    int runs = 3;
    double limit = 600.0;
    PictureSettings picture;
};

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> words;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        words.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return words;
}

Options read_options(int argc, char** argv) {
    Options options;
    options.inputs = split(bench::option(argc, argv, "--only="));
    const std::string styles = bench::option(argc, argv, "--styles=");
    if (!styles.empty()) options.styles = split(styles);
    const auto number = [&](const char* name, auto& value) {
        const std::string text = bench::option(argc, argv, name);
        if (!text.empty()) value = static_cast<std::decay_t<decltype(value)>>(std::stod(text));
    };
    number("--runs=", options.runs);
    options.runs = std::max(options.runs, 1);
    number("--limit=", options.limit);
    number("--size=", options.picture.size);
    number("--threads=", options.picture.threads);
    options.picture.by_processor = bench::option(argc, argv, "--clock=") == "processor";
    return options;
}

std::vector<PictureInput> chosen_inputs(const Options& options) {
    std::vector<PictureInput> chosen;
    for (const PictureInput& input : bench::picture_inputs())
        if (options.inputs.empty() ||
            std::find(options.inputs.begin(), options.inputs.end(), input.name) != options.inputs.end())
            chosen.push_back(input);
    if (chosen.empty() || (!options.inputs.empty() && chosen.size() != options.inputs.size()))
        throw std::runtime_error("--only names an input that does not exist");
    return chosen;
}

// Medians over the runs of one input in one style.
struct Row {
    PictureCost cost;
    bench::ProcessUse use;

    // The share of the stages' time that went into marks which this camera cannot show: marks outside the picture or on
    // the far side. The time of the marks' stage is divided evenly among all marks that were placed.
    [[nodiscard]] double unneeded_share() const {
        if (cost.placed == 0.0) return 0.0;
        const double all = std::accumulate(cost.seconds.begin(), cost.seconds.end(), 0.0);
        return cost.seconds[PictureCost::marks] * (1.0 - cost.possible / cost.placed) / all;
    }
    [[nodiscard]] double shown_share() const { return cost.placed == 0.0 ? 0.0 : cost.shown / cost.placed; }
};

Row measure(const PictureInput& input, const bench::PictureMesh& mesh, const Options& options) {
    std::vector<Row> rows;
    for (int run = 0; run < options.runs; ++run) {
        Row row{};
        row.use = bench::run_in_process([&] { return bench::make_picture(input, mesh, options.picture); },
                                        options.limit, row.cost);
        if (!row.use.is_finished) return row;
        rows.push_back(row);
    }
    Row result = rows.at(0);
    const auto median_of = [&](auto number) {
        std::vector<double> values;
        for (Row& row : rows) values.push_back(number(row));
        number(result) = bench::median(values);
    };
    for (std::size_t i = 0; i < PictureCost::stages; ++i)
        median_of([i](Row& row) -> double& { return row.cost.seconds[i]; });
    median_of([](Row& row) -> double& { return row.cost.total; });
    median_of([](Row& row) -> double& { return row.use.cpu_seconds; });
    median_of([](Row& row) -> double& { return row.use.peak_megabytes; });
    return result;
}

void print_head() {
    std::printf("%-13s %-20s", "input", "style");
    for (const char* name : bench::stage_names) std::printf(" %6s", name);
    std::printf(" %7s %7s %8s %6s %8s %6s\n", "total", "cpu", "marks", "shown", "unneeded", "MB");
}

void print_row(const PictureInput& input, const std::string& style, const Row& row) {
    std::printf("%-13s %-20s", input.name, style.c_str());
    if (!row.use.is_finished) {
        std::printf(" unfinished; cpu %.1f s, %.0f MB\n", row.use.cpu_seconds, row.use.peak_megabytes);
        return;
    }
    for (const double seconds : row.cost.seconds) std::printf(" %6.2f", seconds);
    std::printf(" %7.2f %7.2f %8.0f %5.1f%% %7.1f%% %6.0f\n", row.cost.total, row.use.cpu_seconds, row.cost.placed,
                100.0 * row.shown_share(), 100.0 * row.unneeded_share(), row.use.peak_megabytes);
}

void measure_all(Options options) {
    std::vector<std::pair<std::string, double>> pairs;
    print_head();
    for (const PictureInput& input : chosen_inputs(options)) {
        const bench::PictureMesh mesh = input.generate == nullptr ? bench::PictureMesh{} : input.generate();
        for (const std::string& style : options.styles) {
            options.picture.style = style;
            const Row row = measure(input, mesh, options);
            print_row(input, style, row);
            std::fflush(stdout);
            std::string name = std::string(input.name) + "_" + style;
            std::replace(name.begin(), name.end(), '-', '_');
            pairs.emplace_back(name + "_unfinished", row.use.is_finished ? 0.0 : 1.0);
            pairs.emplace_back(name + "_peak_megabytes", row.use.peak_megabytes);
            pairs.emplace_back(name + "_cpu_seconds", row.use.cpu_seconds);
            if (!row.use.is_finished) continue;
            pairs.emplace_back(name + "_seconds", row.cost.total);
            pairs.emplace_back(name + "_marks", row.cost.placed);
            pairs.emplace_back(name + "_shown_share", row.shown_share());
            pairs.emplace_back(name + "_unneeded_share", row.unneeded_share());
        }
    }
    for (const auto& [name, value] : pairs) bench::report(name.c_str(), value);
}

} // namespace

int main(int argc, char** argv) {
    try {
        const Options options = read_options(argc, argv);
        const std::string folder = bench::option(argc, argv, "--write=");
        if (folder.empty()) {
            measure_all(options);
            return 0;
        }
        for (const PictureInput& input : chosen_inputs(options)) bench::write_input(input, folder);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
