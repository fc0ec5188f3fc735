#include "rheometry/report/svg_style.hpp"

namespace searle::rheometry::report {

std::string_view figure_style() {
    return R"css(
.fig text{font-family:"Helvetica Neue",Helvetica,Arial,"Liberation Sans","DejaVu Sans",sans-serif;font-size:12px;fill:#1d2329}
.fig .name{font-size:13px}.fig .small{font-size:11px}.fig .letter{font-weight:700;font-size:13px}
.fig .soft{fill:#5a6570}
.fig .frame{fill:none;stroke:#39424b;stroke-width:1}
.fig .tick{stroke:#39424b;stroke-width:1}
.fig .grid{stroke:#e3e7eb;stroke-width:1}.fig .grid-minor{stroke:#f0f2f4;stroke-width:1}
.fig .paper{fill:#fff}
.fig .line{fill:none;stroke-width:1.6;stroke-linejoin:round;stroke-linecap:round}
.fig .thin{stroke-width:1}
.fig .dashed{stroke-dasharray:6 4}.fig .dotted{stroke-dasharray:1.5 3.5}
.fig .bar{fill:none;stroke-width:1.1}
.fig .mark{stroke-width:1.2}
.fig .mark:hover{stroke-width:5}
.fig .open{fill:#fff}
.line-0{stroke:#0072b2}.mark-0{stroke:#0072b2;fill:#0072b2}
.line-1{stroke:#d55e00}.mark-1{stroke:#d55e00;fill:#d55e00}
.line-2{stroke:#009e73}.mark-2{stroke:#009e73;fill:#009e73}
.line-3{stroke:#b8568f}.mark-3{stroke:#b8568f;fill:#b8568f}
.line-4{stroke:#e69f00}.mark-4{stroke:#e69f00;fill:#e69f00}
.line-5{stroke:#56b4e9}.mark-5{stroke:#56b4e9;fill:#56b4e9}
.line-6{stroke:#6b7680}.mark-6{stroke:#6b7680;fill:#6b7680}
.line-7{stroke:#1d2329}.mark-7{stroke:#1d2329;fill:#1d2329}
.tint-0{fill:#56b4e9;fill-opacity:.16}.hatch-0{stroke:#0072b2}
.tint-1{fill:#e69f00;fill-opacity:.17}.hatch-1{stroke:#a87400}
.tint-2{fill:#d55e00;fill-opacity:.15}.hatch-2{stroke:#d55e00}
.tint-3{fill:#cc79a7;fill-opacity:.18}.hatch-3{stroke:#b8568f}
.tint-4{fill:#8a959f;fill-opacity:.2}.hatch-4{stroke:#6b7680}
.tint-5{fill:#009e73;fill-opacity:.14}.hatch-5{stroke:#009e73}
.hatch{stroke-width:1;stroke-opacity:.38}
.fig .outline{fill:none;stroke:#1d2329;stroke-width:1.5;stroke-linejoin:round}
.fig .hairline{fill:none;stroke:#1d2329;stroke-width:.8}
.fig .axis-line{fill:none;stroke:#1d2329;stroke-width:.9;stroke-dasharray:14 3 2 3}
.fig .dimension{fill:none;stroke:#39424b;stroke-width:.9}
.fig .extension{fill:none;stroke:#7d8791;stroke-width:.7}
.fig .arrow{fill:#39424b}
.fig .limit{fill:none;stroke:#39424b;stroke-width:1;stroke-dasharray:5 3}
.fig .fluid{fill:#56b4e9;fill-opacity:.3}
.fig .velocity{fill:none;stroke:#0072b2;stroke-width:1.3}.fig .velocity-head{fill:#0072b2}
.fig .rotor{fill:#f3c9a8}.fig .rotor-hatch{stroke:#b04e00;stroke-width:.8;stroke-opacity:.7}
.fig .fixed{fill:#dfe3e7}.fig .fixed-hatch{stroke:#59636d;stroke-width:.8;stroke-opacity:.8}
.fig .rigid{fill:#c9cfd5}.fig .rotor-wall{fill:none;stroke:#d55e00;stroke-width:2.2;stroke-linecap:round}
.fig .yield-surface{fill:none;stroke:#fff;stroke-width:1.6;stroke-linejoin:round}
.fig .streamline{fill:none;stroke:#fff;stroke-width:.9;stroke-linejoin:round}
.fig .halo{paint-order:stroke;stroke:#fff;stroke-width:4px;stroke-linejoin:round}
@media screen and (prefers-color-scheme:dark){
.fig text{fill:#e4e8ec}.fig .soft{fill:#9fabb6}
.fig .frame,.fig .tick{stroke:#a7b1bb}
.fig .grid{stroke:#2b333b}.fig .grid-minor{stroke:#222930}
.fig .paper,.fig .open{fill:#14181c}
.line-0{stroke:#56b4e9}.mark-0{stroke:#56b4e9;fill:#56b4e9}
.line-1{stroke:#f2894a}.mark-1{stroke:#f2894a;fill:#f2894a}
.line-2{stroke:#35c79c}.mark-2{stroke:#35c79c;fill:#35c79c}
.line-3{stroke:#e59cc6}.mark-3{stroke:#e59cc6;fill:#e59cc6}
.line-4{stroke:#f0bd45}.mark-4{stroke:#f0bd45;fill:#f0bd45}
.line-5{stroke:#9dd3f5}.mark-5{stroke:#9dd3f5;fill:#9dd3f5}
.line-6{stroke:#98a3ad}.mark-6{stroke:#98a3ad;fill:#98a3ad}
.line-7{stroke:#e4e8ec}.mark-7{stroke:#e4e8ec;fill:#e4e8ec}
.fig .open{fill:#14181c}
.hatch-0{stroke:#56b4e9}.hatch-1{stroke:#f0bd45}.hatch-2{stroke:#f2894a}.hatch-3{stroke:#e59cc6}.hatch-4{stroke:#98a3ad}.hatch-5{stroke:#35c79c}
.fig .outline,.fig .hairline,.fig .axis-line{stroke:#e4e8ec}
.fig .dimension,.fig .limit{stroke:#b9c3cc}.fig .extension{stroke:#7d8993}.fig .arrow{fill:#b9c3cc}
.fig .fluid{fill:#56b4e9;fill-opacity:.28}
.fig .velocity{stroke:#7cc6f2}.fig .velocity-head{fill:#7cc6f2}
.fig .rotor{fill:#55331c}.fig .rotor-hatch{stroke:#f2a36f}
.fig .fixed{fill:#2c343c}.fig .fixed-hatch{stroke:#9fabb6}
.fig .rigid{fill:#4a545e}.fig .rotor-wall{stroke:#f2894a}
.fig .halo{stroke:#14181c}
}
)css";
}

} // namespace searle::rheometry::report
