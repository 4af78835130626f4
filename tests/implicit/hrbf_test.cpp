// SPDX-License-Identifier: MIT
#include "fields.h"

#include "kernel/polynomial.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hrbf_test {

namespace implicit = hrbfnpr::implicit;
namespace kernel = hrbfnpr::kernel;
using hrbfnpr::base::Memory;
using test::Fields;
using test::hessian_index;
using test::Points;
using test::scatter;

namespace {

const kernel::Kind kinds[] = {kernel::Kind::triharmonic, kernel::Kind::gaussian, kernel::Kind::wendland_c2};

implicit::HrbfData make(Memory& memory, kernel::Kind kind, int centres, std::int32_t degree) {
    implicit::HrbfData data(memory);
    data.kernel = kind;
    data.kernel_radius = kind == kernel::Kind::gaussian ? 0.8 : 2.5;
    data.polynomial_degree = degree;
    data.centre = {3.0, -2.0, 1.0};
    data.scale = 0.25;
    data.bounds.min = data.centre - 0.25;
    data.bounds.max = data.centre + 0.25;
    for (int j = 0; j < centres; ++j) {
        data.centre_position.push_back({scatter(7 * j), scatter(7 * j + 1), scatter(7 * j + 2)});
        data.beta.push_back({scatter(7 * j + 3), scatter(7 * j + 4), scatter(7 * j + 5)});
        data.alpha.push_back(scatter(7 * j + 6));
    }
    for (int k = 0; k < kernel::polynomial_size(degree); ++k) data.polynomial.push_back(scatter(1000 + k));
    return data;
}

Points queries(int count) {
    Points points;
    for (int i = 0; i < count; ++i)
        points.add(
            {3.0 + 0.4 * scatter(5000 + 3 * i), -2.0 + 0.4 * scatter(5001 + 3 * i), 1.0 + 0.4 * scatter(5002 + 3 * i)});
    return points;
}

// Evaluates equation 1 of the article term by term.
double plain_value(const implicit::HrbfData& data, const glm::dvec3& x) {
    const glm::dvec3 y = (x - data.centre) / data.scale;
    double g = kernel::polynomial(data.polynomial_degree, data.polynomial.data(), y).value;
    for (std::int64_t j = 0; j < data.count(); ++j) {
        const glm::dvec3 d = y - data.centre_position[j];
        const kernel::Radial k = kernel::radial(data.kernel, data.kernel_radius, glm::length(d));
        g += data.alpha[j] * k.phi - glm::dot(data.beta[j], k.a * d);
    }
    return data.scale * g;
}

template <class F>
double difference(F&& f, double h) {
    return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h);
}

glm::dvec3 axis(glm::length_t a) {
    glm::dvec3 e{0.0};
    e[a] = 1.0;
    return e;
}

TEST(Hrbf, ValueFollowsTheDefinition) {
    Memory memory;
    for (const kernel::Kind kind : kinds) {
        for (std::int32_t degree = -1; degree <= 3; ++degree) {
            const implicit::Hrbf hrbf(hrbfnpr::base::choose_instruction_set(hrbfnpr::base::InstructionSet::automatic),
                                      make(memory, kind, 37, degree));
            const Points points = queries(70);
            Fields fields(points.size());
            hrbf.evaluate(points.batch(), fields.batch(true, false, false));
            for (std::size_t i = 0; i < points.size(); ++i)
                EXPECT_NEAR(fields.value[i], plain_value(hrbf.data(), points[i]), 1e-12)
                    << kernel::name(kind) << degree;
            EXPECT_EQ(fields.gradient[0][0], -7.0); // the gradient was not requested and is untouched
            EXPECT_EQ(fields.hessian[5][0], -7.0);
        }
    }
}

TEST(Hrbf, GradientAndHessianAreDerivatives) {
    Memory memory;
    for (const kernel::Kind kind : kinds) {
        const implicit::Hrbf hrbf(hrbfnpr::base::choose_instruction_set(hrbfnpr::base::InstructionSet::automatic),
                                  make(memory, kind, 11, 2));
        const Points points = queries(20);
        Fields fields(points.size());
        hrbf.evaluate(points.batch(), fields.all());
        const double h = 1e-4;
        for (std::size_t i = 0; i < points.size(); ++i) {
            for (glm::length_t a = 0; a < 3; ++a) {
                const auto value = [&](double t) { return plain_value(hrbf.data(), points[i] + t * axis(a)); };
                EXPECT_NEAR(fields.gradient[static_cast<std::size_t>(a)][i], difference(value, h), 1e-6);
                for (glm::length_t b = 0; b < 3; ++b) {
                    const auto slope = [&](double t) {
                        Points moved;
                        moved.add(points[i] + t * axis(a));
                        Fields at(1);
                        hrbf.evaluate(moved.batch(), at.batch(false, true, false));
                        return at.gradient[static_cast<std::size_t>(b)][0];
                    };
                    EXPECT_NEAR(fields.hessian[hessian_index[a][b]][i], difference(slope, h), 1e-3)
                        << kernel::name(kind) << " " << a << b;
                }
            }
        }
    }
}

