#include "sampling/progressive_order.h"

#include "base/random.h"
#include "geometry/point_tree.h"

#include <algorithm>
#include <limits>

namespace hrbfnpr::sampling {
namespace {

constexpr double radius_factor = 0.96;

class Darts {
public:
    Darts(const Site& site, const geometry::VecArray& position, const geometry::VecArray& normal,
          const base::Progress& progress)
        : site_(site), tree_(position, progress), normal_(site.memory(), position.size()),
          clearance_(site.memory(), position.size()), open_(site.memory()), order_(site.memory()) {
        for (std::int64_t at = 0; at < tree_.size(); ++at) {
            normal_.set(at, normal[tree_.index(at)]);
            clearance_[at] = std::numeric_limits<double>::infinity();
        }
    }

    base::Array<std::int64_t> run(std::int64_t wanted, const base::Progress& progress);

private:
    struct Open {
        std::uint64_t ticket;
        std::int64_t at;
        [[nodiscard]] bool operator<(const Open& other) const noexcept {
            return ticket != other.ticket ? ticket < other.ticket : at < other.at;
        }
    };

    void find_open(double squared_radius, const base::Progress& progress);
    void accept(std::int64_t at, double radius);

    const Site& site_;
    geometry::PointTree tree_;
    geometry::VecArray normal_; // in the tree's order
    // Squared distance to the nearest accepted point on the same side; only known to be more than
    // the radius until it is less.
    base::Array<double> clearance_;
    base::Array<Open> open_; // candidates of this pass, in random order
    base::Array<std::int64_t> order_;
};

void Darts::find_open(double squared_radius, const base::Progress& progress) {
    open_.clear();
    for (std::int64_t at = 0; at < tree_.size(); ++at) {
        if (at % 65536 == 0) progress.check();
        if (clearance_[at] < squared_radius) continue;
        const auto index = static_cast<std::uint64_t>(tree_.index(at));
        const base::Philox bits = base::philox(
            site_.random_seed, {static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(index >> 32U),
                                static_cast<std::uint32_t>(base::Purpose::candidate_order), 0});
        open_.push_back({static_cast<std::uint64_t>(bits[0]) << 32U | bits[1], at});
    }
    std::sort(open_.begin(), open_.end());
}

void Darts::accept(std::int64_t at, double radius) {
    order_.push_back(tree_.index(at));
    const glm::dvec3 n = normal_[at];
    tree_.within(tree_.points()[at], radius, [&](std::int64_t other, double squared) {
        if (squared < clearance_[other] && glm::dot(n, normal_[other]) >= 0.0) clearance_[other] = squared;
    });
}

base::Array<std::int64_t> Darts::run(std::int64_t wanted, const base::Progress& progress) {
    const double widest = tree_.bounds().diagonal();
    const double narrowest = 1e-7 * widest; // closer points are the same to float positions
    order_.reserve(std::min(wanted, tree_.size()));
    for (double radius = widest; radius > narrowest && order_.size() < wanted; radius *= radius_factor) {
        find_open(radius * radius, progress);
        for (const Open& open : open_) {
            if (order_.size() == wanted) break;
            if (clearance_[open.at] >= radius * radius) accept(open.at, radius);
            if (order_.size() % 256 == 0) progress.check();
        }
        progress.update(static_cast<double>(order_.size()) / static_cast<double>(wanted));
    }
    if (order_.empty() && wanted > 0 && tree_.size() > 0) order_.push_back(0); // all points are one
    return std::move(order_);
}

} // namespace

base::Array<std::int64_t> progressive_order(const Site& site, const geometry::VecArray& position,
                                            const geometry::VecArray& normal, std::int64_t wanted,
                                            const base::Progress& progress) {
    Darts darts(site, position, normal, progress);
    return darts.run(wanted, progress);
}

} // namespace hrbfnpr::sampling
