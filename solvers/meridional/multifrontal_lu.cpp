#include "solvers/meridional/multifrontal_lu.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace searle::solvers::meridional {
namespace {

using Index = Eigen::Index;

/// A mesh is cut so that neither part has less than this share of the elements.
constexpr double smallest_part = 0.3;

std::size_t at(int unknown) { return static_cast<std::size_t>(unknown); }

} // namespace

/// Divides the mesh, and decides which front eliminates what.
class MultifrontalLu::Dissection {
public:
    Dissection(const std::vector<ElementUnknowns>& elements, int size, std::vector<Front>& fronts)
        : elements_(elements), fronts_(fronts), around_(at(size)), is_multiplier_(at(size)),
          in_part_(at(size)), before_(at(size)), stamp_(elements.size()), leader_(elements.size()) {
        std::iota(leader_.begin(), leader_.end(), std::size_t{0});
        std::vector<std::size_t> all(elements.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        for (const std::size_t e : all) {
            multiplier_.push_back(elements[e].multiplier);
            if (elements[e].multiplier >= 0) {
                is_multiplier_[at(elements[e].multiplier)] = true;
            }
            for (const int unknown : elements[e].unknown) {
                if (unknown >= 0) {
                    around_[at(unknown)].push_back(e);
                }
            }
        }
        divide(all);
    }

private:
    struct Cut {
        std::vector<std::size_t> order; ///< of the elements
        std::size_t first_part{};       ///< elements before the cut
        int passed{};                   ///< unknowns on the cut
    };

    /// Of the cuts across one coordinate the one that passes the fewest unknowns, then the most
    /// even.
    Cut best_cut(std::vector<std::size_t> part, double ElementUnknowns::*coordinate) {
        std::stable_sort(part.begin(), part.end(), [&](std::size_t one, std::size_t other) {
            return elements_[one].*coordinate < elements_[other].*coordinate;
        });
        for (const std::size_t e : part) {
            for (const int unknown : elements_[e].unknown) {
                if (unknown >= 0) {
                    ++in_part_[at(unknown)];
                }
            }
        }
        const auto least =
            std::max(std::size_t{1},
                     static_cast<std::size_t>(smallest_part * static_cast<double>(part.size())));
        const auto offset = [&](std::size_t first) {
            return std::abs(2 * static_cast<long>(first) - static_cast<long>(part.size()));
        };
        Cut best;
        int passed = 0;
        for (std::size_t first = 1; first + least <= part.size(); ++first) {
            for (const int unknown : elements_[part[first - 1]].unknown) {
                if (unknown < 0 || in_part_[at(unknown)] == 1) {
                    continue;
                }
                const int now = ++before_[at(unknown)];
                passed += now == 1 ? 1 : now == in_part_[at(unknown)] ? -1 : 0;
            }
            if (first >= least &&
                (best.first_part == 0 || std::pair(passed, offset(first)) <
                                             std::pair(best.passed, offset(best.first_part)))) {
                best.first_part = first;
                best.passed = passed;
            }
        }
        for (const std::size_t e : part) {
            for (const int unknown : elements_[e].unknown) {
                if (unknown >= 0) {
                    in_part_[at(unknown)] = before_[at(unknown)] = 0;
                }
            }
        }
        best.order = std::move(part);
        return best;
    }

    /// Makes the front of these elements after those of its parts; its number.
    std::size_t divide(const std::vector<std::size_t>& part) {
        Front front;
        if (part.size() == 1) {
            front.element = part.front();
            finish(front, part, {elements_[part.front()].unknown});
        } else {
            Cut across = best_cut(part, &ElementUnknowns::radius);
            Cut along = best_cut(part, &ElementUnknowns::height);
            const Cut& cut = across.passed < along.passed ? across : along;
            const auto middle = cut.order.begin() + static_cast<std::ptrdiff_t>(cut.first_part);
            const std::size_t one = divide({cut.order.begin(), middle});
            const std::size_t other = divide({middle, cut.order.end()});
            front.parts = {one, other};
            finish(front, part, {fronts_[one].kept, fronts_[other].kept});
        }
        fronts_.push_back(std::move(front));
        return fronts_.size() - 1;
    }

    std::size_t leader_of(std::size_t element) {
        while (leader_[element] != element) {
            element = leader_[element] = leader_[leader_[element]];
        }
        return element;
    }

    /// Joins the two pieces beside an edge's unknown, through which fluid can pass now; the
    /// multiplier that this determines, or -1.
    int join(int unknown) {
        const std::vector<std::size_t>& sides = around_[at(unknown)];
        if (sides.size() != 2) {
            return -1;
        }
        std::size_t one = leader_of(sides[0]);
        std::size_t other = leader_of(sides[1]);
        if (one == other) {
            return -1;
        }
        if (multiplier_[other] < 0) {
            std::swap(one, other);
        }
        leader_[other] = one;
        return multiplier_[other];
    }

    /// @param present  unknowns of the element, or what each part keeps
    void finish(Front& front, const std::vector<std::size_t>& part,
                const std::vector<std::vector<int>>& present) {
        ++latest_stamp_;
        for (const std::size_t element : part) {
            stamp_[element] = latest_stamp_;
        }
        const auto is_of_part = [&](std::size_t element) {
            return stamp_[element] == latest_stamp_;
        };
        std::vector<int> all;
        for (const std::vector<int>& unknowns : present) {
            std::copy_if(unknowns.begin(), unknowns.end(), std::back_inserter(all),
                         [](int unknown) { return unknown >= 0; });
        }
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        for (const int unknown : all) {
            const std::vector<std::size_t>& sides = around_[at(unknown)];
            if (is_multiplier_[at(unknown)] ||
                !std::all_of(sides.begin(), sides.end(), is_of_part)) {
                continue;
            }
            front.eliminated.push_back(unknown);
            if (const int determined = join(unknown); determined >= 0) {
                front.eliminated.push_back(determined);
            }
        }
        std::sort(front.eliminated.begin(), front.eliminated.end());
        std::set_difference(all.begin(), all.end(), front.eliminated.begin(),
                            front.eliminated.end(), std::back_inserter(front.kept));
        for (const std::vector<int>& unknowns : present) {
            std::vector<int> place;
            for (const int unknown : unknowns) {
                place.push_back(unknown < 0 ? -1 : place_of(front, unknown));
            }
            front.place.push_back(std::move(place));
        }
    }

    static int place_of(const Front& front, int unknown) {
        const auto in = [&](const std::vector<int>& sorted) {
            const auto found = std::lower_bound(sorted.begin(), sorted.end(), unknown);
            return found != sorted.end() && *found == unknown ? found - sorted.begin() : -1;
        };
        const std::ptrdiff_t place = in(front.eliminated);
        return static_cast<int>(place >= 0 ? place : std::ssize(front.eliminated) + in(front.kept));
    }

    const std::vector<ElementUnknowns>& elements_;
    std::vector<Front>& fronts_;
    std::vector<std::vector<std::size_t>> around_; ///< elements around each unknown
    std::vector<bool> is_multiplier_;
    std::vector<int> in_part_; ///< elements around an unknown in the part that is being cut ...
    std::vector<int> before_;  ///< ... and before the cut
    std::vector<int> stamp_;   ///< of each element: the front that asked for it last
    int latest_stamp_{};
    std::vector<std::size_t> leader_; ///< of each element, in the piece it is joined to
    std::vector<int> multiplier_;     ///< of a leader's piece; -1: known
};

MultifrontalLu::MultifrontalLu(const std::vector<ElementUnknowns>& elements, int size) {
    Dissection(elements, size, fronts_);
}

bool MultifrontalLu::factorise(const Assembly& assemble) {
    std::vector<Eigen::MatrixXd> waiting; // matrices of parts that are to be joined
    Eigen::MatrixXd whole;
    Eigen::MatrixXd part;
    for (Front& front : fronts_) {
        const auto eliminated = std::ssize(front.eliminated);
        const auto kept = std::ssize(front.kept);
        whole.setZero(eliminated + kept, eliminated + kept);
        for (auto place = front.place.rbegin(); place != front.place.rend(); ++place) {
            if (front.parts.empty()) {
                assemble(front.element, part);
            } else {
                part = std::move(waiting.back());
                waiting.pop_back();
            }
            for (std::size_t column = 0; column < place->size(); ++column) {
                const int to = (*place)[column];
                if (to < 0) {
                    continue;
                }
                const double* const from = &part(0, static_cast<Index>(column));
                double* const into = &whole(0, to);
                for (std::size_t row = 0; row < place->size(); ++row) {
                    if ((*place)[row] >= 0) {
                        into[(*place)[row]] += from[row];
                    }
                }
            }
        }
        if (eliminated > 0) {
            front.pivots.compute(whole.topLeftCorner(eliminated, eliminated));
            const auto diagonal = front.pivots.matrixLU().diagonal().array();
            if (!diagonal.isFinite().all() || (diagonal == 0.0).any()) {
                return false;
            }
        }
        part = whole.bottomRightCorner(kept, kept);
        // Nothing is kept of the whole mesh.
        if (eliminated > 0 && kept > 0) {
            front.to_eliminated = front.pivots.solve(whole.topRightCorner(eliminated, kept));
            front.from_eliminated = whole.bottomLeftCorner(kept, eliminated);
            part.noalias() -= front.from_eliminated * front.to_eliminated;
        }
        waiting.push_back(std::move(part));
    }
    return fronts_.back().kept.empty();
}

Eigen::VectorXd MultifrontalLu::solve(const Eigen::VectorXd& load) const {
    Eigen::VectorXd found = load;
    for (const Front& front : fronts_) {
        if (!front.eliminated.empty()) {
            found(front.eliminated) = front.pivots.solve(found(front.eliminated)).eval();
        }
        if (!front.eliminated.empty() && !front.kept.empty()) {
            found(front.kept) -= front.from_eliminated * found(front.eliminated);
        }
    }
    for (auto front = fronts_.rbegin(); front != fronts_.rend(); ++front) {
        if (!front->eliminated.empty() && !front->kept.empty()) {
            found(front->eliminated) -= front->to_eliminated * found(front->kept);
        }
    }
    return found;
}

double MultifrontalLu::multiplications() const {
    double sum = 0.0;
    for (const Front& front : fronts_) {
        const auto eliminated = static_cast<double>(front.eliminated.size());
        const auto kept = static_cast<double>(front.kept.size());
        sum += eliminated * (eliminated * eliminated / 3.0 + eliminated * kept + kept * kept);
    }
    return sum;
}

} // namespace searle::solvers::meridional
