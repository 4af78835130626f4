// SPDX-License-Identifier: MIT
// Tests functions, boxes, budgets and densities that make no sense: they are refused with a message, and cancellation
// works.
#include "fixture.h"

#include <cmath>
#include <limits>

namespace api_test::hostile_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// A sphere whose gradients are `factor` times too long where `spoils` returns true.
struct Steep {
    double factor = 1.0;
    bool (*spoils)(const double* p) = [](const double*) { return true; };
    double value_factor = 1.0;
    std::int64_t calls = 0;

    static std::int32_t call(void* user, std::int64_t count, const double* points, double* value, double* gradient,
                             double* /*hessian*/) {
        auto& self = *static_cast<Steep*>(user);
        ++self.calls;
        for (std::int64_t i = 0; i < count; ++i) {
            const double* p = points + 3 * i;
            const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
            const bool spoilt = self.spoils(p);
            value[i] = (spoilt ? self.value_factor : 1.0) * (r - 1.0);
            for (int c = 0; gradient != nullptr && c < 3; ++c)
                gradient[3 * i + c] = (spoilt ? self.factor : 1.0) * p[c] / r;
        }
        return 0;
    }
};

// A model in the box from (low, low, low) to (high, high, high).
Model model_in_box(const Context& context, Steep& steep, double low, double high) {
    Error error;
    auto desc = made(hrbfnpr_custom_desc_init);
    desc.flags = HRBFNPR_CUSTOM_HAS_GRADIENT;
    desc.function = Steep::call;
    desc.user = &steep;
    for (int axis = 0; axis < 3; ++axis) {
        desc.bounds_min[axis] = low;
        desc.bounds_max[axis] = high;
    }
    hrbfnpr_model* model = nullptr;
    EXPECT_OK(hrbfnpr_model_create_custom(context.get(), &desc, &model, error));
    return Model(model);
}

Model model_of(const Context& context, Steep& steep, double half = 1.1) {
    return model_in_box(context, steep, -half, half);
}

hrbfnpr_status generated(const Context& context, const Model& model, Generation desc, Error& error, PointSet& set,
                         hrbfnpr_operation* operation = nullptr) {
    hrbfnpr_point_set* made_set = nullptr;
    const hrbfnpr_status status =
        hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), operation, &made_set, error);
    set.reset(made_set);
    return status;
}

struct KindAndGuide {
    std::uint32_t kind, guide;
};
constexpr KindAndGuide kinds[] = {{HRBFNPR_LAYER_KIND_STIPPLES, HRBFNPR_HATCH_GUIDE_CURVATURE},
                                  {HRBFNPR_LAYER_KIND_HATCH, HRBFNPR_HATCH_GUIDE_CURVATURE},
                                  {HRBFNPR_LAYER_KIND_HATCH, HRBFNPR_HATCH_GUIDE_COMBING}};

Generation layer_of(const KindAndGuide& what, std::int64_t budget) {
    Generation desc = one_layer(what.kind, budget);
    desc.layer[0].guide = what.guide;
    return desc;
}

// Absolute positions, packed.
std::vector<double> places(const PointSet& set) {
    Error error;
    auto info = made(hrbfnpr_point_set_info_init);
    EXPECT_OK(hrbfnpr_point_set_get_info(set.get(), &info, error));
    std::vector<double> result;
    for (const float coordinate : attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_POSITION))
        result.push_back(double{coordinate} + info.origin[result.size() % 3]);
    return result;
}

bool on_the_right(const double* p) { return p[0] > 0.3; }

