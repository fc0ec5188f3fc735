#include "solvers/suspension/resistance_solver.hpp"

#include "laws/drag/stokes.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace searle::solvers::suspension {
namespace {

constexpr int most_iterations = 2000;

using Block = Eigen::Matrix<double, 6, 6>;

} // namespace

ResistanceSolver::ResistanceSolver(std::size_t count, double viscosity, double length_unit,
                                   int threads)
    : viscosity_(viscosity), length_unit_(length_unit), threads_(threads), resistance_(threads),
      blocks_(count), paired_(count), drag_(count), turning_drag_(count) {
    for (Motions* each : {&residual_, &direction_, &image_, &scaled_})
        each->assign(motions_for(count), Motion{});
}

void ResistanceSolver::prepare(const particles::ParticleStore& particles,
                               const particles::AlignedVector<NearPair>& pairs) {
    const std::size_t count = particles.size();
    resistance_.take(pairs, count);
    height_ = particles.y;
    paired_.assign(count, 0);
    for (const NearPair& c : pairs) {
        paired_[static_cast<std::size_t>(c.first)] = 1;
        if (const auto second = static_cast<std::size_t>(c.second); second < count)
            paired_[second] = 1;
    }
    for (std::size_t i = 0; i < count; ++i) {
        drag_[i] = laws::drag::Stokes{viscosity_, 0.0}.coefficient(particles.radius[i], 0, 1);
        turning_drag_[i] = laws::drag::rotational_coefficient(viscosity_, particles.radius[i]) /
                           (length_unit_ * length_unit_);
        if (paired_[i] == 0)
            continue;
        Eigen::Map<Block> block(blocks_[i].data());
        block.setZero();
        block.diagonal().head<3>().setConstant(drag_[i]);
        block.diagonal().tail<3>().setConstant(turning_drag_[i]);
    }
    const auto add = [&](int particle, const NearPair& c, double lever, double mixed, double sign) {
        Eigen::Map<Block> block(blocks_[static_cast<std::size_t>(particle)].data());
        const Eigen::Vector3d n(c.nx, c.ny, c.nz);
        const Eigen::Matrix3d along = n * n.transpose();
        const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - along;
        block.topLeftCorner<3, 3>() += c.squeeze * along + c.shear * across;
        block.bottomRightCorner<3, 3>() +=
            (c.shear * lever * lever + 2.0 * mixed * lever + c.pump) * across + c.twist * along;
        Eigen::Matrix3d cross;
        cross << 0.0, -n.z(), n.y(), n.z(), 0.0, -n.x(), -n.y(), n.x(), 0.0;
        const Eigen::Matrix3d coupling = sign * (c.shear * lever + mixed) * cross;
        block.topRightCorner<3, 3>() += coupling;
        block.bottomLeftCorner<3, 3>() += coupling.transpose();
    };
    for (const NearPair& c : pairs) {
        add(c.first, c, c.lever_first, c.mixed, -1.0);
        if (static_cast<std::size_t>(c.second) < count)
            add(c.second, c, c.lever_second, -c.mixed, 1.0);
    }
#pragma omp parallel for num_threads(threads_) if (threads_ > 1) schedule(static)
    for (std::size_t i = 0; i < count; ++i) {
        if (paired_[i] == 0)
            continue;
        Eigen::Map<Block> block(blocks_[i].data());
        const Block inverse = block.llt().solve(Block::Identity());
        block = inverse;
    }
}