TEST(Hrbf, APointsResultDoesNotDependOnItsBatch) {
    Memory memory;
    for (const kernel::Kind kind : kinds) {
        const implicit::Hrbf hrbf(hrbfnpr::base::choose_instruction_set(hrbfnpr::base::InstructionSet::automatic),
                                  make(memory, kind, 23, 1));
        const Points points = queries(200);
        Fields together(points.size());
        hrbf.evaluate(points.batch(), together.all());
        for (const std::int64_t piece : {1, 3, 64, 65}) {
            Fields apart(points.size());
            for (std::int64_t begin = 0; begin < 200; begin += piece)
                hrbf.evaluate(implicit::slice(points.batch(), begin, std::min<std::int64_t>(200, begin + piece)),
                              apart.all().from(begin));
            EXPECT_EQ(together.value, apart.value);
            EXPECT_EQ(together.gradient, apart.gradient);
            EXPECT_EQ(together.hessian, apart.hessian);
        }
    }
}

TEST(Hrbf, AFieldDoesNotDependOnOtherRequestedFields) {
    Memory memory;
    for (const kernel::Kind kind : kinds) {
        const implicit::Hrbf hrbf(hrbfnpr::base::choose_instruction_set(hrbfnpr::base::InstructionSet::automatic),
                                  make(memory, kind, 23, 1));
        const Points points = queries(66);
        Fields all(points.size());
        hrbf.evaluate(points.batch(), all.all());
        Fields value(points.size());
        hrbf.evaluate(points.batch(), value.batch(true, false, false));
        EXPECT_EQ(all.value, value.value);
        Fields gradient(points.size());
        hrbf.evaluate(points.batch(), gradient.batch(false, true, false));
        EXPECT_EQ(all.gradient, gradient.gradient);
        EXPECT_EQ(gradient.value[0], -7.0);
        Fields hessian(points.size());
        hrbf.evaluate(points.batch(), hessian.batch(false, false, true));
        EXPECT_EQ(all.hessian, hessian.hessian);
        EXPECT_EQ(hessian.gradient[0][0], -7.0);
    }
}

TEST(Hrbf, IsDefinedAtASampleAsTheMeanOverAllDirections) {
    Memory memory;
    for (const kernel::Kind kind : kinds) {
        const implicit::Hrbf hrbf(hrbfnpr::base::choose_instruction_set(hrbfnpr::base::InstructionSet::automatic),
                                  make(memory, kind, 9, 1));
        const implicit::HrbfData& data = hrbf.data();
        const glm::dvec3 at = data.centre + data.scale * data.centre_position[4];
        Points points;
        points.add(at);
        for (int i = 0; i < 50; ++i) { // opposite directions cancel the singular term
            const glm::dvec3 d = 1e-7 * glm::dvec3(scatter(3 * i), scatter(3 * i + 1), scatter(3 * i + 2));
            points.add(at + d);
            points.add(at - d);
        }
        Fields fields(points.size());
        hrbf.evaluate(points.batch(), fields.all());
        for (std::size_t c = 0; c < 6; ++c) {
            double mean = 0.0;
            for (std::size_t i = 1; i < points.size(); ++i) mean += fields.hessian[c][i] / 100.0;
            EXPECT_NEAR(fields.hessian[c][0], mean, 1e-4 * (1.0 + std::abs(mean))) << kernel::name(kind) << " " << c;
        }
    }
}

TEST(Hrbf, IsFiniteArbitrarilyCloseToASample) {
    Memory memory;
    implicit::HrbfData data = make(memory, kernel::Kind::triharmonic, 1, 1);
    data.centre = glm::dvec3(0.0);
    data.centre_position.set(0, glm::dvec3(0.0));
    const implicit::Hrbf hrbf(hrbfnpr::base::choose_instruction_set(hrbfnpr::base::InstructionSet::automatic),
                              std::move(data));
    Points points;
    for (const double r : {0.0, 5e-324, 1e-300, 1e-200, 1e-160, 1e-100, 1e-50, 1e-30, 1e-20, 1e-10})
        points.add({r, -r, 0.5 * r});
    Fields fields(points.size());
    hrbf.evaluate(points.batch(), fields.all());
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_TRUE(std::isfinite(fields.value[i])) << i;
        for (const auto& component : fields.gradient) EXPECT_TRUE(std::isfinite(component[i])) << i;
        for (const auto& component : fields.hessian) EXPECT_TRUE(std::isfinite(component[i])) << i;
    }
}

TEST(Hrbf, AcceptsAnEmptyBatchAndReportsItsSize) {
    Memory memory;
    const implicit::Hrbf hrbf(hrbfnpr::base::choose_instruction_set(hrbfnpr::base::InstructionSet::automatic),
                              make(memory, kernel::Kind::gaussian, 5, 1));
    hrbf.evaluate({}, {});
    EXPECT_TRUE(hrbf.concurrent());
    EXPECT_GE(hrbf.data().bytes(), static_cast<std::int64_t>(sizeof(double)) * (7 * 5 + 4));
    EXPECT_NEAR(hrbf.diagonal(), 0.5 * std::sqrt(3.0), 1e-15);
}

} // namespace

} // namespace hrbf_test
