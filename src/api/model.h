// SPDX-License-Identifier: MIT
// The handle of a model: a fit with its report, a caller's function, or a tree of models.
#pragma once

#include "api/csg_solid.h"
#include "api/handles.h"
#include "fit/fit.h"
#include "generate/find_trim.h"
#include "generate/settings.h"
#include "implicit/custom.h"
#include "implicit/hrbf.h"
#include "implicit/prepared.h"
#include "implicit/sheet_tree.h"
#include "implicit/trimmed.h"
#include "surface/ray_cells.h"

#include <memory>
#include <mutex>
#include <optional>
#include <variant>

struct hrbfnpr_model : hrbfnpr::api::Child {
    hrbfnpr_model(hrbfnpr_context& context, hrbfnpr::fit::FitResult&& fit) noexcept
        : Child(context),
          surface(std::in_place_type<hrbfnpr::implicit::Hrbf>, context.runtime.instruction_set, std::move(fit.data)),
          report(fit.report), history(std::move(fit.history)) {}
    hrbfnpr_model(hrbfnpr_context& context, hrbfnpr::implicit::SheetTreeData&& pieces,
                  const hrbfnpr::fit::FitReport& fit) noexcept
        : Child(context),
          surface(std::in_place_type<hrbfnpr::implicit::SheetTree>, context.runtime.instruction_set, std::move(pieces)),
          report(fit), history(context.runtime.memory) {}
    // Makes a trimmed model with the function of the model `of`. If `found` has a trim, the surface ends where this
    // trim says. If the model `of` is trimmed itself, its own trim is not used.
    hrbfnpr_model(hrbfnpr_context& context, const hrbfnpr_model& of, hrbfnpr::generate::FoundTrim&& found);
    ~hrbfnpr_model();
    // A model that this constructor made calls the caller's release function when it is destroyed.
    hrbfnpr_model(hrbfnpr_context& context, const hrbfnpr::implicit::CustomFunction& custom) noexcept
        : Child(context), surface(std::in_place_type<hrbfnpr::implicit::Custom>, custom),
          history(context.runtime.memory) {}
    hrbfnpr_model(hrbfnpr_context& context, std::unique_ptr<hrbfnpr::api::CsgSolid> solid) noexcept
        : Child(context), surface(std::move(solid)), history(context.runtime.memory) {}

