// SPDX-License-Identifier: MIT
// Tests files that are truncated, flipped, hostile or from the future.
#include "samples.h"

#include <gtest/gtest.h>

namespace hrbfnpr::io::damage_test {
namespace {

using namespace samples;

class Damage : public testing::TestWithParam<Sample> {
protected:
    [[nodiscard]] Bytes bytes(std::int64_t count = 2) const { return bytes_of(GetParam(), count); }
    Outcome load(const Bytes& bytes) { return samples::load(memory, bytes, is_model()); }
    static bool is_model() { return GetParam() != Sample::point_set && GetParam() != Sample::painted_set; }

    static bool is_csg() { return GetParam() == Sample::csg_model; }
    static int numbers() { return is_csg() ? 6 : 12; } // in the second section

    // Returns the offset of the n-th section's header.
    static std::size_t section(const Bytes& bytes, int n) {
        constexpr std::size_t sizes[] = {0, 4, 8, 1, 4, 8};
        std::size_t at = header_size;
        for (; n > 0; --n)
            at += section_header_size +
                  fetch<std::uint64_t>(&bytes[at + 8]) * sizes[fetch<std::uint32_t>(&bytes[at + 4])];
        return at;
    }

    base::Memory memory;
};

TEST_P(Damage, TruncationAtAnyLengthIsDetected) {
    const Bytes whole = bytes();
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const Outcome outcome = load(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)));
        ASSERT_EQ(outcome.status, Status::corrupt_data) << length;
        ASSERT_NE(outcome.message.find("truncated: it ends after " + std::to_string(length) + " bytes"),
                  std::string::npos)
            << length << ": " << outcome.message;
    }
}

TEST_P(Damage, EverySingleBitFlipIsDetected) {
    Bytes damaged = bytes();
    for (std::size_t bit = 0; bit < 8 * damaged.size(); ++bit) {
        const auto mask = static_cast<std::uint8_t>(1U << (bit % 8));
        damaged[bit / 8] ^= mask;
        const Outcome outcome = load(damaged);
        ASSERT_EQ(outcome.status, Status::corrupt_data) << "bit " << bit << ": " << outcome.message;
        damaged[bit / 8] ^= mask;
    }
    EXPECT_EQ(load(damaged).status, Status::ok);
}

TEST_P(Damage, NewerVersionsAreNamed) {
    Bytes newer = bytes();
    const std::uint32_t newest = is_model() ? model_version : point_set_version;
    store(&newer[12], newest + 1);
    sign(newer);
    const Outcome outcome = load(newer);
    EXPECT_EQ(outcome.status, Status::version_mismatch);
    EXPECT_NE(outcome.message.find("has format version " + std::to_string(newest + 1) +
                                   ", but this library reads versions up to " + std::to_string(newest)),
              std::string::npos)
        << outcome.message;
}

TEST_P(Damage, HeaderFieldsAreChecked) {
    const auto changed = [&](std::size_t at, std::uint32_t value) {
        Bytes other = bytes();
        store(&other[at], value);
        sign(other);
        return load(other);
    };
    EXPECT_NE(changed(8, tag("WHAT")).message.find("its kind is 'WHAT'"), std::string::npos);
    EXPECT_NE(changed(12, 0).message.find("version is 0"), std::string::npos);
    EXPECT_NE(changed(16, 0x04030201).message.find("byte order"), std::string::npos);
    EXPECT_NE(changed(0, 0x46464952).message.find("not a"), std::string::npos);
}

TEST_P(Damage, AFileOfAnotherKindIsNamed) {
    const Bytes other = is_model() ? point_set_bytes() : model_bytes();
    const Outcome outcome = load(other);
    EXPECT_EQ(outcome.status, Status::corrupt_data);
    EXPECT_NE(outcome.message.find(is_model() ? "'PSET'" : "'MODL'"), std::string::npos) << outcome.message;
}

TEST_P(Damage, HostileLengthsAllocateNothing) {
    for (int n = 0; n < 5; ++n) {
        Bytes hostile = bytes();
        store(&hostile[24], std::uint64_t{1} << 60U); // length of the payload
        store(&hostile[section(hostile, n) + 8], std::uint64_t{1} << 50U);
        sign(hostile);
        EXPECT_EQ(load(hostile).status, Status::corrupt_data) << n;
    }
    EXPECT_LT(memory.bytes_peak(), 1 << 20);
    EXPECT_EQ(memory.bytes_now(), 0);
}

