// SPDX-License-Identifier: MIT
// Writes pages of drawings as vector files.
#include "output/vector/page.h"
#include "api/barrier.h"
#include "api/drawing.h"
#include "api/fields.h"
#include "api/lists.h"
#include "api/operation.h"
#include "api/streams.h"
#include "api/views.h"
#include "base/utf8.h"

#include <cstdio>

using namespace hrbfnpr;

static_assert(static_cast<int>(output::PageFormat::svg) == HRBFNPR_PAGE_FORMAT_SVG);
static_assert(static_cast<int>(output::PageFormat::pdf) == HRBFNPR_PAGE_FORMAT_PDF);
static_assert(static_cast<int>(output::PageFormat::hpgl) == HRBFNPR_PAGE_FORMAT_HPGL);
static_assert(static_cast<int>(output::PageFormat::gcode) == HRBFNPR_PAGE_FORMAT_GCODE);
static_assert(static_cast<int>(output::PageFormat::dxf) == HRBFNPR_PAGE_FORMAT_DXF);
static_assert(static_cast<int>(output::Curves::arcs) == HRBFNPR_CURVES_ARCS);
static_assert(static_cast<int>(output::Curves::splines) == HRBFNPR_CURVES_SPLINES);
static_assert(static_cast<int>(output::Curves::lines) == HRBFNPR_CURVES_LINES);
static_assert(static_cast<int>(output::Widths::outlines) == HRBFNPR_WIDTHS_OUTLINES);
static_assert(static_cast<int>(output::Widths::classes) == HRBFNPR_WIDTHS_CLASSES);
static_assert(static_cast<int>(output::DotShapes::circles) == HRBFNPR_DOT_SHAPE_CIRCLES);
static_assert(static_cast<int>(output::DotShapes::lines) == HRBFNPR_DOT_SHAPE_LINES);
static_assert(static_cast<int>(output::DotShapes::spirals) == HRBFNPR_DOT_SHAPE_SPIRALS);
static_assert(static_cast<int>(output::LineType::continuous) == HRBFNPR_LINE_TYPE_CONTINUOUS);
static_assert(static_cast<int>(output::LineType::last) == HRBFNPR_LINE_TYPE_DOUBLE_DASHED_TRIPLE_DOTTED);

