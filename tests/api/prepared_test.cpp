// SPDX-License-Identifier: MIT
// Tests queries and marks of enough points for the model to prepare itself. The reference is the sum over all
// centres, which queries of few points use.
#include "fixture.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

namespace api_test::prepared_test {
namespace {

constexpr std::int64_t few = 20000; // number of points that is not worth preparing

struct Evaluated {
    std::vector<double> value, gradient;
};

Evaluated evaluate(const Model& model, const std::vector<double>& points, std::int64_t at_a_time) {
    Error error;
    const auto count = static_cast<std::int64_t>(points.size() / 3);
    Evaluated result{std::vector<double>(points.size() / 3), std::vector<double>(points.size())};
    for (std::int64_t begin = 0; begin < count; begin += at_a_time) {
        const std::int64_t n = std::min(at_a_time, count - begin);
        const hrbfnpr_array in{points.data() + 3 * begin, n, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        const hrbfnpr_array_out value{result.value.data() + begin, n, 0, HRBFNPR_SCALAR_FLOAT64, 1};
        const hrbfnpr_array_out gradient{result.gradient.data() + 3 * begin, n, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        EXPECT_OK(hrbfnpr_model_evaluate(model.get(), &in, &value, &gradient, nullptr, nullptr, error));
    }
    return result;
}

std::vector<std::string> messages; // messages of the log, on this thread

Context logging_context(std::int32_t threads) {
    Error error;
    auto desc = made(hrbfnpr_context_desc_init);
    desc.thread_count = threads;
    desc.log = [](void*, std::int32_t, const char* message) { messages.emplace_back(message); };
    hrbfnpr_context* context = nullptr;
    EXPECT_OK(hrbfnpr_context_create(&desc, &context, error));
    messages.clear();
    return Context(context);
}

std::int64_t times_prepared() {
    return std::count_if(messages.begin(), messages.end(),
                         [](const std::string& message) { return message.find("prepared in") != std::string::npos; });
}

// Points around the tube's surface, inside and outside.
std::vector<double> places(std::int64_t count) {
    std::vector<double> points;
    for (std::int64_t i = 0; i < count; ++i) {
        const double phi = 2.399963229728653 * static_cast<double>(i);
        const double theta = 0.7548776662 * static_cast<double>(i);
        const double tube = 0.4 * (1.0 + 0.2 * std::pow(std::sin(0.37 * static_cast<double>(i)), 3.0));
        const double reach = 1.0 + tube * std::cos(theta);
        points.insert(points.end(), {reach * std::cos(phi), reach * std::sin(phi), tube * std::sin(theta)});
    }
    return points;
}

TEST(Prepared, ManyPointsGetTheResultsOfFewPoints) {
    const Context context = logging_context(2);
    const Model model = fit(context, scenes::torus(2000));
    const std::vector<double> points = places(800000);
    const Evaluated many = evaluate(model, points, 800000);
    EXPECT_EQ(times_prepared(), 1);
    const std::vector<double> some(points.begin(), points.begin() + 3 * few);
    const Evaluated direct = evaluate(model, some, few);
    const Evaluated again = evaluate(model, points, 800000);
    EXPECT_EQ(times_prepared(), 1) << "once a model";
    EXPECT_EQ(many.value, again.value);
    double value = 0.0;
    double gradient = 0.0;
    for (std::size_t i = 0; i < some.size() / 3; ++i) {
        value = std::max(value, std::abs(many.value[i] - direct.value[i]));
        for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
            gradient = std::max(gradient, std::abs(many.gradient[c] - direct.gradient[c]));
    }
    EXPECT_LT(value, 1e-9 * 4.0); // 4.0 is the diagonal
    EXPECT_LT(gradient, 1e-7);
    EXPECT_NE(many.value, evaluate(model, points, 100000).value) << "the two ways are the same";
}

TEST(Prepared, MarksAreKeptAndLieOnTheSurface) {
    Error error;
    const Context context = logging_context(2);
    const scenes::Samples samples = scenes::torus(2400);
    const Model model = fit(context, samples);
    Generation desc = one_layer(HRBFNPR_LAYER_KIND_STIPPLES, 0);
    desc.distribution = HRBFNPR_DISTRIBUTION_PUBLISHED;
    desc.seed_source = HRBFNPR_SEED_POINTS;
    desc.seed_points = in(samples.points);
    desc.layer[0].levels = 3;
    const PointSet set = generate(context, model, desc);
    EXPECT_EQ(times_prepared(), 1);
    hrbfnpr_array positions{};
    ASSERT_OK(hrbfnpr_point_set_view(set.get(), 0, HRBFNPR_MARK_ATTRIBUTE_POSITION, &positions, error));
    EXPECT_GE(positions.count, 2400 * 125 * 999 / 1000);
    auto info = made(hrbfnpr_point_set_info_init);
    ASSERT_OK(hrbfnpr_point_set_get_info(set.get(), &info, error));
    std::vector<double> points;
    const auto* at = static_cast<const float*>(positions.data);
    for (std::int64_t i = 0; i < 3 * positions.count; ++i)
        points.push_back(static_cast<double>(at[i]) + info.origin[i % 3]);
    const Evaluated direct = evaluate(model, points, few);
    const double diagonal = std::sqrt(2.8 * 2.8 * 2.0 + 0.8 * 0.8);
    double farthest = 0.0;
    for (const double value : direct.value) farthest = std::max(farthest, std::abs(value));
    EXPECT_LT(farthest, 1e-6 * diagonal);
}

} // namespace
} // namespace api_test::prepared_test
