#include "casefile/unit_spelling.hpp"

#include <array>
#include <cctype>
#include <fmt/format.h>
#include <utility>

namespace searle::casefile {
namespace {

using Alias = std::pair<std::string_view, std::string_view>;

// Signs beyond ASCII. A run of superscripts becomes one power: s⁻¹ -> s^-1.
constexpr std::array signs{Alias{"\u00b7", "."}, Alias{"\u22c5", "."},  Alias{"\u00d7", "."},
                           Alias{"\u00b5", "u"}, Alias{"\u03bc", "u"},  Alias{"\u00a0", " "},
                           Alias{"\u202f", " "}, Alias{"\u00b0", "deg"}};
constexpr std::array superscripts{Alias{"\u2070", "0"}, Alias{"\u00b9", "1"}, Alias{"\u00b2", "2"},
                                  Alias{"\u00b3", "3"}, Alias{"\u2074", "4"}, Alias{"\u2075", "5"},
                                  Alias{"\u2076", "6"}, Alias{"\u207b", "-"}, Alias{"\u207f", "n"}};

// Whole names only, so that cP does not touch cPa.
constexpr std::array names{
    Alias{"cP", "(mPa.s)"},   Alias{"mP", "(0.1 mPa.s)"}, Alias{"P", "(0.1 Pa.s)"},
    Alias{"Pas", "(Pa.s)"},   Alias{"mPas", "(mPa.s)"},   Alias{"uPas", "(uPa.s)"},
    Alias{"Nm", "(N.m)"},     Alias{"mNm", "(mN.m)"},     Alias{"uNm", "(uN.m)"},
    Alias{"nNm", "(nN.m)"},   Alias{"deg", "degree"},     Alias{"rev", "revolution"},
    Alias{"r", "revolution"}, Alias{"U", "revolution"},   Alias{"turns", "turn"},
    Alias{"dyn", "dyne"},     Alias{"M", "(mol/l)"},      Alias{"mM", "(mmol/l)"},
    Alias{"uM", "(umol/l)"},  Alias{"sec", "second"},     Alias{"cpoise", "(mPa.s)"}};

// As a whole text: on rheometers and in the standards these are a speed of rotation.
constexpr std::array turns_per_minute{std::string_view{"1/min"}, std::string_view{"min^-1"},
                                      std::string_view{"min-1"}, std::string_view{"/min"}};

template <std::size_t Count>
const Alias* alias_at(const std::array<Alias, Count>& table, std::string_view text) {
    for (const Alias& alias : table)
        if (text.starts_with(alias.first))
            return &alias;
    return nullptr;
}

bool is_letter(char sign) { return std::isalpha(static_cast<unsigned char>(sign)) != 0; }

std::string with_known_names(std::string_view unit) {
    std::string text;
    for (std::size_t at = 0; at < unit.size();) {
        std::size_t end = at;
        while (end < unit.size() && (is_letter(unit[end]) || unit[end] == '_'))
            ++end;
        if (end == at) {
            text += unit[at++];
            continue;
        }
        std::string_view name = unit.substr(at, end - at);
        for (const Alias& alias : names)
            if (alias.first == name) {
                name = alias.second;
                break;
            }
        text += name;
        at = end;
    }
    return text;
}

} // namespace

std::string ascii_signs(std::string_view unit) {
    std::string text;
    bool in_power = false;
    while (!unit.empty()) {
        const Alias* superscript = alias_at(superscripts, unit);
        const Alias* sign = superscript ? nullptr : alias_at(signs, unit);
        if (superscript && !in_power)
            text += '^';
        in_power = superscript != nullptr;
        if (const Alias* alias = superscript ? superscript : sign) {
            text += alias->second;
            unit.remove_prefix(alias->first.size());
        } else {
            text += unit.front();
            unit.remove_prefix(1);
        }
    }
    return text;
}

std::string udunits_spelling(std::string_view unit) {
    const std::string ascii = ascii_signs(unit);
    for (const std::string_view whole : turns_per_minute)
        if (ascii == whole)
            return "revolution/min";
    if (ascii.starts_with('/'))
        return with_known_names(fmt::format("1{}", ascii));
    return with_known_names(ascii);
}

} // namespace searle::casefile