namespace hrbfnpr::api {
namespace {

using PageDesc = hrbfnpr_page_desc;
using output::PageSettings;
using output::PlotSettings;
using output::ShapeSettings;

constexpr std::int64_t most_items = 4096;
constexpr std::int64_t most_pens = 4096;
constexpr std::int64_t most_annotations = 10000000;
constexpr double farthest_place = 1e6; // The largest coordinate, in mm.
constexpr double least_longest = 1.0;  // In mm; shorter parts would fill memory.
constexpr std::int64_t annotations_per_check = 1024;
constexpr std::uint32_t known_flags =
    HRBFNPR_PAGE_IN_PLOT_ORDER | HRBFNPR_PAGE_SINGLE_PASS | HRBFNPR_PAGE_WITHOUT_PAPER;
constexpr std::uint32_t last_line_type = HRBFNPR_LINE_TYPE_DOUBLE_DASHED_TRIPLE_DOTTED;

constexpr auto page_fields() noexcept {
    using rule::Between;
    return FieldTable{field("format", &PageDesc::format, rule::OneOf{HRBFNPR_PAGE_FORMAT_DXF, "HRBFNPR_PAGE_FORMAT_*"}),
                      field("flags", &PageDesc::flags, rule::Flags{known_flags}),
                      field("widths", &PageDesc::widths, rule::OneOf{HRBFNPR_WIDTHS_CLASSES, "HRBFNPR_WIDTHS_*"}),
                      field("dots", &PageDesc::dots, rule::OneOf{HRBFNPR_DOT_SHAPE_SPIRALS, "HRBFNPR_DOT_SHAPE_*"}),
                      field("curves", &PageDesc::curves, rule::OneOf{HRBFNPR_CURVES_LINES, "HRBFNPR_CURVES_*"}),
                      field("width", &PageDesc::width, &PageSettings::width, Between{0.0, farthest_place}),
                      field("height", &PageDesc::height, &PageSettings::height, Between{0.0, farthest_place}),
                      field("tolerance", &PageDesc::tolerance, Between{0.001, 10.0}),
                      field("width_step", &PageDesc::width_step, Between{1.01, 4.0}),
                      field("join", &PageDesc::join, Between{0.0, farthest_place}),
                      field("shortest", &PageDesc::shortest, Between{0.0, farthest_place}),
                      field("dot_distance", &PageDesc::dot_distance, Between{0.0, farthest_place}),
                      field("draw_speed", &PageDesc::draw_speed, rule::PositiveUpTo{farthest_place}),
                      field("travel_speed", &PageDesc::travel_speed, rule::PositiveUpTo{farthest_place}),
                      field("pen_seconds", &PageDesc::pen_seconds, Between{0.0, 3600.0}),
                      field("pen_down", &PageDesc::pen_down, rule::Any{}),
                      field("pen_up", &PageDesc::pen_up, rule::Any{}),
                      field("title", &PageDesc::title, rule::Any{}),
                      field("description", &PageDesc::description, rule::Any{}),
                      field("metadata", &PageDesc::metadata, rule::Any{}),
                      field("items", &PageDesc::items, rule::Any{}),
                      field("item_count", &PageDesc::item_count, rule::Any{}),
                      field("item_stride", &PageDesc::item_stride, rule::Any{}),
                      field("pens", &PageDesc::pens, rule::Any{}),
                      field("pen_count", &PageDesc::pen_count, rule::Any{}),
                      field("pen_stride", &PageDesc::pen_stride, rule::Any{}),
                      field("annotations", &PageDesc::annotations, rule::Any{}),
                      field("annotation_count", &PageDesc::annotation_count, rule::Any{}),
                      field("annotation_stride", &PageDesc::annotation_stride, rule::Any{}),
                      field("longest", &PageDesc::longest, Between{0.0, farthest_place})};
}
static_assert(page_fields().covers<PageDesc>());

constexpr auto placement_fields() noexcept {
    using From = hrbfnpr_page_item;
    using To = output::Placement;
    return FieldTable{reserved("reserved", &From::reserved),
                      field("drawing", &From::drawing, rule::NotNull{}),
                      field("x", &From::x, &To::x, rule::Between{-farthest_place, farthest_place}),
                      field("y", &From::y, &To::y, rule::Between{-farthest_place, farthest_place}),
                      field("scale", &From::scale, &To::scale, rule::PositiveUpTo{farthest_place}),
                      field("name", &From::name, rule::Any{})};
}
static_assert(placement_fields().covers<hrbfnpr_page_item>());

constexpr auto pen_fields() noexcept {
    using From = hrbfnpr_pen;
    using To = output::Pen;
    return FieldTable{
        field("line_type", &From::line_type, &To::line_type, rule::OneOf{last_line_type, "HRBFNPR_LINE_TYPE_*"}),
        field("groups", &From::groups, rule::Any{}),
        field("width", &From::width, &To::width, rule::Between{0.0, farthest_place}),
        field("ink", &From::ink, &To::ink, rule::IndexedNumbers{rule::Between{0.0, 1.0}}),
        field("number", &From::number, &To::number, rule::Between{1.0, 255.0}),
        reserved("reserved", &From::reserved)};
}
static_assert(pen_fields().covers<hrbfnpr_pen>());

constexpr auto annotation_fields() noexcept {
    using From = hrbfnpr_annotation;
    using To = output::Annotation;
    return FieldTable{
        field("line_type", &From::line_type, &To::line_type, rule::OneOf{last_line_type, "HRBFNPR_LINE_TYPE_*"}),
        field("group", &From::group, rule::NotNull{}),
        field("text", &From::text, rule::Any{}),
        field("points", &From::points, rule::Any{}),
        field("width", &From::width, &To::width, rule::PositiveUpTo{farthest_place}),
        field("ink", &From::ink, &To::ink, rule::IndexedNumbers{rule::Between{0.0, 1.0}})};
}
static_assert(annotation_fields().covers<hrbfnpr_annotation>());

} // namespace

template <>
hrbfnpr_page_desc defaults() noexcept {
    const PageSettings settings;
    hrbfnpr_page_desc desc{};
    page_fields().set_defaults(settings, desc);
    desc.tolerance = settings.shapes.tolerance;
    desc.width_step = settings.shapes.width_step;
    desc.draw_speed = settings.plot.speeds.draw;
    desc.travel_speed = settings.plot.speeds.travel;
    desc.pen_seconds = settings.plot.speeds.seconds;
    return desc;
}

template <>
hrbfnpr_page_item defaults() noexcept {
    hrbfnpr_page_item placement{};
    placement_fields().set_defaults(output::Placement{}, placement);
    return placement;
}

template <>
hrbfnpr_pen defaults() noexcept {
    hrbfnpr_pen pen{};
    pen_fields().set_defaults(output::Pen{}, pen);
    return pen;
}

template <>
hrbfnpr_annotation defaults() noexcept {
    hrbfnpr_annotation annotation{};
    annotation_fields().set_defaults(output::Annotation{}, annotation);
    annotation.group = "annotations";
    return annotation;
}

template <>
hrbfnpr_page_info defaults() noexcept {
    return {};
}

namespace {

const char* checked_text(const char* text, const char* owner, const char* name) {
    if (text != nullptr && !base::is_utf8(text))
        fail(Status::invalid_argument, "%s.%s is not UTF-8; encode it as UTF-8", owner, name);
    return text;
}

std::string_view text_or_empty(const char* text) noexcept { return text != nullptr ? text : std::string_view{}; }

bool in_plot_order(const PageSettings& settings) noexcept { return settings.in_plot_order || settings.for_plotter(); }

PageSettings settings_of(const PageDesc& desc) noexcept {
    PageSettings settings;
    page_fields().copy(desc, settings);
    settings.format = static_cast<output::PageFormat>(desc.format);
    settings.without_paper = (desc.flags & HRBFNPR_PAGE_WITHOUT_PAPER) != 0;
    settings.in_plot_order = (desc.flags & HRBFNPR_PAGE_IN_PLOT_ORDER) != 0;
    settings.shapes = {static_cast<output::Widths>(desc.widths),
                       static_cast<output::DotShapes>(desc.dots),
                       static_cast<output::Curves>(desc.curves),
                       desc.tolerance,
                       desc.width_step,
                       in_plot_order(settings) && (desc.flags & HRBFNPR_PAGE_SINGLE_PASS) == 0};
    settings.plot = {desc.join,
                     desc.shortest,
                     desc.dot_distance,
                     desc.longest,
                     {desc.draw_speed, desc.travel_speed, desc.pen_seconds},
                     desc.pen_down,
                     desc.pen_up};
    return settings;
}

// Reads and checks all parts of a page, before any output is written.
class PageReader {
public:
    PageReader(base::Memory& memory, const PageDesc& desc, const base::Progress& progress)
        : placements_(memory), pens_(memory), annotations_(memory), numbers_(memory) {
        read_placements(desc);
        read_pens(desc);
        read_annotations(memory, desc, progress);
        page_.info.title = checked_text(desc.title, "page_desc", "title");
        page_.info.description = checked_text(desc.description, "page_desc", "description");
        page_.info.metadata = checked_text(desc.metadata, "page_desc", "metadata");
        page_.info.program = hrbfnpr_version_string();
        page_.placements = placements_.span();
        page_.pens = pens_.span();
        page_.annotations = annotations_.span();
        if (placements_.empty() && annotations_.empty())
            fail(Status::invalid_argument, "page_desc has no items and no annotations; there is nothing to write");
    }

