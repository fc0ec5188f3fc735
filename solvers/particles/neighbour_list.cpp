#include "solvers/particles/neighbour_list.hpp"

#include "solvers/particles/pair_search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace searle::solvers::particles {
namespace {

template <class Value>
void permute(AlignedVector<Value>& column, const AlignedVector<int>& from,
             AlignedVector<Value>& scratch) {
    scratch.resize(column.size());
    for (std::size_t i = 0; i < column.size(); ++i)
        scratch[i] = column[static_cast<std::size_t>(from[i])];
    column.swap(scratch);
}

/// Back into the box; who leaves through the top of a Lees-Edwards box enters at the bottom with
/// the velocity of that place.
void wrap(ParticleStore& p, const ShearBox& box) {
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (!box.walls) {
            const double turns = std::floor(p.y[i] / box.length_y);
            p.y[i] -= turns * box.length_y;
            p.x[i] -= turns * box.image_offset;
            p.vx[i] -= turns * box.image_speed;
        }
        p.x[i] -= box.length_x * std::floor(p.x[i] / box.length_x);
        p.z[i] -= box.length_z * std::floor(p.z[i] / box.length_z);
    }
}

/// Cells at least `size` long, and not many more than particles.
int cells_along(double length, double size, std::size_t particles) {
    const int most = 3 + static_cast<int>(2.0 * std::cbrt(static_cast<double>(particles)));
    return static_cast<int>(std::clamp(length / size, 1.0, static_cast<double>(most)));
}

int cell_of(double position, double length, int cells) {
    return std::clamp(static_cast<int>(position / length * cells), 0, cells - 1);
}

} // namespace

bool NeighbourList::is_stale_after(const ParticleStore& particles, double moved, double strain) {
    moved_ += moved;
    strain_ += strain;
    if (rebuilds_ == 0)
        return true;
    if (!is_used_up())
        return false;
    moved_ = way_since_rebuild(particles);
    return is_used_up();
}

bool NeighbourList::is_used_up() const {
    const double sheared = std::abs(strain_) * largest_distance_;
    return sheared + 2.0 * moved_ * (1.0 + std::abs(strain_)) > skin_;
}

/// The longest way of a particle beside the mean shear, which carries it by strain times y.
double NeighbourList::way_since_rebuild(const ParticleStore& particles) const {
    const auto count = static_cast<long>(particles.size());
    const double *x = particles.x.data(), *y = particles.y.data(), *z = particles.z.data();
    const double *from_x = built_x.data(), *from_y = built_y.data(), *from_z = built_z.data();
    const double strain = strain_;
    double largest = 0.0;
#pragma omp simd reduction(max : largest)
    for (long i = 0; i < count; ++i) {
        const double dx = x[i] - from_x[i] - strain * from_y[i];
        const double dy = y[i] - from_y[i];
        const double dz = z[i] - from_z[i];
        const double squared = dx * dx + dy * dy + dz * dz;
        largest = squared > largest ? squared : largest;
    }
    return std::sqrt(largest);
}

void NeighbourList::rebuild(ParticleStore& particles, ShearBox& box,
                            std::span<Column* const> companions) {
    const double cell_size = 2.0 * particles.largest_radius() + reach_ + skin_;
    const double shortest =
        std::min({box.length_x, box.length_z, box.walls ? 1e300 : box.length_y});
    if (shortest < 2.0 * cell_size)
        throw std::invalid_argument("the box is shorter than twice the reach of the pair forces");
    AlignedVector<Spring> springs = kept_springs();
    wrap(particles, box);
    const AlignedVector<int> new_place = sort(particles, box, cell_size, companions);
    find_pairs(particles, box);
    find_wall_neighbours(particles, box);
    restore(springs, new_place);
    built_x = particles.x;
    built_y = particles.y;
    built_z = particles.z;
    largest_distance_ = cell_size;
    moved_ = 0.0;
    strain_ = 0.0;
    ++rebuilds_;
}

