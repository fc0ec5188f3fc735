#pragma once

#include <string_view>

namespace searle::fuzz {

// Each takes the bytes of one file of a user and gives them to a reader. What the reader says to
// the user about a wrong file is caught; anything else (a crash, another exception) is a finding.

void read_case(std::string_view bytes);       ///< a case file
void read_measured(std::string_view bytes);   ///< a table of speeds and torques, delimited text
void read_curves(std::string_view bytes);     ///< flow curves as text, exports of TRIOS and others
void read_json(std::string_view bytes);       ///< an export of TRIOS in JSON
void read_xlsx(std::string_view bytes);       ///< an archive, or its parts; see xlsx.cpp
void read_xls(std::string_view bytes);        ///< a binary workbook
void read_rheogram(std::string_view bytes);   ///< rheogram.csv of a result
void read_ends(std::string_view bytes);       ///< end_factor.csv of a result
void read_summary(std::string_view bytes);    ///< summary.json of a result
void read_fields(std::string_view bytes);     ///< fields/row-0001.vtu of a result
void read_checkpoint(std::string_view bytes); ///< an HDF5 file
void read_moments(std::string_view bytes);    ///< moment.dat and force.dat of OpenFOAM
void read_velocity(std::string_view bytes);   ///< a field U of OpenFOAM
void read_log(std::string_view bytes);        ///< the log of an OpenFOAM solver

struct Reader {
    std::string_view name; ///< of its folder below corpus/ and regressions/
    void (*read)(std::string_view bytes);
};

inline constexpr Reader readers[] = {{"case", read_case},
                                     {"measured", read_measured},
                                     {"curves", read_curves},
                                     {"json", read_json},
                                     {"xlsx", read_xlsx},
                                     {"xls", read_xls},
                                     {"rheogram", read_rheogram},
                                     {"ends", read_ends},
                                     {"summary", read_summary},
                                     {"fields", read_fields},
                                     {"checkpoint", read_checkpoint},
                                     {"moments", read_moments},
                                     {"log", read_log},
                                     {"velocity", read_velocity}};

} // namespace searle::fuzz
