#include "app/verb_schema.hpp"

#include "app/case_keys.hpp"
#include "app/exit_code.hpp"
#include "casefile/reference.hpp"

#include <cstdio>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace searle::app {
namespace {

using Json = nlohmann::ordered_json;

Json bound_json(const std::optional<casefile::Bound>& bound) {
    if (!bound)
        return nullptr;
    return {{"value", bound->value}, {"text", bound->text}, {"included", bound->included}};
}

Json row_json(const casefile::ReferenceRow& row) {
    Json words = Json::array();
    for (const casefile::Word& word : row.words)
        words.push_back({{"name", word.name}, {"meaning", word.meaning}});
    return {{"key", row.key},
            {"section", row.section},
            {"condition", row.condition.empty() ? Json(nullptr) : Json(row.condition)},
            {"type", row.type},
            {"units", row.units},
            {"required", row.is_required},
            {"default", row.is_required ? Json(nullptr) : Json(row.default_text)},
            {"lower", bound_json(row.lower)},
            {"upper", bound_json(row.upper)},
            {"choices", words},
            {"meaning", row.meaning},
            {"example", row.example.empty() ? Json(nullptr) : Json(row.example)}};
}

constexpr std::string_view markdown_heading = R"(# Case file reference

Every key of a case file. Made by `searle schema --markdown` from the declarations that the
program itself reads with.

A dimensional value is a text with a unit (`"14 mm"`, `"1.0016 mPa.s"`, `"100 1/s"`); units are
those of UDUNITS-2, and also `cP`, `P`, `deg`, `rev/min`, `mNm`, `mPas`, `mM`. An angular velocity
is not a shear rate: `rpm`, `rev/min` and `1/min` are turns per minute, `1/s` is a shear rate, and
`Hz` is refused because it could be either. A consistency K has the unit `Pa.s^n`, whatever n is.
A pure number is a number. An unknown key is an error, and so is a key that the chosen type or
model does not use.

`--set key=value` replaces a value: `--set geometry.cup_radius="16 mm"`; items of lists count from
1: `--set protocol.segments.2.to="50 1/s"`.
)";

constexpr std::string_view sweep_example = R"(
A sweep is a study in one file:

```toml
[sweep]
vary = { "geometry.cup_radius" = ["15 mm", "16 mm"] }

[[sweep.runs]]
name = "as-given"

[[sweep.runs]]
name = "two-segments"
set = { protocol = { type = "segments", segments = [
  { to = "150 1/s", duration = "70 s" }, { to = "300 1/s", duration = "35 s" } ] } }
```

Each run is combined with every combination of the varied values, the first varied key changing
slowest. A section in `set` is merged key by key, unless it names the `type` of the geometry or the
protocol, or the `model` of the fluid: then it takes the section's place. `--set` applies to every
case, and must leave the swept keys alone.
)";

} // namespace

int schema(const SchemaOptions& options) {
    const auto rows = casefile::reference_rows(*case_keys().set());
    switch (options.format) {
    case SchemaFormat::text:
        fmt::print("{}", casefile::reference_text(rows));
        break;
    case SchemaFormat::markdown:
        fmt::print("{}{}{}", markdown_heading, casefile::reference_markdown(rows), sweep_example);
        break;
    case SchemaFormat::json: {
        Json keys = Json::array();
        for (const casefile::ReferenceRow& row : rows)
            keys.push_back(row_json(row));
        fmt::print("{}\n", Json{{"keys", keys}}.dump(2));
        break;
    }
    }
    return 0;
}

} // namespace searle::app
