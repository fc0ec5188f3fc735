#pragma once

#include "casefile/source.hpp"

#include <exception>
#include <string>
#include <vector>

namespace searle::casefile {

/// One thing that is wrong with a case. Texts are fragments for the user; empty ones are left out.
struct Fault {
    std::vector<Place> places; ///< the first is where the fault is; further ones take part in it
    std::string key;           ///< dotted, e.g. "geometry.cup_radius"
    std::string problem;       ///< what is wrong, with the value
    std::string allowed;       ///< what would be right, with the unit and the bounds
    std::string suggestion;    ///< nearest valid name

    /// file:line:column, the key, the problem, each place's excerpt with a caret, what is allowed.
    [[nodiscard]] std::string text() const;
};

/// Every fault of a case, in the order of the file. what() is the whole text for the user
/// (several lines, no line end at its end). The program's exit code for it is 2.
class CaseError : public std::exception {
public:
    explicit CaseError(std::vector<Fault> faults);

    [[nodiscard]] const std::vector<Fault>& faults() const { return faults_; }
    [[nodiscard]] const char* what() const noexcept override { return text_.c_str(); }

private:
    std::vector<Fault> faults_;
    std::string text_;
};

} // namespace searle::casefile
