// SPDX-License-Identifier: MIT
// Tests that every stage gives the same bits with any number of threads and any thread backend, and nearly the same
// numbers with every instruction set.
#include "stages/stages.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <thread>

namespace api_test::stages_test {
namespace {

// The scene is large enough that its loops have many tasks.
StageSizes scene() {
    StageSizes sizes;
    sizes.samples = 300;
    sizes.dense_samples = 900;
    sizes.half_samples = 600;
    sizes.cloud = 60;
    sizes.marks = 3000;
    sizes.places = 4000;
    sizes.pixels = 160;
    sizes.mesh_around = 60;
    return sizes;
}

using Results = std::map<std::string, Bytes>;

Results results_of(const Context& context, const StageSizes& sizes) {
    Results results;
    Stages stages(context, sizes);
    Attempt attempt;
    for (const Stage& stage : stages.all()) {
        Error error;
        if (stage.renew) stage.renew();
        EXPECT_OK(stage.call(attempt, results[stage.name], error)) << stage.name;
    }
    return results;
}

void expect_same(const Results& one, const Results& other, const std::string& what) {
    ASSERT_EQ(one.size(), other.size());
    for (const auto& [name, bytes] : one) EXPECT_TRUE(other.at(name) == bytes) << name << " " << what;
}

// The results of one thread.
const Results& serial() {
    static const auto& once = *new Results(results_of(make_context(1), scene()));
    return once;
}

// A host's job runner that uses two threads and begins with the last task.
void run_backwards(void* user, hrbfnpr_task_fn task, void* task_context, std::int64_t count) {
    static_cast<std::atomic<std::int64_t>*>(user)->fetch_add(count);
    std::thread odd([=] {
        for (std::int64_t i = count; i-- > 0;)
            if (i % 2 == 1) task(task_context, i);
    });
    for (std::int64_t i = count; i-- > 0;)
        if (i % 2 == 0) task(task_context, i);
    odd.join();
}

class DeterminismOfStages : public testing::TestWithParam<std::int32_t> {};

TEST_P(DeterminismOfStages, AnyThreadCountGivesTheSameBits) {
    expect_same(serial(), results_of(make_context(GetParam()), scene()), std::to_string(GetParam()) + " threads");
}
INSTANTIATE_TEST_SUITE_P(Threads, DeterminismOfStages, testing::Values(1, 2, 3, 7, 16));

TEST(DeterminismOfBackends, OpenMpGivesTheSameBits) {
    auto desc = made(hrbfnpr_context_desc_init);
    desc.thread_count = 3;
    desc.thread_backend = HRBFNPR_THREAD_BACKEND_OPENMP;
    hrbfnpr_context* probe = nullptr;
    if (hrbfnpr_context_create(&desc, &probe, nullptr) != HRBFNPR_STATUS_OK) GTEST_SKIP() << "a build without OpenMP";
    hrbfnpr_context_release(probe);
    expect_same(serial(), results_of(make_context(desc), scene()), "by OpenMP");
}

TEST(DeterminismOfBackends, AHostsJobsGiveTheSameBits) {
    std::atomic<std::int64_t> tasks{0};
    auto desc = made(hrbfnpr_context_desc_init);
    desc.thread_count = 5;
    desc.run_tasks = run_backwards;
    desc.run_tasks_user = &tasks;
    expect_same(serial(), results_of(make_context(desc), scene()), "by run_tasks");
    EXPECT_GT(tasks, 1000);
}

// ---- Instruction sets --------------------------------------------------------------------------

// The largest difference of numbers. It is infinite if the sizes differ, or if a number is NaN in only one of the two.
template <class T>
double farthest(const Bytes& one, const Bytes& other) {
    if (one.size() != other.size()) return HUGE_VAL;
    double most = 0.0;
    for (std::size_t at = 0; at + sizeof(T) <= one.size(); at += sizeof(T)) {
        T a = 0, b = 0;
        std::memcpy(&a, one.data() + at, sizeof(T));
        std::memcpy(&b, other.data() + at, sizeof(T));
        if (std::memcmp(&a, &b, sizeof(T)) == 0) continue;
        const double difference = std::abs(static_cast<double>(a) - static_cast<double>(b));
        most = std::isnan(difference) ? HUGE_VAL : std::max(most, difference);
    }
    return most;
}

// The model is 2.6 across. Curvatures and Hessians are second derivatives, and hits of grazing rays are the most
// sensitive results.
TEST(DeterminismOfInstructionSets, NumbersAgreeClosely) {
    const std::map<std::string, double> tolerances{{"evaluate", 1e-9},   {"project", 1e-10},      {"curvature", 1e-8},
                                                   {"contains", 0.0},    {"cast_rays", 1e-9},     {"lipschitz", 1e-10},
                                                   {"mesh.create", 0.0}, {"farthest_points", 0.0}};
    auto desc = made(hrbfnpr_context_desc_init);
    desc.thread_count = 2;
    desc.highest_instruction_set = HRBFNPR_INSTRUCTION_SET_BASELINE;
    const Results baseline = results_of(make_context(desc), scene());
    for (const std::uint32_t set :
         {HRBFNPR_INSTRUCTION_SET_AVX2, HRBFNPR_INSTRUCTION_SET_AVX512, HRBFNPR_INSTRUCTION_SET_NEON}) {
        desc.highest_instruction_set = set;
        const Context context = make_context(desc);
        if (info_of(context).instruction_set != set) continue;
        const Results results = results_of(context, scene());
        for (const auto& [name, tolerance] : tolerances) {
            const double off = name == "contains" || name == "farthest_points"
                                   ? (results.at(name) == baseline.at(name) ? 0.0 : HUGE_VAL)
                                   : farthest<double>(baseline.at(name), results.at(name));
            std::printf("instruction set %u, %-16s off by %.1e, at most %.0e\n", set, name.c_str(), off, tolerance);
            EXPECT_LE(off, tolerance) << name << ", instruction set " << set;
        }
    }
}

// Pictures are the same to the bit if their marks are, with one colour and with several.
TEST(DeterminismOfInstructionSets, EqualMarksGiveEqualPictures) {
    constexpr std::int32_t side = 300;
    Error error;
    Bytes file;
    std::map<std::array<std::uint32_t, 3>, Bytes> pictures;
    for (const std::uint32_t set : {HRBFNPR_INSTRUCTION_SET_BASELINE, HRBFNPR_INSTRUCTION_SET_AVX2,
                                    HRBFNPR_INSTRUCTION_SET_AVX512, HRBFNPR_INSTRUCTION_SET_NEON}) {
        auto desc = made(hrbfnpr_context_desc_init);
        desc.thread_count = 2;
        desc.highest_instruction_set = set;
        const Context context = make_context(desc);
        if (info_of(context).instruction_set != set) continue;
        if (file.empty())
            file = saved(generate(context, fit(context, scenes::torus(200)), hrbfnpr::test::three_layers(4000)));
        hrbfnpr_point_set* loaded = nullptr;
        ASSERT_OK(hrbfnpr_point_set_load_memory(context.get(), file.data(), static_cast<std::int64_t>(file.size()),
                                                &loaded, error));
        const PointSet marks(loaded);
        const Renderer renderer = make_renderer(context);
        for (const std::uint32_t shape : {HRBFNPR_SHAPE_DOTS, HRBFNPR_SHAPE_STROKES, HRBFNPR_SHAPE_HATCH})
            for (const std::uint32_t hidden : {HRBFNPR_HIDDEN_LINES_HIDE, HRBFNPR_HIDDEN_LINES_ATTENUATE})
                for (const std::uint32_t colours : {1U, 2U}) {
                    std::array layers{made(hrbfnpr_layer_style_init), made(hrbfnpr_layer_style_init)};
                    layers[0].kind = HRBFNPR_LAYER_KIND_STIPPLES;
                    layers[0].ink[0] = colours == 1 ? 0.0F : 0.9F;
                    layers[0].shape = layers[1].shape = shape;
                    auto style = made(hrbfnpr_style_init);
                    style.layers = layers.data();
                    style.layer_count = 2;
                    style.hidden_lines = hidden;
                    const Drawing drawing = draw_item(renderer, item_of(marks, &style), front_camera(side));
                    const Bytes pixels = rasterize(drawing, side);
                    const auto& first = pictures.try_emplace({shape, hidden, colours}, pixels).first->second;
                    EXPECT_TRUE(first == pixels) << "instruction set " << set << ", shape " << shape;
                }
    }
    EXPECT_EQ(pictures.size(), 12U);
}

} // namespace
} // namespace api_test::stages_test
