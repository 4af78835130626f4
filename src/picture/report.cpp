// SPDX-License-Identifier: MIT
#include "picture/report.h"

#include "base/assert.h"
#include "base/format.h"
#include "base/status.h"
#include "picture/field_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdarg>
#include <cstdio>
#include <exception>
#include <limits>

namespace hrbfnpr::picture {
namespace {

// ---- Words

struct OptionName {
    // The texts are in arrays, because a table of pointers would need relocation.
    char option[20]; // the name of the option, with underscores
    char field[32];  // the name of the field that a C program sets
};

// The options that differ in name from their field.
constexpr std::array<OptionName, 21> option_names{
    OptionName{"allow_blank", "HRBFNPR_PICTURE_ALLOW_BLANK"},
    OptionName{"close", "HRBFNPR_PICTURE_CLOSE"},
    OptionName{"crease", "crease_angle"},
    OptionName{"depth_range", "style.depth_max"},
    OptionName{"flip", "HRBFNPR_PICTURE_FLIP"},
    OptionName{"flipped_normals", "fit.flipped_normals"},
    OptionName{"kernel", "fit.kernel"},
    OptionName{"layers", "mark_kinds"},
    OptionName{"light", "style.light"},
    OptionName{"mark_radius", "pen"},
    OptionName{"max_centres", "maximum_centres"},
    OptionName{"occlusion", "style.occlusion_lights"},
    OptionName{"outliers", "fit.outliers"},
    OptionName{"page", "paper"},
    OptionName{"page_margin", "paper_margin"},
    OptionName{"regularization", "fit.regularization"},
    OptionName{"section", "sections"},
    OptionName{"style", "preset"},
    OptionName{"together", "HRBFNPR_PICTURE_TOGETHER"},
    OptionName{"tone", "style.tone"},
    OptionName{"zoom_reference", "style.zoom_reference"},
};

std::string_view field_of(std::string_view option) noexcept {
    const auto* found = std::find_if(option_names.begin(), option_names.end(),
                                     [&](const OptionName& name) { return std::string_view(name.option) == option; });
    return found != option_names.end() ? std::string_view(found->field) : option;
}

bool is_number(std::string_view text) noexcept {
    if (text == "N") return true; // "N" is a placeholder for a number.
    return parse_number(text).has_value();
}

// The parts of a marker: {name}, {name=value}, {name=part=value}, {name!}.
struct Marker {
    std::string_view name;
    std::string_view value;
    bool has_value = false;
    bool is_flag = false;
};

Marker parse_marker(std::string_view text) noexcept {
    Marker marker;
    const std::size_t equals = text.find('=');
    marker.name = text.substr(0, equals);
    if (equals != std::string_view::npos) {
        marker.has_value = true;
        marker.value = text.substr(equals + 1);
    } else if (!text.empty() && text.back() == '!') {
        marker.is_flag = true;
        marker.name = text.substr(0, text.size() - 1);
    }
    return marker;
}

void append_as_option(String& to, const Marker& marker) {
    to += "--";
    for (const char c : marker.name) to += c == '_' ? '-' : c;
    if (marker.has_value) (to += ' ') += marker.value;
}

void append_python_value(String& to, std::string_view value) {
    if (value.find(',') != std::string_view::npos) {
        to += '(';
        for (const char c : value) (to += c) += c == ',' ? " " : "";
        to += ')';
    } else if (is_number(value)) {
        to += value;
    } else {
        ((to += '\'') += value) += '\'';
    }
}

void append_as_argument(String& to, const Marker& marker) {
    to += marker.name;
    if (marker.is_flag) to += "=True";
    if (!marker.has_value) return;
    to += '=';
    const std::size_t equals = marker.value.find('=');
    if (equals == std::string_view::npos) {
        append_python_value(to, marker.value);
        return;
    }
    ((to += "{'") += marker.value.substr(0, equals)) += "': ";
    append_python_value(to, marker.value.substr(equals + 1));
    to += '}';
}

void append_as_field(String& to, const Marker& marker) {
    const std::size_t equals = marker.value.find('=');
    if (marker.has_value && equals != std::string_view::npos) { // In {name=part=value}, `part` names a layer of marks.
        const std::string_view field = marker.name == "marks" ? "budget" : marker.name;
        ((to += "marks.") += marker.value.substr(0, equals)) += '.';
        ((to += field) += ' ') += marker.value.substr(equals + 1);
        return;
    }
    // The option "edges" accepts a word or an angle. The descriptor has a separate field for each.
    const bool is_angle = marker.name == "edges" && marker.has_value && is_number(marker.value);
    to += is_angle ? "edge_angle" : field_of(marker.name);
    if (marker.has_value) (to += ' ') += marker.value;
}

} // namespace

String in_words(std::string_view text, std::uint32_t wording, Pool& pool) {
    String words(&pool);
    words.reserve(text.size() + 16);
    while (!text.empty()) {
        const std::size_t begin = text.find('{');
        const std::size_t end = begin == std::string_view::npos ? begin : text.find('}', begin);
        if (end == std::string_view::npos) break;
        words += text.substr(0, begin);
        const Marker marker = parse_marker(text.substr(begin + 1, end - begin - 1));
        switch (wording) {
        case HRBFNPR_WORDING_OPTIONS: append_as_option(words, marker); break;
        case HRBFNPR_WORDING_ARGUMENTS: append_as_argument(words, marker); break;
        default: append_as_field(words, marker); break;
        }
        text.remove_prefix(end + 1);
    }
    words += text;
    return words;
}

String count_of(std::int64_t count, std::string_view what, Pool& pool) {
    String text(&pool);
    std::array<char, 24> digits;
    char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), count).ptr;
    text.append(digits.data(), end);
    text += ' ';
    const bool is_vertex = what == "vertex";
    if (count == 1)
        text += what;
    else
        (text += is_vertex ? std::string_view("vertice") : what) += 's';
    return text;
}

