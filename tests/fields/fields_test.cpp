// SPDX-License-Identifier: MIT
// Changes every field of every descriptor, one at a time, to NaN, infinities, the smallest and the largest numbers,
// negative numbers, 0, and values past the end of an enumeration. The result is a picture, or a failure that names the
// field and changes no output.
#include "scene.h"
#include "values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <ostream>
#include <set>
#include <string_view>

namespace fields_test::fields_test {
namespace {

using hrbfnpr::api::FieldLayout;

bool is_about_arguments(hrbfnpr_status status) {
    return status == HRBFNPR_STATUS_INVALID_ARGUMENT || status == HRBFNPR_STATUS_UNSUPPORTED_STRUCT ||
           status == HRBFNPR_STATUS_VERSION_MISMATCH;
}

// Statuses that may result from values that are allowed, but do not suit this scene.
bool may_come(hrbfnpr_status status) {
    return status == HRBFNPR_STATUS_OK || status == HRBFNPR_STATUS_OUT_OF_MEMORY ||
           status == HRBFNPR_STATUS_NOT_CONVERGED || status == HRBFNPR_STATUS_SINGULAR_SYSTEM ||
           status == HRBFNPR_STATUS_CANCELLED || status == HRBFNPR_STATUS_BUFFER_TOO_SMALL ||
           is_about_arguments(status);
}

// Tells whether the message names the field. An older struct lacks fields, so the message names a missing one. If two
// fields must agree, the message names either.
bool names(const std::string& message, const FieldLayout& field, const Change& change) {
    if (message.find(field.name) != std::string::npos) return true;
    if (std::string_view(field.name) == "struct_size")
        return change.value == "8" || change.value == "9" || change.value == "12";
    constexpr std::pair<std::string_view, std::string_view> partners[] = {{"width", "host_depth"},
                                                                          {"height", "host_depth"},
                                                                          {"item_count", "width"},
                                                                          {"flags", "WITH_CURVATURE"},
                                                                          {"visibility", "VISIBILITY_DEPTH_LAYERS"},
                                                                          {"tone_rule", "TONE_RULE_SHARE"},
                                                                          {"layer", "position.count"},
                                                                          {"kind", "levels"},
                                                                          {"kind", "line_first"},
                                                                          {"maximum_hits", "ray_hits.t.components"},
                                                                          {"attribute_count", "attributes"},
                                                                          {"pose_count", "poses"},
                                                                          {"text", "points"},
                                                                          {"kind", "children"},
                                                                          {"kind", "model is NULL"},
                                                                          {"kind", "unbounded along"},
                                                                          {"kind", "second_radius"},
                                                                          {"transform", "bounds_min"},
                                                                          {"radius", "bounds_min"},
                                                                          {"radius", "second_radius"},
                                                                          {"second_radius", "bounds_min"},
                                                                          {"height", "bounds_min"},
                                                                          {"blend", "bounds_min"},
                                                                          {"flags", "would be blank"},
                                                                          {"unit_mm", "view_height"},
                                                                          {"unit_mm", "camera.projection"},
                                                                          {"node_count", "parent"},
                                                                          {"source", "field_desc.function is NULL"},
                                                                          {"source", "field_desc.image is NULL"},
                                                                          {"kind", "field_desc.values.components"},
                                                                          {"kind", "fields[0].values.components"}};
    return std::any_of(std::begin(partners), std::end(partners), [&](const auto& pair) {
        return pair.first == field.name && message.find(pair.second) != std::string::npos;
    });
}

// Tells whether a value must be refused: NaN, and the largest value of enumerations, flags and reserved words.
// Exceptions: nodes of solids have fields that their kind does not use, NaN in pictures means that a value is not
// given, and seeds and arrays without elements may have any numbers.
bool has_to_be_refused(const Slot& slot, const FieldLayout& field, const Change& change) {
    const std::string_view record = slot.record, name = field.name;
    if (record == "hrbfnpr_csg_node" || record == "hrbfnpr_picture_desc" || record == "hrbfnpr_picture_source" ||
        record == "hrbfnpr_change" || name.ends_with("seed") || change.place.ends_with(".components"))
        return false;
    return change.value == "nan" || change.value == "4294967295";
}

Scene& scene() {
    static Scene the_scene;
    return the_scene;
}

struct Place {
    std::size_t index; // in Scene::slots()
};

// The descriptor's name, "item" or "item_2": CTest names a test by it, so lists of tests stay right when one is added.
void PrintTo(Place place, std::ostream* out) { // NOLINT(readability-identifier-naming): GoogleTest's
    const std::vector<Slot> slots = scene().slots();
    const std::string_view record = slots[place.index].record;
    const auto same = std::count_if(slots.begin(), slots.begin() + static_cast<std::ptrdiff_t>(place.index) + 1,
                                    [&](const Slot& slot) { return slot.record == record; });
    *out << record.substr(std::string_view("hrbfnpr_").size());
    if (same > 1) *out << '_' << same;
}

std::vector<Place> places(std::size_t count) {
    std::vector<Place> all(count);
    for (std::size_t i = 0; i < count; ++i) all[i].index = i;
    return all;
}

class Fields : public testing::TestWithParam<Place> {
protected:
    static std::string what(const Slot& slot, const FieldLayout& field, const Change& change) {
        return std::string(slot.record) + "." + field.name + change.place + " = " + change.value;
    }

