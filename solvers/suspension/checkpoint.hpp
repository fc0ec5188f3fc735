#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace searle::solvers::suspension {

/// The state of a run as named columns of numbers; whole numbers are below 2^53 and so exact.
class Checkpoint {
public:
    template <class Column>
    void put(const std::string& name, const Column& values) {
        columns_[name].assign(values.begin(), values.end());
    }
    void put(const std::string& name, double value) { columns_[name] = {value}; }

    /// Throws std::runtime_error when there is no such column.
    [[nodiscard]] const std::vector<double>& column(const std::string& name) const {
        const auto found = columns_.find(name);
        if (found == columns_.end())
            throw std::runtime_error("the checkpoint lacks " + name);
        return found->second;
    }
    template <class Column>
    void get(const std::string& name, Column& values) const {
        const std::vector<double>& from = column(name);
        values.resize(from.size());
        for (std::size_t k = 0; k < from.size(); ++k)
            values[k] = static_cast<typename Column::value_type>(from[k]);
    }
    [[nodiscard]] double number(const std::string& name) const { return column(name).at(0); }

    std::map<std::string, std::vector<double>>& columns() { return columns_; }
    [[nodiscard]] const std::map<std::string, std::vector<double>>& columns() const {
        return columns_;
    }

private:
    std::map<std::string, std::vector<double>> columns_;
};

/// How a run is kept safe. A run that starts from a checkpoint goes on bit for bit as the one that
/// wrote it would have.
struct Checkpointing {
    std::optional<Checkpoint> start;
    /// Called at every place where the run could go on from; decides itself whether to save.
    /// `make` gives the state.
    std::function<void(const std::function<Checkpoint()>& make)> offer;
    /// Called when the run is interrupted, and, if wanted, when it is finished: saves at once.
    std::function<void(const std::function<Checkpoint()>& make)> keep;
    bool keep_finished = false; ///< of a sweep, whose later runs may be interrupted
};

} // namespace searle::solvers::suspension