AlignedVector<int> NeighbourList::sort(ParticleStore& particles, const ShearBox& box,
                                       double cell_size, std::span<Column* const> companions) {
    cells_x_ = cells_along(box.length_x, cell_size, particles.size());
    cells_y_ = cells_along(box.length_y, cell_size, particles.size());
    cells_z_ = cells_along(box.length_z, cell_size, particles.size());
    const std::size_t count = particles.size();
    AlignedVector<int> cell(count);
    cell_start_.assign(static_cast<std::size_t>(cells_x_) * static_cast<std::size_t>(cells_y_) *
                               static_cast<std::size_t>(cells_z_) +
                           1,
                       0);
    for (std::size_t i = 0; i < count; ++i) {
        const int at_x = cell_of(particles.x[i], box.length_x, cells_x_);
        const int at_y = cell_of(particles.y[i], box.length_y, cells_y_);
        const int at_z = cell_of(particles.z[i], box.length_z, cells_z_);
        cell[i] = (at_z * cells_y_ + at_y) * cells_x_ + at_x;
        ++cell_start_[static_cast<std::size_t>(cell[i]) + 1];
    }
    std::partial_sum(cell_start_.begin(), cell_start_.end(), cell_start_.begin());
    AlignedVector<int> next(cell_start_.begin(), cell_start_.end() - 1);
    AlignedVector<int> from(count);
    AlignedVector<int> new_place(count);
    for (std::size_t i = 0; i < count; ++i) {
        new_place[i] = next[static_cast<std::size_t>(cell[i])]++;
        from[static_cast<std::size_t>(new_place[i])] = static_cast<int>(i);
    }
    Column scratch;
    AlignedVector<int> scratch_id;
    for (Column* column : particles.columns())
        permute(*column, from, scratch);
    for (Column* column : companions)
        permute(*column, from, scratch);
    permute(particles.id, from, scratch_id);
    for (Column* column : {&lower_x, &lower_z, &upper_x, &upper_z}) {
        column->resize(count, 0.0);
        permute(*column, from, scratch);
    }
    return new_place;
}

void NeighbourList::find_pairs(const ParticleStore& p, const ShearBox& box) {
    PairSearch search(p, box, reach_ + skin_, first, second);
    // With fewer cells a neighbour would be met twice; then every pair is looked at.
    const int least_x = box.walls ? 3 : 5;
    if (cells_x_ < least_x || cells_z_ < 3 || (!box.walls && cells_y_ < 3)) {
        search.start();
        search.add_candidates(0, static_cast<int>(p.size()));
        search.find<true>(0, static_cast<int>(p.size()));
        return;
    }
    // Of each cell: itself, the next in x, and the rows of half of the neighbours.
    constexpr int rows[4][2] = {{1, 0}, {-1, 1}, {0, 1}, {1, 1}};
    const int shift =
        static_cast<int>(std::floor(box.image_offset / box.length_x * cells_x_)) % cells_x_;
    // Divisions cost more than the whole rest here, and no place is far outside.
    const auto into_row = [&](int ix) {
        while (ix < 0)
            ix += cells_x_;
        while (ix >= cells_x_)
            ix -= cells_x_;
        return ix;
    };
    // Cells low ... high of a row, which goes on at its start; neighbours in x are one range.
    const auto add_row = [&](int iy, int iz, int low, int high) {
        const int row = (iz * cells_y_ + iy) * cells_x_;
        const auto add = [&](int from, int to) {
            search.add_candidates(cell_start_[static_cast<std::size_t>(row + from)],
                                  cell_start_[static_cast<std::size_t>(row + to)]);
        };
        low = into_row(low);
        high = into_row(high);
        if (low <= high)
            return add(low, high + 1);
        add(low, cells_x_);
        add(0, high + 1);
    };
    for (int at_z = 0; at_z < cells_z_; ++at_z)
        for (int at_y = 0; at_y < cells_y_; ++at_y)
            for (int at_x = 0; at_x < cells_x_; ++at_x) {
                const auto own =
                    static_cast<std::size_t>((at_z * cells_y_ + at_y) * cells_x_ + at_x);
                if (cell_start_[own] == cell_start_[own + 1])
                    continue;
                search.start();
                search.add_candidates(cell_start_[own], cell_start_[own + 1]);
                add_row(at_y, at_z, at_x + 1, at_x + 1);
                for (const auto& row : rows) {
                    int iy = at_y + row[0];
                    const int iz = at_z + row[1] < cells_z_ ? at_z + row[1] : 0;
                    if (iy >= 0 && iy < cells_y_) {
                        add_row(iy, iz, at_x - 1, at_x + 1);
                    } else if (!box.walls) {
                        // The image above stands image_offset ahead.
                        const bool up = iy >= cells_y_;
                        const int ahead = at_x + (up ? -shift : shift);
                        iy = up ? 0 : cells_y_ - 1;
                        add_row(iy, iz, ahead - (up ? 2 : 1), ahead + (up ? 1 : 2));
                    }
                }
                const bool inside = at_x > 0 && at_x < cells_x_ - 1 && at_y < cells_y_ - 1 &&
                                    at_z > 0 && at_z < cells_z_ - 1 && (at_y > 0 || box.walls);
                if (inside)
                    search.find<false>(cell_start_[own], cell_start_[own + 1]);
                else
                    search.find<true>(cell_start_[own], cell_start_[own + 1]);
            }
}

