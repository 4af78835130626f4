// SPDX-License-Identifier: MIT
// Reports to the caller of a picture: notes, stages with their times, and progress.
#pragma once

#include "api/operation.h"
#include "base/clock.h"
#include "base/format.h"
#include "picture/memory.h"

#include <hrbfnpr.h>

#include <array>
#include <initializer_list>
#include <optional>
#include <string_view>

namespace hrbfnpr::picture {

// Puts a text into the words of a caller. Options in the text are written {samples}, {samples=400} or
// {marks=hatch=2000}, and {flip!} if they take no value:
//   FIELDS      samples 400, flag FLIP
//   OPTIONS     --samples 400, --flip
//   ARGUMENTS   samples=400, flip=True
[[nodiscard]] String in_words(std::string_view text, std::uint32_t wording, Pool& pool);

// Returns a count with its noun: "1 sample", "2 samples", "2 vertices".
[[nodiscard]] String count_of(std::int64_t count, std::string_view what, Pool& pool);

// Returns the verb for a count: "has" for 1, else "have".
[[nodiscard]] constexpr const char* has_or_have(std::int64_t count) noexcept { return count == 1 ? "has" : "have"; }

// Returns a name that a user chose, or as much of it as fits in a note.
[[nodiscard]] String short_name(std::string_view name, Pool& pool);

// Works like printf, but returns a String.
HRBFNPR_PRINTF_LIKE(2, 3) [[nodiscard]] String formatted(Pool& pool, const char* format, ...);

constexpr std::size_t longest_note = 100; // bytes of the text of a note or a warning

struct Note {
    std::uint32_t code;
    std::uint32_t severity;
    std::uint32_t figure_count;
    std::array<double, 8> figures;
    String text;
    String advice; // the remedy for the user; empty if the text names it
    String detail; // more about the note, in one or two sentences; may be empty
};

struct FinishedStage {
    std::uint32_t stage;
    double seconds;
    String says;
};

class Stage;

// The advice and the detail of a note or a warning, in the form that in_words() takes.
struct More {
    std::string_view advice = {}; // what to do; empty if the text says it
    std::string_view detail = {}; // one or two sentences for those who ask for more
};

// Stores all notes and stages, and passes each to the caller at once.
class Report {
public:
    Report(Pool& pool, std::uint32_t wording, hrbfnpr_picture_event_fn on_event, void* user, hrbfnpr_context& context,
           hrbfnpr_operation* operation)
        : notes(&pool), stages(&pool), pool_(&pool), wording_(wording), on_event_(on_event), user_(user),
          context_(&context), operation_(operation) {}

    // Each reports an item of information, a note or a warning. `text` has the form that in_words() takes. The text of
    // a note or warning, and its advice, have at most `longest_note` bytes each. A repeated warning is reported once.
    void info(std::uint32_t code, std::initializer_list<double> figures, std::string_view text);
    void note(std::uint32_t code, std::initializer_list<double> figures, std::string_view text, const More& more = {});
    void warn(std::uint32_t code, std::initializer_list<double> figures, std::string_view text, const More& more = {});
    // Reports a failure in a note, without throwing an error.
    void failure(std::uint32_t code, std::string_view text);
    // Stores the full text as a note. Throws Error{invalid_argument} with as much of the text as fits.
    [[noreturn]] void fail(std::uint32_t code, std::initializer_list<double> figures, std::string_view text);
    // Throws Error{invalid_argument} with the text in the caller's words.
    [[noreturn]] void refuse(std::string_view text) const;

    // Tells whether a text, in the caller's words, is short enough for a note or a warning.
    [[nodiscard]] bool is_short(std::string_view text) const {
        return in_words(text, wording_, *pool_).size() <= longest_note;
    }

    [[nodiscard]] Pool& pool() const noexcept { return *pool_; }
    // Marks the end of planning. Many calls may follow. From then on, a repeated note or stage is stored only once.
    void end_planning() noexcept { planned_stages_ = stages.size(); }

    Vector<Note> notes;
    Vector<FinishedStage> stages;

private:
    friend class Stage;
    friend class Serving;
    void tell(std::uint32_t severity, std::uint32_t code, std::initializer_list<double> figures, std::string_view text,
              const More& more = {});
    // After planning, returns the stored stage of the same kind, or null without such a stage. During planning, returns
    // null.
    [[nodiscard]] FinishedStage* kept_before(std::uint32_t stage) noexcept;
    const FinishedStage& keep(FinishedStage&& finished);

    Pool* pool_;
    std::uint32_t wording_;
    hrbfnpr_picture_event_fn on_event_;
    void* user_;
    hrbfnpr_context* context_;
    hrbfnpr_operation* operation_; // the operation of the whole call; may be null
    double done_ = 0.0;            // the share of the operation's progress that is finished
    std::uint32_t running_ = 0;    // the kind of the running stage
    std::optional<std::size_t> planned_stages_;
};

// While an object of this class exists, a report uses the operation of a call. The operation may be NULL.
class Serving {
public:
    Serving(Report& report, hrbfnpr_operation* operation) noexcept : report_(report) {
        report.operation_ = operation;
        report.done_ = 0.0;
    }
    ~Serving() { report_.operation_ = nullptr; }
    Serving(const Serving&) = delete;
    Serving& operator=(const Serving&) = delete;

private:
    Report& report_;
};

[[nodiscard]] hrbfnpr_note described(const Note& note) noexcept;
[[nodiscard]] hrbfnpr_picture_event described(const FinishedStage& finished) noexcept;

// A stage of the work, which lasts as long as this object. It measures the time, and passes on progress and
// cancellation. Stages do not overlap.
class Stage {
public:
    Stage(Report& report, std::uint32_t stage);
    ~Stage(); // Reports the end of the stage, except when an exception is in flight.
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    // Returns an operation for a call of the library. Its progress becomes the progress of the stage.
    [[nodiscard]] hrbfnpr_operation* operation() noexcept { return &operation_; }
    // Reports the progress of a stage that makes many calls. Throws Error{cancelled} if the caller has cancelled.
    void update(double fraction);
    // Sets a text about the result of the stage, in the form that in_words() takes.
    void says(std::string_view text);

private:
    static std::int32_t on_progress(void* user, double progress) noexcept;
    void tell(double fraction) noexcept;

    Report& report_;
    std::uint32_t stage_;
    int exceptions_;    // the number of exceptions in flight at the beginning of the stage
    double told_ = 0.0; // the largest fraction reported
    base::Stopwatch watch_;
    String says_;
    hrbfnpr_operation operation_;
};

} // namespace hrbfnpr::picture