    [[nodiscard]] const output::Page& page() const noexcept { return page_; }

    [[nodiscard]] bool has_discs_of_paper() const noexcept {
        for (const output::Placement& placement : placements_)
            if (placement.drawing->painting == drawing::Painting::published) return true;
        return false;
    }

private:
    void read_placements(const PageDesc& desc) {
        const List<hrbfnpr_page_item> list(desc.items, desc.item_count, desc.item_stride, most_items,
                                           "page_desc.items");
        for (std::int64_t i = 0; i < list.count(); ++i) {
            const hrbfnpr_page_item given = list[i];
            const ElementName name = list.name(i);
            placement_fields().check(name.text, given);
            output::Placement placement;
            placement_fields().copy(given, placement);
            placement.drawing = &given.drawing->drawing;
            placement.name = text_or_empty(checked_text(given.name, name.text, "name"));
            placements_.push_back(placement);
        }
    }

    void read_pens(const PageDesc& desc) {
        const List<hrbfnpr_pen> list(desc.pens, desc.pen_count, desc.pen_stride, most_pens, "page_desc.pens");
        for (std::int64_t i = 0; i < list.count(); ++i) {
            const hrbfnpr_pen given = list[i];
            const ElementName name = list.name(i);
            pen_fields().check(name.text, given);
            output::Pen pen;
            pen_fields().copy(given, pen);
            pen.groups = text_or_empty(checked_text(given.groups, name.text, "groups"));
            pens_.push_back(pen);
        }
    }

