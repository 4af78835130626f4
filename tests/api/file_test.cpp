// SPDX-License-Identifier: MIT
// Tests saving and loading through the C boundary. tests/io tests the details of the format.
#include "fixture.h"

namespace api_test::file_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

// A stream in memory that may fail.
struct Stream {
    Bytes bytes;
    std::size_t at = 0;
    std::size_t fail_at = ~std::size_t{0};
    std::uint64_t most = 1000;

    static std::int32_t write(void* user, const void* data, std::uint64_t size) {
        auto& self = *static_cast<Stream*>(user);
        const auto* from = static_cast<const std::uint8_t*>(data);
        if (self.bytes.size() + size > self.fail_at) return -5;
        self.bytes.insert(self.bytes.end(), from, from + size);
        return 0;
    }
    static std::int64_t read(void* user, void* data, std::uint64_t size) {
        auto& self = *static_cast<Stream*>(user);
        if (self.at >= self.fail_at) return -1;
        const std::size_t count = std::min(
            {static_cast<std::size_t>(size), self.bytes.size() - self.at, static_cast<std::size_t>(self.most)});
        std::memcpy(data, self.bytes.data() + self.at, count);
        self.at += count;
        return static_cast<std::int64_t>(count);
    }
};

Model load_model(const Context& context, const Bytes& bytes) {
    Error error;
    hrbfnpr_model* model = nullptr;
    EXPECT_OK(
        hrbfnpr_model_load_memory(context.get(), bytes.data(), static_cast<std::int64_t>(bytes.size()), &model, error));
    return Model(model);
}

std::vector<double> values(const Model& model) {
    Error error;
    std::vector<double> point;
    for (int i = 0; i < 300; ++i) point.push_back(0.013 * i - 1.7);
    std::vector<double> value(100);
    const hrbfnpr_array points = in(point);
    const hrbfnpr_array_out result = out(value, 1);
    EXPECT_OK(hrbfnpr_model_evaluate(model.get(), &points, &result, nullptr, nullptr, nullptr, error));
    return value;
}

TEST(File, ALoadedModelGivesTheSameBits) {
    Error error;
    const Context context = make_context();
    const Context other = make_context(1);
    const Model model = fit(context, scenes::torus(40));
    const Bytes bytes = saved(model);
    const Model loaded = load_model(other, bytes);
    EXPECT_EQ(values(loaded), values(model));
    EXPECT_EQ(saved(loaded), bytes);
    auto a = made(hrbfnpr_model_info_init);
    auto b = made(hrbfnpr_model_info_init);
    EXPECT_OK(hrbfnpr_model_get_info(model.get(), &a, error));
    EXPECT_OK(hrbfnpr_model_get_info(loaded.get(), &b, error));
    b.bytes = a.bytes; // capacities may differ
    EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0);
    EXPECT_EQ(saved(generate(other, loaded, small_desc())).size(), saved(generate(other, model, small_desc())).size());
}

TEST(File, ALoadedPointSetDrawsTheSamePicture) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const PointSet set = generate(context, custom_sphere(context, sphere), small_desc());
    const Bytes bytes = saved(set);
    hrbfnpr_point_set* loaded = nullptr;
    ASSERT_OK(hrbfnpr_point_set_load_memory(context.get(), bytes.data(), static_cast<std::int64_t>(bytes.size()),
                                            &loaded, error));
    const PointSet again(loaded);
    EXPECT_EQ(saved(again), bytes);
    const Renderer renderer = make_renderer(context);
    EXPECT_EQ(draw(renderer, again), draw(renderer, set));
}

TEST(File, ASetWithoutMarksLoads) {
    Error error;
    const Context context = make_context();
    const Generation desc = one_layer(HRBFNPR_LAYER_KIND_HATCH, 1); // fewer marks than a line has
    const PointSet set = generate(context, fit(context, scenes::sphere_6()), desc);
    const hrbfnpr_point_set_info info = info_of(set);
    ASSERT_EQ(info.marks, 0);
    EXPECT_EQ(info.layers, 1);
    EXPECT_EQ(info.origin[0], 0.0);
    EXPECT_EQ(info.spacing, 0.0);
    const Bytes bytes = saved(set);
    hrbfnpr_point_set* loaded = nullptr;
    ASSERT_OK(hrbfnpr_point_set_load_memory(context.get(), bytes.data(), static_cast<std::int64_t>(bytes.size()),
                                            &loaded, error));
    EXPECT_EQ(saved(PointSet(loaded)), bytes);
}

