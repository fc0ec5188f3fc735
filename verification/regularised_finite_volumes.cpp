#include "verification/regularised_finite_volumes.hpp"

#include <algorithm>
#include <cmath>

namespace searle::verification {
namespace {

struct Response {
    double stress;
    double slope;
};

Response regularised(const laws::flow::HerschelBulkley& law, double rate, double e) {
    const double square = rate * rate + e * e;
    const double root = std::sqrt(square);
    const double viscous = law.consistency * std::pow(square, 0.5 * (law.flow_index - 1.0));
    return {law.yield_stress * rate / root + viscous * rate,
            law.yield_stress * e * e / (square * root) +
                viscous * (1.0 + (law.flow_index - 1.0) * rate * rate / square)};
}

/// One implicit Euler step: the balance of angular momentum of every cell, and its tangent.
class Step {
public:
    Step(const FiniteVolumeScene& scene, int cells, double step, double regularisation)
        : scene_(scene), count_(static_cast<std::size_t>(cells)),
          size_((scene.outer - scene.inner) / cells), step_(step), e_(regularisation),
          rest_(count_), diagonal_(count_), upper_(count_), change_(count_) {}

    /// Solves for `w` at the step's end and gives the stress at the inner wall.
    double solve(const std::vector<double>& before, double speed, std::vector<double>& w) {
        double norm = assemble(before, speed, w);
        for (int iteration = 0; iteration < 200; ++iteration) {
            correct();
            double largest = 0.0;
            for (const double each : change_) {
                largest = std::max(largest, std::abs(each));
            }
            const std::vector<double> from = w;
            // The kink of the regularised law throws full Newton steps back and forth.
            double length = 1.0;
            double tried = 0.0;
            for (int halving = 0; halving < 40; ++halving, length *= 0.5) {
                for (std::size_t i = 0; i < count_; ++i) {
                    w[i] = from[i] + length * change_[i];
                }
                tried = assemble(before, speed, w);
                if (tried < norm * (1.0 - 1e-4 * length)) {
                    break;
                }
            }
            norm = tried;
            if (length == 1.0 && largest < 1e-9 * std::max(std::abs(speed), 1e-12)) {
                break;
            }
        }
        return wall_stress_;
    }

private:
    [[nodiscard]] double face(std::size_t i) const {
        return scene_.inner + size_ * static_cast<double>(i);
    }

    double assemble(const std::vector<double>& before, double speed, const std::vector<double>& w) {
        for (std::size_t i = 0; i < count_; ++i) {
            const double r = 0.5 * (face(i) + face(i + 1));
            const double mass = scene_.density * r * r * r * size_ / step_;
            rest_[i] = -mass * (w[i] - before[i]);
            diagonal_[i] = mass;
        }
        for (std::size_t f = 0; f <= count_; ++f) {
            const double r = face(f);
            const double left = f == 0 ? speed : w[f - 1];
            const double right = f == count_ ? 0.0 : w[f];
            // The walls are half a cell away from the first and the last centre.
            const double distance = f == 0 || f == count_ ? 0.5 * size_ : size_;
            const Response response = regularised(scene_.law, r * (right - left) / distance, e_);
            const double flux = r * r * response.stress;
            const double slope = r * r * r * response.slope / distance;
            if (f == 0) {
                wall_stress_ = -response.stress;
            }
            if (f > 0) {
                rest_[f - 1] += flux;
                diagonal_[f - 1] += slope;
                upper_[f - 1] = f < count_ ? -slope : 0.0;
            }
            if (f < count_) {
                rest_[f] -= flux;
                diagonal_[f] += slope;
            }
        }
        double sum = 0.0;
        for (const double each : rest_) {
            sum += each * each;
        }
        return std::sqrt(sum);
    }

    void correct() {
        std::vector<double> pivot = diagonal_;
        change_ = rest_;
        for (std::size_t i = 1; i < count_; ++i) {
            const double factor = upper_[i - 1] / pivot[i - 1];
            pivot[i] -= factor * upper_[i - 1];
            change_[i] -= factor * change_[i - 1];
        }
        for (std::size_t i = count_; i-- > 0;) {
            const double above = i + 1 < count_ ? upper_[i] * change_[i + 1] : 0.0;
            change_[i] = (change_[i] - above) / pivot[i];
        }
    }

    const FiniteVolumeScene& scene_;
    std::size_t count_;
    double size_;
    double step_;
    double e_;
    double wall_stress_ = 0.0;
    std::vector<double> rest_, diagonal_, upper_, change_;
};

} // namespace

std::vector<double> regularised_wall_stress(const FiniteVolumeScene& scene,
                                            const std::vector<double>& times, int cells,
                                            double step, double regularisation) {
    Step solver(scene, cells, step, regularisation);
    std::vector<double> w(static_cast<std::size_t>(cells), 0.0);
    std::vector<double> found;
    for (long k = 1; found.size() < times.size(); ++k) {
        const double time = step * static_cast<double>(k);
        const std::vector<double> before = w;
        const double stress = solver.solve(before, scene.speed(time), w);
        if (time > times[found.size()] - 0.5 * step) {
            found.push_back(stress);
        }
    }
    return found;
}

} // namespace searle::verification