    void read_annotations(base::Memory& memory, const PageDesc& desc, const base::Progress& progress) {
        const List<hrbfnpr_annotation> list(desc.annotations, desc.annotation_count, desc.annotation_stride,
                                            most_annotations, "page_desc.annotations");
        base::Array<std::int64_t> first(memory);
        for (std::int64_t i = 0; i < list.count(); ++i) {
            if (i % annotations_per_check == 0) output::check_cancel(progress);
            const hrbfnpr_annotation given = list[i];
            first.push_back(numbers_.size());
            annotations_.push_back(read(memory, given, list.name(i).text));
        }
        first.push_back(numbers_.size());
        for (std::int64_t i = 0; i < annotations_.size(); ++i)
            annotations_[i].points = std::as_const(numbers_).span().subspan(
                static_cast<std::size_t>(first[i]), static_cast<std::size_t>(first[i + 1] - first[i]));
    }

    output::Annotation read(base::Memory& memory, const hrbfnpr_annotation& given, const char* name) {
        annotation_fields().check(name, given);
        output::Annotation annotation;
        annotation_fields().copy(given, annotation);
        annotation.group = checked_text(given.group, name, "group");
        if (annotation.group.empty() || annotation.group.size() >= output::PageGroup::most)
            fail(Status::invalid_argument, "%s.group has %lld bytes; it must have 1 to 95", name,
                 static_cast<long long>(annotation.group.size()));
        annotation.text = checked_text(given.text, name, "text");
        char part[128];
        std::snprintf(part, sizeof part, "%.95s.points", name);
        const base::Array<double> points = finite_numbers(memory, given.points, part, {2, float_types});
        const std::int64_t least = given.text != nullptr ? 1 : 2;
        if (points.size() < 2 * least)
            fail(Status::invalid_argument, "%s has %lld elements; it must have at least %lld", part,
                 static_cast<long long>(points.size() / 2), static_cast<long long>(least));
        for (const double number : points) numbers_.push_back(number);
        return annotation;
    }