TEST_P(Damage, SectionsAreChecked) {
    const auto changed = [&](std::size_t offset, auto value) {
        Bytes other = bytes();
        store(&other[section(other, 1) + offset], value);
        sign(other);
        return load(other).message;
    };
    const std::string name = is_csg() ? "CBOX" : "NUMB";
    EXPECT_NE(changed(0, tag("ABCD")).find("section 'ABCD' is where section '" + name + "' should be"),
              std::string::npos);
    EXPECT_NE(changed(4, std::uint32_t{1}).find("wrong type"), std::string::npos);
    EXPECT_NE(changed(8, std::uint64_t{11}).find("has 11 elements instead of " + std::to_string(numbers())),
              std::string::npos);
    EXPECT_NE(changed(8, std::uint64_t{1000000}).find("longer than the rest of the file"), std::string::npos);
}

TEST_P(Damage, BytesAfterTheLastSectionAreFound) {
    Bytes longer = bytes();
    longer.insert(longer.end(), 8, std::uint8_t{0});
    store(&longer[24], fetch<std::uint64_t>(&longer[24]) + 8);
    sign(longer);
    EXPECT_NE(load(longer).message.find("8 bytes follow"), std::string::npos);
}

TEST_P(Damage, NumbersAreChecked) {
    for (int at = 0; at < numbers(); ++at) {
        Bytes other = bytes();
        store(&other[section(other, 1) + section_header_size + 8 * static_cast<std::size_t>(at)],
              std::numeric_limits<double>::quiet_NaN());
        sign(other);
        EXPECT_EQ(load(other).status, Status::corrupt_data) << at;
    }
}

INSTANTIATE_TEST_SUITE_P(Files, Damage, testing::ValuesIn(all_samples),
                         [](const auto& kind) { return name_of(kind.param); });

// Saves changed data, so that the damage has right checksums.
template <class Change>
std::string model_message(Change&& change) {
    base::Memory memory;
    implicit::HrbfData data = model(memory, 3, kernel::Kind::gaussian);
    change(data);
    const Outcome outcome = load(memory, bytes_of(data), true);
    EXPECT_TRUE(outcome.status == Status::corrupt_data || outcome.message.empty());
    return outcome.message;
}

TEST(ModelFile, ContentIsChecked) {
    using Data = implicit::HrbfData;
    const auto expect = [](const std::string& message, const char* part) {
        EXPECT_NE(message.find(part), std::string::npos) << message;
    };
    EXPECT_EQ(model_message([](Data&) {}), "");
    expect(model_message([](Data& d) { d.alpha[2] = NAN; }), "alpha[2] is not finite");
    expect(model_message([](Data& d) { d.beta.z[1] = INFINITY; }), "beta.z[1]");
    expect(model_message([](Data& d) { d.centre_position.x[0] = NAN; }), "centre.x[0]");
    expect(model_message([](Data& d) { d.polynomial[3] = NAN; }), "polynomial[3]");
    expect(model_message([](Data& d) { d.sample_position[4] = NAN; }), "sample_position[4]");
    expect(model_message([](Data& d) { d.sample_normal[0] = 2.0; }), "sample_normal[0] is not of unit length");
    expect(model_message([](Data& d) { d.scale = 0.0; }), "scale is not positive");
    expect(model_message([](Data& d) { d.kernel_radius = 0.0; }), "kernel radius");
    expect(model_message([](Data& d) { d.spacing = -1.0; }), "spacing is negative");
    expect(model_message([](Data& d) { d.bounds.max.y = -9.0; }), "not a box");
    expect(model_message([](Data& d) { d.kernel = static_cast<kernel::Kind>(3); }), "kernel is unknown");
    expect(model_message([](Data& d) { d.polynomial_degree = 4; }), "degree is unknown");
    expect(model_message([](Data& d) { d.polynomial_degree = 2; }), "has 4 elements instead of 10");
    expect(model_message([](Data& d) { d.alpha.push_back(0.0); }), "'ALPH' has 4 elements instead of 3");
    expect(model_message([](Data& d) { d.sample_position.push_back(0.0); }), "number of samples is wrong");
    expect(model_message([](Data& d) { d.sample_position.clear(); }), "number of samples is wrong");
}

