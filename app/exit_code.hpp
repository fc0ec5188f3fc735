#pragma once

namespace searle::app {

/// What the program returns to the shell. Scripts depend on these numbers.
enum ExitCode : int {
    done = 0,
    program_fault = 1,  ///< a fault of the program or of the system under it
    wrong_usage = 2,    ///< wrong command line or case file; nothing was touched
    not_reached = 3,    ///< the solver could not reach what was asked; partial results say so
    engine_missing = 4, ///< the case asks for an engine or a model that is not here
    interrupted = 130   ///< Ctrl-C; what was finished is kept and says so
};

} // namespace searle::app