    output::Page page_;
    base::Array<output::Placement> placements_;
    base::Array<output::Pen> pens_;
    base::Array<output::Annotation> annotations_;
    base::Array<double> numbers_; // the coordinates of the annotations' points
};

hrbfnpr_page_info describe(const output::PageCounts& counts, const glm::dvec2& size) noexcept {
    hrbfnpr_page_info info{};
    info.bytes = counts.bytes;
    info.groups = counts.groups;
    info.paths = counts.paths;
    info.segments = counts.segments;
    info.dots = counts.dots;
    info.joined = counts.joined;
    info.dropped_paths = counts.dropped_paths;
    info.dropped_dots = counts.dropped_dots;
    info.width = size.x;
    info.height = size.y;
    info.drawn = counts.drawn;
    info.travelled = counts.travelled;
    info.seconds = counts.seconds;
    info.filled_paths = counts.filled_paths;
    info.cut_paths = counts.cut_paths;
    return info;
}

hrbfnpr_page_info write(const base::Runtime& runtime, const PageDesc& desc, io::Writer& writer,
                        hrbfnpr_operation* operation) {
    page_fields().check("page_desc", desc);
    if (desc.longest > 0.0 && desc.longest < least_longest)
        fail(Status::invalid_argument, "page_desc.longest is %g; it must be 0 for no limit, or %g to %g", desc.longest,
             least_longest, farthest_place);
    const OperationUse use(operation);
    const PageReader reader(runtime.memory, desc, use.progress());
    const PageSettings settings = settings_of(desc);
    const glm::dvec2 size = output::page_size(reader.page(), settings);
    if (!(size.x > 0.0 && size.y > 0.0 && size.x <= farthest_place && size.y <= farthest_place))
        fail(Status::invalid_argument,
             "the page is %g by %g mm; set page_desc.width and height to sizes above 0 and up to %g, or place drawings "
             "on the page",
             size.x, size.y, farthest_place);
    const bool is_dxf = settings.format == output::PageFormat::dxf;
    if ((in_plot_order(settings) || is_dxf) && reader.has_discs_of_paper())
        fail(Status::invalid_argument,
             "a drawing with PUBLISHED visibility covers ink with discs of paper, which %s; draw it with DEPTH_LAYERS",
             is_dxf ? "DXF does not have" : "cannot be plotted or sorted");
    const output::PageCounts counts = output::write_page({runtime, use.progress()}, reader.page(), settings, writer);
    use.finish();
    return describe(counts, size);
}

} // namespace
} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_page_desc_init(hrbfnpr_page_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_page_item_init(hrbfnpr_page_item* placement, uint32_t struct_size) {
    return api::init_struct(placement, struct_size);
}

hrbfnpr_status hrbfnpr_pen_init(hrbfnpr_pen* pen, uint32_t struct_size) { return api::init_struct(pen, struct_size); }

hrbfnpr_status hrbfnpr_annotation_init(hrbfnpr_annotation* annotation, uint32_t struct_size) {
    return api::init_struct(annotation, struct_size);
}

hrbfnpr_status hrbfnpr_page_info_init(hrbfnpr_page_info* info, uint32_t struct_size) {
    return api::init_struct(info, struct_size);
}

hrbfnpr_status hrbfnpr_page_write(hrbfnpr_context* context, const hrbfnpr_page_desc* desc, hrbfnpr_write_fn write,
                                  void* user, hrbfnpr_page_info* info, hrbfnpr_operation* operation,
                                  hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        auto& parent = api::deref(context, "context");
        api::require_pointer(desc, "desc");
        if (write == nullptr) fail(Status::invalid_argument, "write is NULL");
        if (info != nullptr) api::check_output_struct(info, "page_info");
        api::CallbackWriter writer(write, user);
        const hrbfnpr_page_info done =
            api::write(parent.runtime, api::read_struct(desc, "page_desc"), writer, operation);
        if (info != nullptr) api::write_struct(info, done);
    });
}

} // extern "C"
