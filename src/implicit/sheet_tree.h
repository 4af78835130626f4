// SPDX-License-Identifier: MIT
// An implicit function made of sheets that meet in creases, and a version of it that is prepared for many points. In
// each cell f is a maximum or minimum of a few sheets. Where no surface is near, f is a linear function that
// approximates the distance from the surface. Between cells f changes smoothly by a partition of unity, as in Ohtake et
// al., "Multi-level partition of unity implicits", 2003. Here the sheets are global functions, so f has no blending
// where neighbouring cells select the same sheet.
#pragma once

#include "base/clock.h"
#include "implicit/sheet_tree_cells.h"
#include "implicit/sheets.h"

#include <memory>
#include <optional>

namespace hrbfnpr::implicit {

class Prepared;

class SheetTreeBase : public Implicit, public Sheets {
public:
    void evaluate(const PointBatch& points, const FieldBatch& fields) const override;
    [[nodiscard]] bool concurrent() const noexcept override { return true; }
    [[nodiscard]] std::int64_t cells() const noexcept override;
    [[nodiscard]] std::int32_t cell_of(const glm::dvec3& place) const noexcept override {
        return zones_ != nullptr ? zones_->cell_of(place) : data_.leaf_at(place);
    }
    [[nodiscard]] const geometry::Bounds& bounds() const noexcept override { return data_.bounds; }
    [[nodiscard]] const Sheets* sheets() const noexcept override { return this; }

    // The last sheet is f itself. It is used where no surface is near, because f is smooth there.
    [[nodiscard]] std::int32_t count() const noexcept override {
        return static_cast<std::int32_t>(data_.sheet.size()) + 1;
    }
    void active(const PointBatch& points, std::int32_t* sheet) const override;
    void evaluate(std::int32_t sheet, const PointBatch& points, const FieldBatch& fields) const override;

    [[nodiscard]] const SheetTreeData& data() const noexcept { return data_; }
    [[nodiscard]] const SheetTreeZones* zones() const noexcept { return zones_; }
    [[nodiscard]] base::InstructionSet instruction_set() const noexcept { return set_; }

protected:
    // All arguments must outlive this object. `zones` is null if there are no zones. `prepared` has one element for
    // each sheet, which is null if the sheet is not prepared. It is empty if no sheet is prepared.
    SheetTreeBase(base::InstructionSet set, const SheetTreeData& data, const SheetTreeZones* zones = nullptr,
                  const base::List<std::unique_ptr<Prepared>>* prepared = nullptr) noexcept
        : set_(set), data_(data), zones_(zones), prepared_(prepared) {}

private:
    [[nodiscard]] const Prepared* prepared(std::int64_t sheet) const noexcept {
        return prepared_ != nullptr && !prepared_->empty() ? (*prepared_)[sheet].get() : nullptr;
    }

    base::InstructionSet set_;
    const SheetTreeData& data_;
    const SheetTreeZones* zones_;
    const base::List<std::unique_ptr<Prepared>>* prepared_;
};

class SheetTree final : public SheetTreeBase {
public:
    SheetTree(base::InstructionSet set, SheetTreeData made) noexcept
        : SheetTreeBase(set, own_), own_(std::move(made)) {}

    [[nodiscard]] SheetTreeData take() && noexcept { return std::move(own_); }

private:
    SheetTreeData own_;
};

// The function of SheetTreeBase, prepared for many points. The results of the two differ by rounding and by the errors
// of the Prepared sheets.
class PreparedSheetTree final : public SheetTreeBase {
public:
    // The parts that are prepared: only the zones, or the zones and the sheets with many centres.
    enum class Scope : std::uint8_t { zones, sheets };

    // Returns the scope whose preparation takes less time than it saves for this number of points; nullopt if no scope
    // does.
    [[nodiscard]] static std::optional<Scope> pays(const SheetTreeData& data, double points) noexcept;

    // The object keeps a reference to `of`.
    PreparedSheetTree(const base::Work& work, const SheetTreeBase& of, Scope scope);
    ~PreparedSheetTree() override;

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    base::Stopwatch watch_;
    SheetTreeZones own_zones_;
    base::List<std::unique_ptr<Prepared>> sheet_; // null if the prepared sheet would be inaccurate
};

} // namespace hrbfnpr::implicit
