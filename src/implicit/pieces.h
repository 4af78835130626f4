// SPDX-License-Identifier: MIT
// An implicit with creases: smooth sheets, each a Hermite fit of its own, and cells that say which of them rule where.
// In each cell f is a maximum or minimum of a few sheets, or, where no surface is near, a linear function that is as
// far from 0 as the surface is away; between cells it changes smoothly (a partition of unity as in Ohtake et al.,
// "Multi-level partition of unity implicits", 2003, whose pieces are global functions here: cells that are ruled by
// the same sheet change nothing).
#pragma once

#include "base/clock.h"
#include "implicit/pieces_zones.h"
#include "implicit/sheets.h"

#include <memory>
#include <optional>

namespace hrbfnpr::implicit {

class Prepared;

// What is evaluated: a model's own, or with some of its sheets prepared for many points.
struct PiecesParts {
    base::InstructionSet set;
    const PiecesData& data;
    const PiecesZones* zones = nullptr;
    const Prepared* const* prepared = nullptr; // of each sheet, where it is; null: of none

    void evaluate_sheet(std::int32_t sheet, const PointBatch& points, const FieldBatch& fields) const;
};

// As its parts say, which outlive it.
class PiecesOf : public Implicit, public Sheets {
public:
    explicit PiecesOf(const PiecesParts& parts) noexcept : parts_(parts) {}

    void evaluate(const PointBatch& points, const FieldBatch& fields) const override;
    [[nodiscard]] bool concurrent() const noexcept override { return true; }
    [[nodiscard]] std::int64_t cells() const noexcept override;
    [[nodiscard]] std::int32_t cell_of(const glm::dvec3& place) const noexcept override {
        return parts_.zones != nullptr ? parts_.zones->cell_of(place) : data().leaf_at(place);
    }
    [[nodiscard]] const geometry::Bounds& bounds() const noexcept override { return data().bounds; }
    [[nodiscard]] const Sheets* sheets() const noexcept override { return this; }

    // The last one is f itself, which is smooth where no surface is near.
    [[nodiscard]] std::int32_t count() const noexcept override {
        return static_cast<std::int32_t>(data().sheet.size()) + 1;
    }
    void active(const PointBatch& points, std::int32_t* sheet) const override;
    void evaluate(std::int32_t sheet, const PointBatch& points, const FieldBatch& fields) const override;

    [[nodiscard]] const PiecesData& data() const noexcept { return parts_.data; }
    [[nodiscard]] base::InstructionSet instruction_set() const noexcept { return parts_.set; }

private:
    PiecesParts parts_;
};

struct OwnedPieces {
    PiecesData data;
};

class Pieces final : private OwnedPieces, public PiecesOf {
public:
    Pieces(base::InstructionSet set, PiecesData made) noexcept
        : OwnedPieces{std::move(made)}, PiecesOf({set, OwnedPieces::data}) {}

    using PiecesOf::data;
    [[nodiscard]] PiecesData take() && noexcept { return std::move(OwnedPieces::data); }
};

struct ReadyPieces {
    base::Stopwatch watch;
    PiecesZones zones;
    base::List<std::unique_ptr<Prepared>> sheet; // null where it is not
    base::Array<const Prepared*> pointer;
};

// The same function, up to rounding and what Prepared says of its sheets, where many points are asked for.
class PreparedPieces final : private ReadyPieces, public PiecesOf {
public:
    // What is prepared: zones, or zones and sheets of many centres.
    enum class Scope : std::uint8_t { zones, sheets };

    // How much takes less time for so many points than it saves; nullopt: nothing.
    [[nodiscard]] static std::optional<Scope> pays(const PiecesData& data, double points) noexcept;

    // The pieces must outlive it.
    PreparedPieces(const base::Runtime& runtime, const PiecesOf& of, Scope scope, const base::Progress& progress);
    ~PreparedPieces() override;

    [[nodiscard]] std::int64_t bytes() const noexcept;
};

} // namespace hrbfnpr::implicit