// Marks are floats. If the model or its curvatures are too large for floats, a set must not hold infinities.
TEST(File, GeneratedSetsLoadAtEveryScale) {
    Error error;
    const Context context = make_context();
    for (const double scale : {1e-90, 1e-30, 1.0, 1e30, 1e90}) {
        scenes::Samples samples = scenes::sphere_6();
        for (double& coordinate : samples.points) coordinate *= scale;
        const Model model = fit(context, samples);
        for (const std::uint32_t distribution : {HRBFNPR_DISTRIBUTION_PUBLISHED, HRBFNPR_DISTRIBUTION_BLUE_NOISE}) {
            Generation desc = small_desc(distribution);
            hrbfnpr_point_set* made = nullptr;
            const hrbfnpr_status status =
                hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), nullptr, &made, error);
            EXPECT_EQ(made != nullptr, status == HRBFNPR_STATUS_OK);
            if (made == nullptr) {
                EXPECT_TRUE(scale == 1e-90 || scale == 1e90) << scale << ": " << error.record.message;
                continue;
            }
            const Bytes bytes = saved(PointSet(made));
            hrbfnpr_point_set* loaded = nullptr;
            EXPECT_OK(hrbfnpr_point_set_load_memory(context.get(), bytes.data(),
                                                    static_cast<std::int64_t>(bytes.size()), &loaded, error))
                << " at " << scale;
            hrbfnpr_point_set_release(loaded);
        }
    }
}

TEST(File, StreamsCarryTheSameBytes) {
    Error error;
    const Context context = make_context();
    const Model model = fit(context, scenes::torus(40));
    Sphere sphere;
    const PointSet set = generate(context, custom_sphere(context, sphere), small_desc());
    Stream stream;
    EXPECT_OK(hrbfnpr_model_save(model.get(), Stream::write, &stream, error));
    EXPECT_EQ(stream.bytes, saved(model));
    EXPECT_OK(
        hrbfnpr_point_set_save(set.get(), Stream::write, &stream, error)); // both in one stream, one after the other
    hrbfnpr_model* model_again = nullptr;
    hrbfnpr_point_set* set_again = nullptr;
    ASSERT_OK(hrbfnpr_model_load(context.get(), Stream::read, &stream, &model_again, error));
    ASSERT_OK(hrbfnpr_point_set_load(context.get(), Stream::read, &stream, &set_again, error));
    EXPECT_EQ(stream.at, stream.bytes.size());
    EXPECT_EQ(saved(Model(model_again)), saved(model));
    EXPECT_EQ(saved(PointSet(set_again)), saved(set));
}

TEST(File, StreamFailuresAreIoErrors) {
    Error error;
    const Context context = make_context();
    const Model model = fit(context, scenes::sphere_6());
    const Bytes whole = saved(model);
    for (std::size_t at = 0; at < whole.size(); at += 97) {
        Stream stream;
        stream.fail_at = at;
        EXPECT_FAILS(hrbfnpr_model_save(model.get(), Stream::write, &stream, error), HRBFNPR_STATUS_IO,
                     "write returned -5");
        stream.bytes = whole;
        stream.most = 50;
        hrbfnpr_model* loaded = nullptr;
        EXPECT_FAILS(hrbfnpr_model_load(context.get(), Stream::read, &stream, &loaded, error), HRBFNPR_STATUS_IO,
                     "read returned -1");
        EXPECT_EQ(loaded, nullptr);
    }
    hrbfnpr_model* loaded = nullptr;
    const hrbfnpr_read_fn liar = [](void*, void*, std::uint64_t size) { return static_cast<std::int64_t>(size) + 1; };
    EXPECT_FAILS(hrbfnpr_model_load(context.get(), liar, nullptr, &loaded, error), HRBFNPR_STATUS_IO, "read returned");
}

TEST(File, ATooSmallBufferIsLeftUnchanged) {
    Error error;
    const Context context = make_context();
    const Model model = fit(context, scenes::sphere_6());
    std::int64_t size = 0;
    Bytes small(10, 7);
    EXPECT_FAILS(hrbfnpr_model_save_memory(model.get(), small.data(), 10, &size, error),
                 HRBFNPR_STATUS_BUFFER_TOO_SMALL, "capacity is 10");
    EXPECT_EQ(small, Bytes(10, 7));
    EXPECT_EQ(size, static_cast<std::int64_t>(saved(model).size()));
    const auto invalid = HRBFNPR_STATUS_INVALID_ARGUMENT;
    EXPECT_FAILS(hrbfnpr_model_save_memory(model.get(), small.data(), 10, nullptr, error), invalid, "size is NULL");
    EXPECT_FAILS(hrbfnpr_model_save_memory(model.get(), nullptr, 10, &size, error), invalid, "destination is NULL");
    EXPECT_FAILS(hrbfnpr_model_save_memory(model.get(), small.data(), -1, &size, error), invalid, "capacity is -1");
    EXPECT_FAILS(hrbfnpr_model_save(model.get(), nullptr, nullptr, error), invalid, "write is NULL");
    hrbfnpr_model* loaded = nullptr;
    EXPECT_FAILS(hrbfnpr_model_load(context.get(), nullptr, nullptr, &loaded, error), invalid, "read is NULL");
    EXPECT_FAILS(hrbfnpr_model_load_memory(context.get(), nullptr, 5, &loaded, error), invalid, "data is NULL");
    EXPECT_FAILS(hrbfnpr_model_load_memory(context.get(), small.data(), -5, &loaded, error), invalid, "size is -5");
}

} // namespace
} // namespace api_test::file_test