// No fit makes such values from samples that it accepts.
TEST(ModelFile, PlacesAndScalesThatNoFitMakesAreRefused) {
    using Data = implicit::HrbfData;
    const auto expect = [](const std::string& message, const char* part) {
        EXPECT_NE(message.find(part), std::string::npos) << message;
    };
    expect(model_message([](Data& d) { d.sample_position[4] = 1e101; }), "sample_position[1] is outside its bounds");
    expect(model_message([](Data& d) { d.sample_position[0] = -50.0; }), "sample_position[0] is outside its bounds");
    // This sample is within the search box: a fit to a mesh may be held there.
    const auto held_off = [](Data& d) { d.sample_position[0] = d.bounds.min.x - 0.05 * d.bounds.diagonal(); };
    expect(model_message(held_off), "centre[0] is not at its sample");
    expect(model_message([](Data& d) { d.bounds.max.x = 1e101; }), "reach beyond 1e100");
    expect(model_message([](Data& d) { d.bounds.min.z = -1e308; }), "reach beyond 1e100");
    expect(model_message([](Data& d) { d.centre.y = 1e50; }), "centre is outside its bounds");
    expect(model_message([](Data& d) { d.centre.y = -1.0; }), "centre[0] is not at its sample");
    expect(model_message([](Data& d) { d.centre_position.z[2] += 0.125; }), "centre[2] is not at its sample");
    expect(model_message([](Data& d) { d.centre_position.x[1] = 1e300; }), "centre[1] is not at its sample");
    expect(model_message([](Data& d) { d.scale = 1e-300; }), "scale does not fit its bounds");
    expect(model_message([](Data& d) { d.scale = 1e10; }), "scale does not fit its bounds");
    expect(model_message([](Data& d) { d.spacing = 1e10; }), "sample spacing is larger than its bounds");
    expect(model_message([](Data& d) { d.alpha[1] = -1e300; }), "alpha[1] is too large for a fit");
    expect(model_message([](Data& d) { d.beta.y[2] = 1e121; }), "beta.y[2] is too large for a fit");
    expect(model_message([](Data& d) { d.polynomial[0] = 1e150; }), "polynomial[0] is too large for a fit");
    expect(model_message([](Data& d) { d.kernel_radius = 1e-31; }), "kernel radius is out of range");
    expect(model_message([](Data& d) { d.kernel_radius = 1e31; }), "kernel radius is out of range");
    const auto single = [](Data& d) { // its scale would be 1; this file has 0.25
        d.sample_position.resize(3);
        d.sample_normal.resize(3);
        d.centre_position.resize(1);
        d.alpha.resize(1);
        d.beta.resize(1);
    };
    expect(model_message(single), "scale does not fit its bounds");
    const auto shrink = [](Data& d) {
        d.bounds.min = d.centre = d.bounds.max = {1e-300, 0.0, 0.0};
        d.bounds.max.x = 2e-300;
    };
    expect(model_message(shrink), "bounds are smaller than 1e-110");
}

using Set = marks::PointSet;

template <class Change>
std::string set_message(Change&& change) {
    base::Memory memory;
    marks::PointSet set = point_set(memory, 3);
    change(set);
    return load(memory, bytes_of(set), false).message;
}