String short_name(std::string_view name, Pool& pool) {
    constexpr std::size_t longest = 24; // bytes
    if (name.size() <= longest) return String(name, &pool);
    std::size_t end = longest - 3;
    // The cut never divides a UTF-8 character.
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U) --end;
    String text(name.substr(0, end), &pool);
    text += "...";
    return text;
}

String formatted(Pool& pool, const char* format, ...) {
    constexpr std::size_t longest = 2048; // The longest text in bytes. Notes are much shorter.
    std::array<char, longest> text;
    std::va_list arguments;
    va_start(arguments, format);
    base::format_text(text.data(), text.size(), format, arguments);
    va_end(arguments);
    return {text.data(), &pool};
}

// ---- Notes

void Report::tell(std::uint32_t severity, std::uint32_t code, std::initializer_list<double> figures,
                  std::string_view text, const More& more) {
    Note note{code,
              severity,
              0,
              {},
              in_words(text, wording_, *pool_),
              in_words(more.advice, wording_, *pool_),
              in_words(more.detail, wording_, *pool_)};
    if (severity == HRBFNPR_SEVERITY_NOTE || severity == HRBFNPR_SEVERITY_WARNING)
        HRBFNPR_ASSERT(note.text.size() <= longest_note && note.advice.size() <= longest_note);
    for (const double figure : figures) {
        if (note.figure_count == note.figures.size()) break;
        note.figures[note.figure_count++] = figure;
    }
    const auto is_same = [&](const Note& told) { return told.severity == severity && told.text == note.text; };
    const bool is_told_once = severity == HRBFNPR_SEVERITY_WARNING || planned_stages_.has_value();
    if (is_told_once && std::any_of(notes.begin(), notes.end(), is_same)) return;
    notes.push_back(std::move(note));
    if (on_event_ == nullptr) return;
    const hrbfnpr_note public_note = described(notes.back());
    hrbfnpr_picture_event event{};
    event.struct_size = sizeof event;
    event.stage = running_;
    event.note = &public_note;
    on_event_(user_, &event);
}

void Report::info(std::uint32_t code, std::initializer_list<double> figures, std::string_view text) {
    tell(HRBFNPR_SEVERITY_INFO, code, figures, text);
}
void Report::note(std::uint32_t code, std::initializer_list<double> figures, std::string_view text, const More& more) {
    tell(HRBFNPR_SEVERITY_NOTE, code, figures, text, more);
}
void Report::warn(std::uint32_t code, std::initializer_list<double> figures, std::string_view text, const More& more) {
    tell(HRBFNPR_SEVERITY_WARNING, code, figures, text, more);
}
void Report::failure(std::uint32_t code, std::string_view text) { tell(HRBFNPR_SEVERITY_FAILURE, code, {}, text); }

void Report::fail(std::uint32_t code, std::initializer_list<double> figures, std::string_view text) {
    tell(HRBFNPR_SEVERITY_FAILURE, code, figures, text);
    throw Error(Status::invalid_argument, notes.back().text.c_str());
}

void Report::refuse(std::string_view text) const {
    throw Error(Status::invalid_argument, in_words(text, wording_, *pool_).c_str());
}

hrbfnpr_note described(const Note& note) noexcept {
    hrbfnpr_note to{};
    to.struct_size = sizeof to;
    to.code = note.code;
    to.severity = note.severity;
    to.figure_count = note.figure_count;
    std::copy(note.figures.begin(), note.figures.end(), to.figures);
    to.text = note.text.c_str();
    to.advice = note.advice.empty() ? nullptr : note.advice.c_str();
    to.detail = note.detail.empty() ? nullptr : note.detail.c_str();
    return to;
}