    void try_change(const Slot& slot, const FieldLayout& field, const Change& change) {
        const std::vector<std::byte> before(slot.data, slot.data + slot.size);
        change.apply(slot.data + field.offset);
        scene().take_time(std::chrono::milliseconds(900));
        const auto start = std::chrono::steady_clock::now();
        const Outcome outcome = (scene().*slot.run)();
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        std::memcpy(slot.data, before.data(), slot.size);
        longest = std::max(longest, seconds);
        ++count;
        refused += outcome.status == HRBFNPR_STATUS_OK ? 0 : 1;
        const std::string name =
            what(slot, field, change) + ": " + hrbfnpr_status_name(outcome.status) + " \"" + outcome.message + "\"";
        if (seconds > 1.0) std::printf("%.2f s: %s\n", seconds, name.c_str());
        EXPECT_TRUE(may_come(outcome.status)) << name;
        EXPECT_TRUE(outcome.clean) << name << " touched its outputs";
        if (outcome.status != HRBFNPR_STATUS_OK) {
            EXPECT_FALSE(outcome.message.empty()) << name;
        }
        if (has_to_be_refused(slot, field, change)) {
            EXPECT_TRUE(is_about_arguments(outcome.status)) << name << " was taken";
        }
        if (is_about_arguments(outcome.status)) {
            EXPECT_TRUE(names(outcome.message, field, change)) << name << " does not name the field";
        }
    }

    double longest = 0.0;
    int count = 0, refused = 0;
};

TEST_P(Fields, AnyValueGivesAPictureOrAFailureThatNamesTheField) {
    const Slot slot = scene().slots()[GetParam().index];
    scene().take_time(Scene::plenty);
    const Outcome untouched = (scene().*slot.run)();
    ASSERT_EQ(untouched.status, HRBFNPR_STATUS_OK) << slot.record << ": " << untouched.message;
    for (const FieldLayout& field : slot.fields)
        for (const Change& change : changes_of(field)) try_change(slot, field, change);
    std::printf("%s: %d changes, %d refused, the longest took %.3f s\n", slot.record, count, refused, longest);
    EXPECT_GT(count, static_cast<int>(slot.fields.size()));
    EXPECT_GT(refused, 0);
}

// The order is that of Scene::slots().
INSTANTIATE_TEST_SUITE_P(OfEveryDescriptor, Fields, testing::ValuesIn(places(58)), testing::PrintToStringParamName());

// Structs that a caller fills in are in the scene; structs that the library fills in are not.
TEST(FieldsOfTheBoundary, IncludeEveryDescriptor) {
    const std::set<std::string> results{"hrbfnpr_error",
                                        "hrbfnpr_array",
                                        "hrbfnpr_array_out",
                                        "hrbfnpr_context_info",
                                        "hrbfnpr_orient_info",
                                        "hrbfnpr_model_info",
                                        "hrbfnpr_trim_info",
                                        "hrbfnpr_point_set_info",
                                        "hrbfnpr_layer_info",
                                        "hrbfnpr_mesh_info",
                                        "hrbfnpr_placement_info",
                                        "hrbfnpr_line_set_info",
                                        "hrbfnpr_drawing_info",
                                        "hrbfnpr_comparison",
                                        "hrbfnpr_mesh_edges_info",
                                        "hrbfnpr_mesh_fit_info",
                                        "hrbfnpr_drawing_layer_info",
                                        "hrbfnpr_mark_identity",
                                        "hrbfnpr_page_info",
                                        "hrbfnpr_csg_info",
                                        "hrbfnpr_depth_image_info",
                                        "hrbfnpr_note",
                                        "hrbfnpr_picture_event",
                                        "hrbfnpr_picture_info",
                                        "hrbfnpr_picture_part",
                                        "hrbfnpr_views_info",
                                        "hrbfnpr_source_info"};
    Scene scene;
    std::set<std::string> tried;
    const std::vector<Slot> slots = scene.slots();
    for (const Slot& slot : slots) tried.insert(slot.record);
    EXPECT_EQ(slots.size(), 58U) << "the range of the tests above";
#define FIELDS_TEST_STRUCT(record)                                                                                     \
    EXPECT_EQ(tried.count(#record) + results.count(#record), 1U) << #record << ": tried, or filled in by the library?";
    HRBFNPR_STRUCTS(FIELDS_TEST_STRUCT)
#undef FIELDS_TEST_STRUCT
}

} // namespace
} // namespace fields_test::fields_test
