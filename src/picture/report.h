// SPDX-License-Identifier: MIT
// What a picture tells its caller: notes, stages with their seconds, progress.
#pragma once

#include "api/operation.h"
#include "base/clock.h"
#include "picture/memory.h"

#include <hrbfnpr.h>

#include <array>
#include <initializer_list>
#include <string_view>

namespace hrbfnpr::picture {

// Puts a text into the words of a caller.  Options stand in it as {samples}, {samples=400}, {marks=hatch=2000}, or
// {flip!} of one without a value:
//   FIELDS      samples 400, flag FLIP
//   OPTIONS     --samples 400, --flip
//   ARGUMENTS   samples=400, flip=True
[[nodiscard]] String in_words(std::string_view text, std::uint32_t wording, Pool& pool);

// "1 sample", "2 samples".
[[nodiscard]] String count_of(std::int64_t count, std::string_view what, Pool& pool);

// printf into a String.
[[nodiscard]] [[gnu::format(printf, 2, 3)]] String formatted(Pool& pool, const char* format, ...);

struct Note {
    std::uint32_t code;
    std::uint32_t severity;
    std::uint32_t figure_count;
    std::array<double, 8> figures;
    String text;
    String advice; // empty: there is none, or the text has it
};

struct FinishedStage {
    std::uint32_t stage;
    double seconds;
    String says;
};

class Stage;

// Keeps what is told, and passes it on as it comes.
class Report {
public:
    Report(Pool& pool, std::uint32_t wording, hrbfnpr_picture_event_fn on_event, void* user, hrbfnpr_context& context,
           hrbfnpr_operation* operation)
        : notes(&pool), stages(&pool), pool_(&pool), wording_(wording), on_event_(on_event), user_(user),
          context_(&context), operation_(operation) {}

    // `text` and `advice`, which is what to do about it, as in_words() takes them.  A warning that was told before is
    // not told again.
    void info(std::uint32_t code, std::initializer_list<double> figures, std::string_view text);
    void note(std::uint32_t code, std::initializer_list<double> figures, std::string_view text);
    void warn(std::uint32_t code, std::initializer_list<double> figures, std::string_view text,
              std::string_view advice = {});
    // Tells a failure that is no error of the call.
    void failure(std::uint32_t code, std::string_view text);
    // Keeps the text in full length as a note, and throws Error{invalid_argument} with as much of it as has room.
    [[noreturn]] void fail(std::uint32_t code, std::initializer_list<double> figures, std::string_view text);
    // Throws Error{invalid_argument} in the caller's words.
    [[noreturn]] void refuse(std::string_view text) const;

    [[nodiscard]] Pool& pool() const noexcept { return *pool_; }
    // The operation of the call that goes on with this report; nullable.
    void serve(hrbfnpr_operation* operation) noexcept {
        operation_ = operation;
        done_ = 0.0;
    }

    Vector<Note> notes;
    Vector<FinishedStage> stages;

private:
    friend class Stage;
    void tell(std::uint32_t severity, std::uint32_t code, std::initializer_list<double> figures, std::string_view text,
              std::string_view advice = {});

    Pool* pool_;
    std::uint32_t wording_;
    hrbfnpr_picture_event_fn on_event_;
    void* user_;
    hrbfnpr_context* context_;
    hrbfnpr_operation* operation_; // of the whole; nullable
    double done_ = 0.0;            // of its progress
    std::uint32_t running_ = 0;    // stage
};

[[nodiscard]] hrbfnpr_note described(const Note& note) noexcept;
[[nodiscard]] hrbfnpr_picture_event described(const FinishedStage& finished) noexcept;

// A part of the work while it lives: it measures its seconds, and passes progress and cancels on.  Stages do not
// overlap.
class Stage {
public:
    Stage(Report& report, std::uint32_t stage);
    ~Stage(); // reports its end, unless an exception ends it
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    // For one call of the library after the other; the stage's progress is that of the call.
    [[nodiscard]] hrbfnpr_operation* operation() noexcept { return &operation_; }
    // For a stage of many calls.  Throws Error{cancelled} after a cancel.
    void update(double fraction);
    // What it came to; as in_words() takes it.
    void says(std::string_view text);

private:
    static std::int32_t on_progress(void* user, double progress) noexcept;
    void tell(double fraction) noexcept;

    Report& report_;
    std::uint32_t stage_;
    int exceptions_;    // in flight when it began
    double told_ = 0.0; // the largest fraction
    base::Stopwatch watch_;
    String says_;
    hrbfnpr_operation operation_;
};

} // namespace hrbfnpr::picture
