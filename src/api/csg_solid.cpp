// SPDX-License-Identifier: MIT
#include "api/csg_solid.h"

#include "api/model.h"
#include "surface/region.h"

namespace hrbfnpr::api {

CsgSolid::~CsgSolid() {
    for (const hrbfnpr_model* model : models_) release_handle(model);
}

void CsgSolid::require_room(std::int64_t more) const {
    if (tree_.size() + more > implicit::most_csg_nodes)
        fail(Status::invalid_argument,
             "csg_desc has more than %lld nodes, with those of the trees in its models; remove nodes, or fit one model "
             "to a subtree",
             static_cast<long long>(implicit::most_csg_nodes));
}

std::int64_t CsgSolid::leaf(const hrbfnpr_model& model) {
    for (std::int64_t i = 0; i < models_.size(); ++i)
        if (models_[i] == &model) return i;
    models_.push_back(&model);
    model.add_reference();
    return models_.size() - 1;
}

std::int64_t CsgSolid::add(const implicit::CsgNode& node) {
    require_room(1);
    tree_.push_back(node);
    return tree_.size() - 1;
}

std::int64_t CsgSolid::add(const CsgSolid& of, const implicit::CsgNode& in_place_of) {
    require_room(of.tree_.size());
    const std::int64_t first = tree_.size();
    base::Array<std::int64_t> number(runtime_.memory);
    for (const hrbfnpr_model* model : of.models_) number.push_back(leaf(*model));
    for (implicit::CsgNode node : of.tree_) {
        if (node.model >= 0) node.model = number[node.model];
        node.parent += first;
        tree_.push_back(node);
    }
    implicit::CsgNode& root = tree_[first];
    root.parent = in_place_of.parent;
    root.translation = in_place_of.linear * root.translation + in_place_of.translation;
    root.linear = in_place_of.linear * root.linear;
    return first;
}

void CsgSolid::plan() {
    base::Array<implicit::CsgModel> known(runtime_.memory);
    for (const hrbfnpr_model* model : models_) {
        const implicit::Implicit& f = model->implicit();
        const implicit::Sheets* const sheets = f.sheets();
        known.push_back(
            {f.bounds(), surface::search_region(f), sheets != nullptr ? sheets->count() : 1, f.lipschitz()});
    }
    plan_ = std::make_unique<implicit::CsgPlan>(runtime_.memory, tree_, known);
}

void CsgSolid::finish(const geometry::Bounds& bounds) {
    base::Array<const implicit::Implicit*> leaves(runtime_.memory);
    for (const hrbfnpr_model* model : models_) leaves.push_back(&model->implicit());
    function_ = std::make_unique<implicit::Csg>(runtime_, *plan_, std::move(leaves), bounds);
}

const implicit::Implicit& CsgSolid::implicit_for(double evaluations, const base::Progress& progress) const {
    base::Array<const implicit::Implicit*> leaves(runtime_.memory);
    for (const hrbfnpr_model* model : models_) leaves.push_back(&model->implicit_for(evaluations, progress));
    const auto has = [&](const implicit::Csg& csg) {
        return std::equal(leaves.begin(), leaves.end(), csg.leaves().begin());
    };
    if (has(*function_)) return *function_;
    const std::scoped_lock lock(preparing_);
    for (const auto& csg : prepared_)
        if (has(*csg)) return *csg;
    prepared_.push_back(std::make_unique<implicit::Csg>(runtime_, *plan_, std::move(leaves), function_->bounds()));
    return *prepared_.back();
}

std::int64_t CsgSolid::depth() const {
    base::Array<std::int64_t> level(runtime_.memory, tree_.size());
    std::int64_t deepest = 0;
    for (std::int64_t i = 0; i < tree_.size(); ++i) {
        level[i] = tree_[i].parent < 0 ? 1 : level[tree_[i].parent] + 1;
        deepest = std::max(deepest, level[i]);
    }
    return deepest;
}

} // namespace hrbfnpr::api