TEST(PointSetFile, ContentIsChecked) {
    const auto expect = [](const std::string& message, const char* part) {
        EXPECT_NE(message.find(part), std::string::npos) << message;
    };
    EXPECT_EQ(set_message([](Set&) {}), "");
    expect(set_message([](Set& s) { s.layers[0].rank[1] = 1.0F; }), "rank is outside");
    expect(set_message([](Set& s) { s.layers[1].rank[0] = NAN; }), "rank is outside");
    expect(set_message([](Set& s) { s.layers[0].position[5] = INFINITY; }), "position[5]");
    expect(set_message([](Set& s) { s.layers[0].normal[3] = 0.5F; }), "normal[1] is not of unit length");
    expect(set_message([](Set& s) { s.layers[1].direction[0] = NAN; }), "direction[0]");
    expect(set_message([](Set& s) { s.layers[1].curvature[0] = NAN; }), "curvature[0]");
    expect(set_message([](Set& s) { s.layers[1].curvature.push_back(0); }), "one curvature for each");
    expect(set_message([](Set& s) { s.layers[1].width.push_back(1); }), "one width for each");
    const auto widths = [](Set& s, float odd) {
        for (const float width : {0.5F, odd, 1.0F}) s.layers[1].width.push_back(width);
    };
    expect(set_message([&](Set& s) { widths(s, 0.0F); }), "width is outside");
    expect(set_message([&](Set& s) { widths(s, 1.5F); }), "width is outside");
    expect(set_message([&](Set& s) { widths(s, NAN); }), "width is outside");
    expect(set_message([](Set& s) { s.layers[0].stroke.push_back(0); }), "'STRK' has 7 elements instead of 6");
    expect(set_message([](Set& s) { s.layers[2].report.levels = 256; }), "a count of a layer is out of range");
    expect(set_message([](Set& s) { s.layers[2].report.full_count = -1; }), "a count of a layer is out of range");
    expect(set_message([](Set& s) { s.layers[2].report.level[3].placed = -1; }), "negative");
    expect(set_message([](Set& s) { (void)s.layers[2].report.of(256); }), "at most 256");
    for (const std::uint32_t kind : {0U, 7U})
        expect(set_message([&](Set& s) { s.layers[1].kind = static_cast<marks::Kind>(kind); }), "kind of a layer");
    expect(set_message([](Set& s) { s.layers[1].name = {}; }), "1 to 63 bytes of UTF-8");
    expect(set_message([](Set& s) { s.layers[1].name = {'a', char(0xFF)}; }), "1 to 63 bytes of UTF-8");
    expect(set_message([](Set& s) { s.layers[2].report.step = NAN; }), "not finite");
    expect(set_message([](Set& s) { s.seeds.placed = -1; }), "negative");
    expect(set_message([](Set& s) { s.spacing = -1.0; }), "spacing is negative");
    expect(set_message([](Set& s) { s.bounds = {}; }), "not a box");
    expect(set_message([](Set& s) { s.distribution = static_cast<marks::Distribution>(2); }), "distribution");
    expect(set_message([](Set& s) { s.seed_source = static_cast<marks::SeedSource>(9); }), "seed source");
    expect(set_message([](Set& s) { s.layers[1].direction[1] = 1.5F; }), "direction[0] is longer than a unit vector");
    expect(set_message([](Set& s) { s.layers[1].tone_normal.resize(3); }), "one normal for tone for each");
    expect(set_message([](Set& s) { s.layers[1].tone_normal.resize(9); }), "normal for tone");
    expect(set_message([](Set& s) { s.layers[0].report.step = -0.5; }), "step or time of a layer is negative");
    expect(set_message([](Set& s) { s.layers[0].report.seconds = -0.5; }), "step or time of a layer is negative");
    expect(set_message([](Set& s) { s.seconds_total = -0.5; }), "one of its times is negative");
}

TEST(PointSetFile, FieldsAreChecked) {
    using Fields = base::List<marks::MarkField>;
    const auto expect = [](auto&& change, const char* part) {
        const std::string message = set_message([&](Set& s) {
            s = with_fields(std::move(s));
            change(s.layers[1].fields);
        });
        EXPECT_NE(message.find(part), std::string::npos) << message;
    };
    expect([](Fields& f) { f[0].value.push_back(0.0F); }, "'FVAL' has 10 elements instead of 9");
    expect([](Fields& f) { f[0].value[2] = NAN; }, "value of a field");
    expect([](Fields& f) { f[1].weight[2] = 1.5F; }, "weight of a field is outside [0, 1]");
    expect([](Fields& f) { f[1].weight[2] = NAN; }, "weight of a field is outside [0, 1]");
    expect([](Fields& f) { f[1].weight.resize(2); }, "one weight for each mark");
    expect([](Fields& f) { f[1].name = f[0].name; }, "the same name");
    expect([](Fields& f) { f[1].name = {}; }, "name of a field is not 1 to 63 bytes of UTF-8");
    expect([](Fields& f) { f[0].kind = static_cast<marks::FieldKind>(3); }, "kind of a field is unknown");
    expect([](Fields& f) { f[0].kind = marks::FieldKind::direction; }, "different kinds in two layers");
    const auto add = [](Fields& f, int count) {
        for (int i = 0; i < count; ++i) {
            f.add(f.memory()).name = {static_cast<char>('0' + i / 10), static_cast<char>('0' + i % 10)};
            for (int mark = 0; mark < 3; ++mark) f.back().value.push_back(1.0F);
        }
    };
    expect([&](Fields& f) { add(f, 63); }, "a layer has 65 fields, too many");
}