// If all gradients are spoilt, no seed arrives. If a part is spoilt, no mark lies there, and dropped seeds are counted.
TEST(Hostile, InvalidGradientsAreDegenerate) {
    const Context context = make_context(1);
    for (const double factor : {infinity, std::nan(""), 1e300}) {
        Steep steep{factor};
        const Model model = model_of(context, steep);
        Error error;
        PointSet set;
        EXPECT_FAILS(generated(context, model, one_layer(HRBFNPR_LAYER_KIND_STIPPLES, 500), error, set),
                     HRBFNPR_STATUS_NOT_CONVERGED, "degenerate");
        EXPECT_LT(steep.calls, 1000);
        steep.spoils = on_the_right;
        for (const KindAndGuide& kind : kinds) {
            SCOPED_TRACE(testing::Message() << factor << ", kind " << kind.kind << ", guide " << kind.guide);
            ASSERT_OK(generated(context, model, layer_of(kind, 500), error, set));
            const std::vector<double> position = places(set);
            auto seeds = made(hrbfnpr_placement_info_init);
            ASSERT_OK(hrbfnpr_point_set_get_seed_placement(set.get(), &seeds, error));
            EXPECT_GT(position.size(), 3 * 200U);
            EXPECT_GT(seeds.dropped_degenerate, 0);
            for (std::size_t i = 0; i < position.size(); i += 3)
                EXPECT_LT(position[i], 0.31) << "a mark where there is no gradient";
        }
    }
}

TEST(Hostile, InvalidValuesGiveNoSeeds) {
    const Context context = make_context(1);
    for (const double factor : {infinity, std::nan(""), 1e308}) {
        Steep steep;
        steep.value_factor = factor;
        const Model model = model_of(context, steep);
        Error error;
        PointSet set;
        EXPECT_FAILS(generated(context, model, one_layer(HRBFNPR_LAYER_KIND_STIPPLES, 500), error, set),
                     HRBFNPR_STATUS_NOT_CONVERGED, "seeds");
        EXPECT_LT(steep.calls, 4000);
    }
}

// A projection onto such a function reports that it is not finite.
TEST(Hostile, ProjectionsAreNotConverged) {
    const Context context = make_context(1);
    for (const double factor : {infinity, 1e300}) {
        Steep steep{factor};
        Error error;
        std::vector<double> point{0.5, 0.1, 0.2};
        std::vector<std::uint8_t> status(1);
        const hrbfnpr_array points = in(point);
        auto projection = made(hrbfnpr_projection_init);
        projection.status = out(status, 1);
        ASSERT_OK(hrbfnpr_model_project(model_of(context, steep).get(), &points, nullptr, &projection, nullptr, error));
        EXPECT_EQ(status[0], HRBFNPR_PROJECTION_NOT_FINITE) << factor;
    }
}

// ---- boxes ---------------------------------------------------------------------------------

TEST(Hostile, ABoxThatIsTooWideIsRefusedOrServed) {
    const Context context = make_context(1);
    for (const KindAndGuide& kind : kinds)
        for (const double half : {100.0, 1e6, 1e12}) {
            SCOPED_TRACE(testing::Message() << "kind " << kind.kind << ", guide " << kind.guide << ", box " << half);
            Steep steep;
            const Model model = model_of(context, steep, half);
            Error error;
            PointSet set;
            const hrbfnpr_status status = generated(context, model, layer_of(kind, 500), error, set);
            EXPECT_LT(steep.calls, 10000);
            if (half > 100.0) {
                EXPECT_EQ(status, HRBFNPR_STATUS_INVALID_ARGUMENT);
                EXPECT_NE(std::string(error.record.message).find("bounds"), std::string::npos) << error.record.message;
                continue;
            }
            ASSERT_OK(status);
            EXPECT_GT(attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_RANK).size(), 340U);
            const std::vector<double> position = places(set);
            for (std::size_t i = 0; i < position.size(); i += 3)
                EXPECT_NEAR(std::hypot(position[i], position[i + 1], position[i + 2]), 1.0, 1e-3);
        }
}

TEST(Hostile, ABoxThatMissesTheSurfaceGivesNoSeeds) {
    const Context context = make_context(1);
    Error error;
    Steep steep;
    const Model model = model_in_box(context, steep, 100.0, 101.0);
    PointSet set;
    EXPECT_FAILS(generated(context, model, one_layer(HRBFNPR_LAYER_KIND_STIPPLES, 500), error, set),
                 HRBFNPR_STATUS_NOT_CONVERGED, "seeds");
}