/// Sums of blocks of one size, added in their order: the same for any number of threads.
double ResistanceSolver::dot(const Motions& a, const Motions& b) const {
    constexpr std::size_t size = 1024;
    const std::size_t blocks = (a.size() + size - 1) / size;
    std::vector<double> sums(blocks);
#pragma omp parallel for num_threads(threads_) if (threads_ > 1) schedule(static)
    for (std::size_t block = 0; block < blocks; ++block) {
        double sum[8] = {};
        for (std::size_t i = block * size; i < std::min(a.size(), (block + 1) * size); ++i)
            for (std::size_t c = 0; c < 8; ++c)
                sum[c] += a[i][c] * b[i][c];
        for (const double each : sum)
            sums[block] += each;
    }
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

void ResistanceSolver::apply(const Motions& in, MixtureProfile* profile, Motions& out) {
    const std::size_t count = drag_.size();
#pragma omp parallel for num_threads(threads_) if (threads_ > 1) schedule(static)
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < 8; ++c)
            out[i][c] = (c < 3 ? drag_[i] : turning_drag_[i]) * in[i][c];
    out[count] = out[count + 1] = {};
    resistance_.add(in, out);
    out[count] = out[count + 1] = {}; // what pushes the walls is no equation here
    if (profile != nullptr)
        profile->subtract_response(in, out);
}

void ResistanceSolver::precondition(const Motions& in, Motions& out) const {
#pragma omp parallel for num_threads(threads_) if (threads_ > 1) schedule(static)
    for (std::size_t i = 0; i < drag_.size(); ++i) {
        if (paired_[i] == 0) {
            for (std::size_t c = 0; c < 8; ++c)
                out[i][c] = in[i][c] / (c < 3 ? drag_[i] : turning_drag_[i]);
            continue;
        }
        const Eigen::Map<const Block> block(blocks_[i].data());
        Eigen::Map<Eigen::Matrix<double, 6, 1>>(out[i].data()).noalias() =
            block * Eigen::Map<const Eigen::Matrix<double, 6, 1>>(in[i].data());
    }
}

double ResistanceSolver::work_in_shear(const Motions& forces, double rate) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < height_.size(); ++i)
        sum += forces[i][0] * height_[i] - 0.5 * length_unit_ * forces[i][5];
    return rate * sum;
}

ResistanceSolver::Outcome ResistanceSolver::solve(MixtureProfile* profile, const Goal& goal,
                                                  const Motions& forces, Motions& motions) {
    const std::size_t count = drag_.size();
    // Who has no near pair moves with the flow; the step before may have been another.
    for (std::size_t i = 0; i < count && profile == nullptr; ++i)
        if (paired_[i] == 0)
            motions[i] = {};
    apply(motions, profile, image_);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < 8; ++c)
            residual_[i][c] = forces[i][c] - image_[i][c];
    // Sizes in the norm of the preconditioner, which weighs stiff and free particles alike.
    precondition(forces, scaled_);
    const double least = goal.residual_share * goal.residual_share * dot(forces, scaled_);
    if (least == 0.0)
        for (Motion& each : motions)
            each = {};
    precondition(residual_, scaled_);
    double size = dot(residual_, scaled_);
    direction_ = scaled_;
    const auto is_enough = [&] {
        return size <= least &&
               (goal.shear_rate == 0.0 ||
                std::abs(work_in_shear(residual_, goal.shear_rate)) <= goal.largest_work);
    };
    Outcome outcome;
    outcome.converged = least == 0.0 || is_enough();
    while (!outcome.converged && outcome.iterations < most_iterations) {
        ++outcome.iterations;
        apply(direction_, profile, image_);
        const double along = size / dot(direction_, image_);
#pragma omp parallel for num_threads(threads_) if (threads_ > 1) schedule(static)
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t c = 0; c < 8; ++c) {
                motions[i][c] += along * direction_[i][c];
                residual_[i][c] -= along * image_[i][c];
            }
        precondition(residual_, scaled_);
        const double before = size;
        size = dot(residual_, scaled_);
        outcome.converged = is_enough();
        if (!std::isfinite(size))
            break;
        const double keep = size / before;
#pragma omp parallel for num_threads(threads_) if (threads_ > 1) schedule(static)
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t c = 0; c < 8; ++c)
                direction_[i][c] = scaled_[i][c] + keep * direction_[i][c];
    }
    outcome.residual = least > 0.0 ? std::sqrt(size / least) * goal.residual_share : 0.0;
    return outcome;
}

} // namespace searle::solvers::suspension