// ---- Stages

namespace {

struct StageWords {
    const char* name;
    const char* doing;
    double share; // the stage's share of the remaining progress
};

constexpr std::array<StageWords, HRBFNPR_STAGE_SHADE + 1> stage_words{{{"", "", 0.0},
                                                                       {"mesh", "checking the mesh", 0.1},
                                                                       {"sample", "sampling", 0.05},
                                                                       {"orient", "orienting normals", 0.2},
                                                                       {"smooth", "smoothing", 0.2},
                                                                       {"fit", "fitting", 0.4},
                                                                       {"compare", "comparing", 0.1},
                                                                       {"end", "finding the end of the surface", 0.1},
                                                                       {"place marks", "placing marks", 0.6},
                                                                       {"trace lines", "tracing lines", 0.8},
                                                                       {"frame", "drawing", 0.9},
                                                                       {"views", "drawing views", 0.9},
                                                                       {"shade", "finding shadows", 0.85}}};

const StageWords& words_of(std::uint32_t stage) noexcept { return stage_words[stage < stage_words.size() ? stage : 0]; }

hrbfnpr_picture_event event_of(std::uint32_t stage) noexcept {
    hrbfnpr_picture_event event{};
    event.struct_size = sizeof event;
    event.stage = stage;
    event.name = words_of(stage).name;
    event.doing = words_of(stage).doing;
    return event;
}

} // namespace

hrbfnpr_picture_event described(const FinishedStage& finished) noexcept {
    hrbfnpr_picture_event event = event_of(finished.stage);
    event.fraction = 1.0;
    event.seconds = finished.seconds;
    event.says = finished.says.c_str();
    return event;
}

Stage::Stage(Report& report, std::uint32_t stage)
    : report_(report), stage_(stage), exceptions_(std::uncaught_exceptions()), says_(report.pool_),
      operation_(*report.context_) {
    // Memory is reserved here, so that the end of the stage cannot fail for lack of memory.
    if (report.kept_before(stage) == nullptr) report.stages.reserve(report.stages.size() + 1);
    operation_.operation.set_callback(on_progress, this);
    if (report.operation_ != nullptr) operation_.operation.set_parent(&report.operation_->operation);
    report.running_ = stage;
    tell(0.0);
}

FinishedStage* Report::kept_before(std::uint32_t stage) noexcept {
    if (!planned_stages_) return nullptr;
    const auto begin = stages.begin() + static_cast<std::ptrdiff_t>(*planned_stages_);
    const auto is_same = [&](const FinishedStage& kept) { return kept.stage == stage; };
    const auto same = std::find_if(begin, stages.end(), is_same);
    return same != stages.end() ? &*same : nullptr;
}

const FinishedStage& Report::keep(FinishedStage&& finished) {
    if (FinishedStage* const before = kept_before(finished.stage)) return *before = std::move(finished);
    stages.push_back(std::move(finished));
    return stages.back();
}

Stage::~Stage() {
    const double seconds = watch_.seconds();
    report_.running_ = 0;
    report_.done_ += words_of(stage_).share * (1.0 - report_.done_);
    if (std::uncaught_exceptions() != exceptions_) return;
    const FinishedStage& kept = report_.keep({stage_, seconds, std::move(says_)});
    if (report_.on_event_ == nullptr) return;
    const hrbfnpr_picture_event event = described(kept);
    report_.on_event_(report_.user_, &event);
}

void Stage::tell(double fraction) noexcept {
    // A second call of the library in the same stage starts again at 0. This is not reported.
    if (fraction < told_) return;
    if (operation_.operation.is_cancelled()) return;
    told_ = fraction;
    if (report_.operation_ != nullptr)
        report_.operation_->operation.report(report_.done_ + words_of(stage_).share * (1.0 - report_.done_) * fraction);
    if (report_.on_event_ == nullptr) return;
    hrbfnpr_picture_event event = event_of(stage_);
    event.fraction = std::min(fraction, std::nextafter(1.0, 0.0)); // Only the destructor reports 1.
    report_.on_event_(report_.user_, &event);
}

std::int32_t Stage::on_progress(void* user, double progress) noexcept {
    auto& stage = *static_cast<Stage*>(user);
    stage.tell(progress);
    return stage.operation_.operation.is_cancelled() ? 1 : 0;
}

void Stage::update(double fraction) {
    tell(fraction);
    if (operation_.operation.is_cancelled()) hrbfnpr::fail(Status::cancelled, "the operation was cancelled");
}

void Stage::says(std::string_view text) { says_ = in_words(text, report_.wording_, *report_.pool_); }

} // namespace hrbfnpr::picture