// ---- budgets -------------------------------------------------------------------------------

TEST(Hostile, ABudgetThatIsTooLargeIsRefusedBeforeAnyWork) {
    const Context context = make_context(1);
    for (const KindAndGuide& kind : kinds)
        for (const std::int64_t budget : {std::int64_t{2000000000}, std::int64_t{1} << 40U, std::int64_t{1} << 62U}) {
            Steep steep;
            Error error;
            PointSet set;
            EXPECT_FAILS(generated(context, model_of(context, steep), layer_of(kind, budget), error, set),
                         HRBFNPR_STATUS_INVALID_ARGUMENT, "100000000");
            EXPECT_EQ(steep.calls, 0);
        }
    Steep steep;
    Error error;
    PointSet set;
    Generation desc;
    desc.shared_budget = 2000000000;
    EXPECT_FAILS(generated(context, model_of(context, steep), desc, error, set), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "100000000");
    EXPECT_EQ(steep.calls, 0);
}

// ---- densities -----------------------------------------------------------------------------

std::int32_t constant(void* user, std::int64_t count, const double* /*positions*/, const double* /*normals*/,
                      double* density) {
    std::fill_n(density, count, *static_cast<double*>(user));
    return 0;
}

hrbfnpr_status with_density(double density, PointSet& set, Error& error) {
    const Context context = make_context(1);
    Steep steep;
    Generation desc = one_layer(HRBFNPR_LAYER_KIND_STIPPLES, 500);
    desc.layer[0].density = HRBFNPR_DENSITY_CALLBACK;
    desc.layer[0].density_function = constant;
    desc.layer[0].density_user = &density;
    return generated(context, model_of(context, steep), desc, error, set);
}

TEST(Hostile, ADensityIsRelativeToOne) {
    PointSet set;
    for (const double density : {1.0, 1e300, infinity}) {
        Error error;
        ASSERT_OK(with_density(density, set, error));
        EXPECT_GT(attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_RANK).size(), 490U) << density;
    }
    for (const double density : {1e-300, 1e-6, std::numeric_limits<double>::denorm_min()}) {
        Error error;
        EXPECT_FAILS(with_density(density, set, error), HRBFNPR_STATUS_INVALID_ARGUMENT, "density");
        EXPECT_NE(std::string(error.record.message).find("1 where marks are densest"), std::string::npos);
    }
    for (const double density : {std::nan(""), -1e-300, -infinity}) {
        Error error;
        EXPECT_FAILS(with_density(density, set, error), HRBFNPR_STATUS_CALLBACK, "density_function");
    }
}

// ---- lengths -------------------------------------------------------------------------------

TEST(Hostile, ExtremeLengthsAreServedOrRefused) {
    const Context context = make_context(1);
    for (const double length : {1e-300, 1e-13, 1e-2, 1e6, 1e12, 1e300})
        for (const std::uint32_t field : {0U, 1U}) {
            SCOPED_TRACE(testing::Message() << length << ", field " << field);
            Steep steep;
            Generation desc = one_layer(HRBFNPR_LAYER_KIND_HATCH, 300);
            hrbfnpr_layer_desc& layer = desc.layer[0];
            (field == 0 ? layer.separation : layer.step) = length;
            Error error;
            PointSet set;
            const hrbfnpr_status status = generated(context, model_of(context, steep), desc, error, set);
            EXPECT_LT(steep.calls, 10000);
            if (status == HRBFNPR_STATUS_OK) {
                EXPECT_FALSE(attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_POSITION).empty());
                for (const float x : attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_POSITION))
                    ASSERT_LT(std::abs(x), 1.2F);
            } else {
                EXPECT_TRUE(status == HRBFNPR_STATUS_INVALID_ARGUMENT || status == HRBFNPR_STATUS_NOT_CONVERGED);
                const std::string message = error.record.message;
                EXPECT_TRUE(message.find("separation") != std::string::npos ||
                            message.find("step") != std::string::npos)
                    << message;
            }
        }
}

} // namespace
} // namespace api_test::hostile_test