void NeighbourList::find_wall_neighbours(const ParticleStore& p, const ShearBox& box) {
    near_lower.clear();
    near_upper.clear();
    if (!box.walls)
        return;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double limit = p.radius[i] + reach_ + skin_;
        if (p.y[i] < limit)
            near_lower.push_back(static_cast<int>(i));
        if (box.length_y - p.y[i] < limit)
            near_upper.push_back(static_cast<int>(i));
    }
}

AlignedVector<NeighbourList::Spring> NeighbourList::kept_springs() const {
    AlignedVector<Spring> kept;
    for (std::size_t k = 0; k < first.size(); ++k)
        if (spring_x[k] != 0.0 || spring_y[k] != 0.0 || spring_z[k] != 0.0)
            kept.push_back({first[k], second[k], spring_x[k], spring_y[k], spring_z[k]});
    return kept;
}

void NeighbourList::restore(AlignedVector<Spring>& springs, const AlignedVector<int>& new_place) {
    const std::size_t count = first.size();
    spring_x.assign(count, 0.0);
    spring_y.assign(count, 0.0);
    spring_z.assign(count, 0.0);
    if (springs.empty())
        return;
    // Springs of each particle as the first of its pair, looked up for every pair. Both lists go
    // through space in about the same order, so that the look-ups stay near each other in memory.
    AlignedVector<int> start(new_place.size() + 1, 0);
    for (Spring& spring : springs) {
        spring.first = new_place[static_cast<std::size_t>(spring.first)];
        spring.second = new_place[static_cast<std::size_t>(spring.second)];
        if (spring.first > spring.second)
            spring = {spring.second, spring.first, -spring.x, -spring.y, -spring.z};
        ++start[static_cast<std::size_t>(spring.first) + 1];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    AlignedVector<int> order(springs.size());
    AlignedVector<int> next(start.begin(), start.end() - 1);
    for (std::size_t s = 0; s < springs.size(); ++s)
        order[static_cast<std::size_t>(next[static_cast<std::size_t>(springs[s].first)]++)] =
            static_cast<int>(s);
    for (std::size_t k = 0; k < count; ++k) {
        const auto low = static_cast<std::size_t>(first[k]);
        for (int at = start[low]; at < start[low + 1]; ++at) {
            const Spring& spring =
                springs[static_cast<std::size_t>(order[static_cast<std::size_t>(at)])];
            if (spring.second != second[k])
                continue;
            spring_x[k] = spring.x;
            spring_y[k] = spring.y;
            spring_z[k] = spring.z;
            break;
        }
    }
}

} // namespace searle::solvers::particles
