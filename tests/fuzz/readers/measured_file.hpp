#pragma once

#include "rheometry/tables/flow_curves.hpp"
#include "rheometry/tables/measured_data.hpp"

namespace searle::fuzz {

/// As `searle convert` reads a file, of both kinds of drive, and as `searle fit` does.
inline void read_measured_file(const std::filesystem::path& file) {
    for (const auto motion : {rheometry::DriveMotion::turning, rheometry::DriveMotion::sliding})
        try {
            static_cast<void>(rheometry::read_measured_data(file, motion));
        } catch (const rheometry::TableError&) {
        }
    try {
        static_cast<void>(rheometry::read_flow_curves(file));
    } catch (const rheometry::TableError&) {
    }
}

} // namespace searle::fuzz
