#include "app/structure_files.hpp"

#include "rheometry/fields/section_fields.hpp"

#include <fmt/format.h>

namespace searle::app {
namespace {

using solvers::suspension::Microstructure;

std::string pairs_text(const Microstructure& structure) {
    std::string text = "distance_over_diameter,pairs_over_even,pressed_over_even,"
                       "pulled_over_even\n";
    for (const auto& bin : structure.pair_distribution())
        text += fmt::format("{:.4g},{:.6g},{:.6g},{:.6g}\n", bin.distance, bin.all, bin.pressed,
                            bin.pulled);
    return text;
}

std::string profile_text(const Microstructure& structure) {
    std::string text = "height_over_gap,volume_fraction,particle_velocity_m_s,"
                       "fluid_velocity_m_s\n";
    for (const auto& slice : structure.profile())
        text += fmt::format("{:.6g},{:.6g},{:.9g},{:.9g}\n", slice.height, slice.volume_fraction,
                            slice.particle_velocity, slice.fluid_velocity);
    return text;
}

std::string contacts_text(const Microstructure& structure) {
    std::string text = "partners,share_of_particles\n";
    const auto shares = structure.contact_shares();
    for (std::size_t k = 0; k < shares.size(); ++k)
        text += fmt::format("{},{:.6g}\n", k, shares[k]);
    return text;
}

std::string local_fractions_text(const Microstructure& structure) {
    std::string text = "local_volume_fraction,share_of_particles\n";
    const auto shares = structure.local_fraction_shares();
    for (std::size_t k = 0; k < shares.size(); ++k)
        text += fmt::format("{:.4g},{:.6g}\n",
                            (static_cast<double>(k) + 0.5) / Microstructure::fractions, shares[k]);
    return text;
}

} // namespace

std::vector<ResultFile> structure_files(const std::map<std::size_t, Microstructure>& structure,
                                        std::size_t finished, std::size_t wanted) {
    std::vector<ResultFile> files;
    if (structure.empty())
        return files;
    for (const std::size_t number : rheometry::fields::spread_rows(finished, wanted)) {
        const auto found = structure.find(number - 1);
        if (found == structure.end())
            continue;
        const std::string name = fmt::format("fields/row-{:04}-", number);
        files.push_back({name + "pairs.csv", pairs_text(found->second)});
        files.push_back({name + "profile.csv", profile_text(found->second)});
        files.push_back({name + "contacts.csv", contacts_text(found->second)});
        files.push_back({name + "local-fractions.csv", local_fractions_text(found->second)});
    }
    return files;
}

} // namespace searle::app
