#pragma once

#include "app/summary_json.hpp"

#include <string>
#include <vector>

namespace searle::app {

/// Wall and processor time of a run, stage by stage.
class StageClock {
public:
    StageClock();
    /// Ends a stage that began when the one before ended (the first: at the construction).
    void end_stage(std::string name);

    [[nodiscard]] const std::vector<StageSeconds>& stages() const { return stages_; }
    /// Wall time of all ended stages, s.
    [[nodiscard]] double wall_seconds() const;

private:
    double wall_start_;
    double cpu_start_;
    std::vector<StageSeconds> stages_;
};

} // namespace searle::app