// All readers of a set trust the order of its strokes.
TEST(PointSetFile, StrokesAreChecked) {
    const auto expect = [](auto&& change, const char* part) {
        const std::string message = set_message([&](Set& s) { change(s.layers[1]); });
        EXPECT_NE(message.find(part), std::string::npos) << message;
    };
    using Layer = marks::Layer; // first: 0 2 3, order: 0 2 1
    expect([](Layer& l) { l.stroke_first[0] = 1; }, "do not increase from 0");
    expect([](Layer& l) { l.stroke_first[1] = 3; }, "do not increase from 0");
    expect([](Layer& l) { l.stroke_first[2] = 4; }, "do not increase from 0");
    expect([](Layer& l) { l.stroke_first.resize(1); }, "do not increase from 0");
    expect([](Layer& l) { l.stroke_first.clear(); }, "an order of strokes, but no strokes");
    expect([](Layer& l) { l.stroke_order.resize(2); }, "one element for each mark");
    expect([](Layer& l) { l.stroke_order[1] = 3; }, "twice, or one that does not exist");
    expect([](Layer& l) { l.stroke_order[1] = 0; }, "twice, or one that does not exist");
    expect([](Layer& l) { l.stroke[2] = 0; }, "in the order of their numbers");
    expect([](Layer& l) { l.stroke_order.clear(); }, "different numbers");
}

// A wrong number of layers allocates nothing before the layers are read.
TEST(PointSetFile, LayersAreCounted) {
    base::Memory memory;
    Bytes bytes = point_set_bytes(3);
    const std::size_t layers = header_size + section_header_size + 8;
    for (const std::uint32_t wrong : {2U, 4U, 65536U, 65537U, 0xFFFFFFFFU}) {
        store(&bytes[layers], wrong);
        sign(bytes);
        const Outcome outcome = load(memory, bytes, false);
        EXPECT_EQ(outcome.status, Status::corrupt_data) << outcome.message;
    }
    EXPECT_LT(memory.bytes_peak(), 65536);
}

// Positions are relative to the middle of a box that has all marks inside.
TEST(PointSetFile, MarksLieInTheirBox) {
    const auto expect = [](const std::string& message, const char* part) {
        EXPECT_NE(message.find(part), std::string::npos) << message;
    };
    expect(set_message([](Set& s) { s.layers[0].position[5] = 1.25F; }), "position[1] is outside its bounds");
    expect(set_message([](Set& s) { s.layers[1].position[0] = -3e38F; }), "position[0] is outside its bounds");
    expect(set_message([](Set& s) { s.origin.x = 1e300; }), "position[0] is outside its bounds");
    expect(set_message([](Set& s) { s.bounds.max.y = 1e39; }), "too large for floats");
    expect(set_message([](Set& s) { s.bounds = {glm::dvec3(-1.7e308), glm::dvec3(1.7e308)}; }), "too large for floats");
    EXPECT_EQ(set_message([](Set& s) { s.bounds.max.y = 1e38; }), "");
}

TEST(PointSetFile, DistantMarksAreRoundedIntoTheirBox) {
    for (const double origin : {0.0, 1.0, -1e9, 3e38, 1e99})
        for (const double half : {0.0, 1e-44, 1.0, 1e30, 3.4e38}) {
            const auto far = [&](Set& s) {
                s.origin = glm::dvec3(origin);
                s.bounds = {glm::dvec3(origin - half), glm::dvec3(origin + half)};
                for (marks::Layer& layer : s.layers)
                    for (float& position : layer.position)
                        position = static_cast<float>((position < 0.0F ? s.bounds.min.x : s.bounds.max.x) - origin);
            };
            EXPECT_EQ(set_message(far), "") << origin << " " << half;
        }
}

TEST(PointSetFile, ASetWithoutMarksMayNotHaveBounds) {
    const auto message = [](auto&& change) {
        base::Memory memory;
        marks::PointSet set(memory);
        change(set);
        return load(memory, bytes_of(set), false).message;
    };
    EXPECT_EQ(message([](Set&) {}), "");
    // Sets without marks were once saved like this.
    EXPECT_EQ(message([](Set& s) {
                  s.origin = glm::dvec3(NAN);
                  s.spacing = INFINITY;
              }),
              "");
    for (const double number : {0.0, 1.0, static_cast<double>(NAN)}) {
        const std::string said = message([&](Set& s) { s.bounds.min.x = number; });
        EXPECT_NE(said.find("bounds, but no marks"), std::string::npos) << number << ": " << said;
    }
}

} // namespace
} // namespace hrbfnpr::io::damage_test