    [[nodiscard]] const hrbfnpr::implicit::Implicit& implicit() const noexcept {
        if (trimmed_) return *trimmed_;
        if (untrimmed_ != nullptr) return untrimmed_->implicit();
        if (const auto* hrbf = std::get_if<hrbfnpr::implicit::Hrbf>(&surface)) return *hrbf;
        if (const hrbfnpr::api::CsgSolid* solid = csg()) return solid->function();
        if (const auto* made = std::get_if<hrbfnpr::implicit::SheetTree>(&surface)) return *made;
        return *std::get_if<hrbfnpr::implicit::Custom>(&surface);
    }
    // Returns nullptr if the model is not a tree, or if it is trimmed.
    [[nodiscard]] const hrbfnpr::api::CsgSolid* csg() const noexcept {
        const auto* solid = std::get_if<std::unique_ptr<hrbfnpr::api::CsgSolid>>(&surface);
        return solid != nullptr ? solid->get() : nullptr;
    }
    // Returns the model without its trim, or this model if it is not trimmed.
    [[nodiscard]] const hrbfnpr_model& untrimmed() const noexcept {
        return untrimmed_ != nullptr ? *untrimmed_ : *this;
    }
    // Stores that no end of the surface was found, for example because the surface is closed. It must be called before
    // other threads use the model.
    void set_trim_report(const hrbfnpr::generate::TrimReport& found) noexcept { trim_.report = found; }
    [[nodiscard]] const hrbfnpr::generate::FoundTrim& trim() const noexcept { return trim_; }
    // Returns the model's function, prepared if that saves time for this number of evaluations. The first such call
    // prepares it.  Any thread may call this.
    [[nodiscard]] const hrbfnpr::implicit::Implicit& implicit_for(double evaluations,
                                                                  const hrbfnpr::base::Progress& progress) const;
    // Returns cells for casting rays if they save time for this number of rays; otherwise, or if the model is not a
    // prepared fit, nullptr. The first such call makes them. Any thread may call this.
    [[nodiscard]] const hrbfnpr::surface::RayCells* ray_cells_for(std::int64_t rays,
                                                                  const hrbfnpr::base::Progress& progress) const;
    // Returns nullptr if the model is not a single fit.
    [[nodiscard]] const hrbfnpr::implicit::HrbfData* data() const noexcept {
        const auto* hrbf = std::get_if<hrbfnpr::implicit::Hrbf>(&untrimmed().surface);
        return hrbf != nullptr ? &hrbf->data() : nullptr;
    }
    // Returns nullptr if the model has no sheets.
    [[nodiscard]] const hrbfnpr::implicit::SheetTreeData* pieces() const noexcept {
        const auto* made = std::get_if<hrbfnpr::implicit::SheetTree>(&untrimmed().surface);
        return made != nullptr ? &made->data() : nullptr;
    }
    // Returns an empty hint for a custom model and for a tree.
    [[nodiscard]] hrbfnpr::generate::SampleHint samples() const noexcept {
        if (const auto* hrbf = data()) return {hrbf->sample_position.span(), hrbf->spacing};
        if (const auto* made = pieces()) return {made->sample_position.span(), made->spacing};
        return {};
    }
    [[nodiscard]] std::span<const double> sample_normals() const noexcept {
        if (const auto* hrbf = data()) return hrbf->sample_normal.span();
        if (const auto* made = pieces()) return made->sample_normal.span();
        return {};
    }

    std::variant<hrbfnpr::implicit::Hrbf, hrbfnpr::implicit::SheetTree, hrbfnpr::implicit::Custom,
                 std::unique_ptr<hrbfnpr::api::CsgSolid>, std::monostate>
        surface; // std::monostate in a trimmed model, which uses the function of untrimmed()
    // `report` and `history` are set only in a model that is not trimmed.
    hrbfnpr::fit::FitReport report;
    // The residuals after the iterations of a fit; empty if the model is not a fit.
    hrbfnpr::base::Array<double> history;

private:
    // The number of ways to prepare a model. Way 0 prepares the HRBF, or the zones of the pieces. Way 1 prepares both
    // zones and sheets.
    static constexpr std::size_t ways = 2;
    // Returns the way that saves time for this number of evaluations, or `ways` if no way does.
    [[nodiscard]] std::size_t preparation_for(double evaluations) const noexcept;
    [[nodiscard]] std::unique_ptr<hrbfnpr::implicit::Implicit> prepare(std::size_t way,
                                                                       const hrbfnpr::base::Progress& progress) const;
    [[nodiscard]] const hrbfnpr::implicit::Implicit& trimmed(const hrbfnpr::implicit::Implicit& prepared) const;

    const hrbfnpr_model* untrimmed_ = nullptr; // the model without the trim; null if this model is not trimmed
    hrbfnpr::generate::FoundTrim trim_;
    std::optional<hrbfnpr::implicit::Trimmed> trimmed_;
    mutable std::mutex preparing_;
    struct Preparation {
        bool tried = false;
        std::unique_ptr<hrbfnpr::implicit::Implicit> implicit; // null if the prepared function would not be accurate
    };
    mutable std::array<Preparation, ways> preparations_;
    mutable std::unique_ptr<hrbfnpr::surface::RayCells> ray_cells_; // made from the prepared HRBF of preparations_
    // The prepared functions of untrimmed() with this model's trim, in the order of preparations_.
    mutable std::array<std::optional<hrbfnpr::implicit::Trimmed>, ways> ready_trimmed_;
};
