#include "rheometry/report/page_style.hpp"

namespace searle::rheometry::report {

std::string_view page_style() {
    return R"css(
:root{color-scheme:light dark;--ink:#1d2329;--soft:#5a6570;--paper:#fff;--rule:#d5dbe0;--band:#f5f7f9;--link:#005f96;--warn:#fff6e5;--warn-rule:#e69f00;--good:#00734f}
@media screen and (prefers-color-scheme:dark){:root{--ink:#e4e8ec;--soft:#9fabb6;--paper:#14181c;--rule:#333c45;--band:#1c2228;--link:#7cc6f2;--warn:#2d2414;--warn-rule:#d79a1e;--good:#35c79c}}
*{box-sizing:border-box}
html{-webkit-text-size-adjust:100%}
body{margin:0;background:var(--paper);color:var(--ink);font:16px/1.55 "Helvetica Neue",Helvetica,Arial,"Liberation Sans","DejaVu Sans",sans-serif;font-variant-numeric:lining-nums}
main{max-width:1060px;margin:0 auto;padding:36px 28px 48px}
a{color:var(--link)}
b.name{white-space:nowrap}
header .kind{color:var(--soft);font-size:13px;letter-spacing:.06em;text-transform:uppercase;margin:0}
h1{font-size:30px;line-height:1.2;margin:6px 0 12px;font-weight:650;overflow-wrap:anywhere}
h2{font-size:19px;line-height:1.3;margin:40px 0 12px;padding-top:14px;border-top:1px solid var(--rule);font-weight:650}
.lead{max-width:52em;margin:0 0 22px}
p{max-width:52em;margin:0 0 10px}
.results{display:grid;grid-template-columns:repeat(auto-fit,minmax(165px,1fr));gap:1px;margin:1px 1px 23px}
.results div{box-shadow:0 0 0 1px var(--rule);padding:10px 14px 11px}
.results dt{color:var(--soft);font-size:12.5px;line-height:1.3}
.results dd{margin:3px 0 0;font-size:16.5px;line-height:1.3;font-weight:600;overflow-wrap:anywhere}
.results .note{display:block;font-size:12.5px;font-weight:400;color:var(--soft)}
.warnings{border-left:4px solid var(--warn-rule);background:var(--warn);padding:10px 16px;margin:0 0 22px}
.warnings ul{margin:4px 0 0;padding-left:20px}
.figures{display:grid;grid-template-columns:repeat(2,minmax(0,1fr));gap:26px 30px;align-items:start}
figure{margin:0}
figure.wide{grid-column:1/-1}
.wide .panels{display:grid;grid-template-columns:repeat(2,minmax(0,1fr));gap:10px 30px;align-items:end}
figure svg,.panels svg{display:block;width:100%;max-width:560px;height:auto;overflow:visible;margin:0 auto}
figure.mesh svg{max-width:980px}
figure.mesh{margin-bottom:20px}
figcaption{font-size:14px;line-height:1.45;color:var(--ink);margin-top:8px}
.table{overflow-x:auto;margin:0 0 20px}
table{border-collapse:collapse;font-size:14px;line-height:1.4;width:100%;border-top:1.5px solid var(--ink);border-bottom:1.5px solid var(--ink)}
caption{text-align:left;font-size:14px;padding:0 0 7px}
th,td{text-align:left;padding:5px 10px 5px 0;vertical-align:baseline;border-top:1px solid var(--rule)}
tr:first-child>th,tr:first-child>td{border-top:0}
thead th{border-bottom:1px solid var(--ink);font-weight:600}
.properties th{font-weight:400;color:var(--soft);width:13.5em}
.properties .symbol{white-space:nowrap;width:1%}
.source,.quiet{color:var(--soft)}
.source{white-space:nowrap}
.fraction{display:inline-block;vertical-align:middle;text-align:center;font-size:.94em;line-height:1.25;margin:0 .15em}
.fraction span{display:block;padding:0 .25em}
.fraction span+span{border-top:1px solid currentColor}
sup,sub{font-size:.72em;line-height:0}
.yes{color:var(--good);font-weight:600;white-space:nowrap}.no{color:var(--soft);white-space:nowrap}
.columns figure{margin-bottom:20px}
.columns .properties th{width:auto}
.columns{display:grid;grid-template-columns:repeat(2,minmax(0,1fr));gap:0 30px;align-items:start}
.notes dt{font-weight:600;font-size:14px;margin-top:8px}.notes dd{margin:0 0 0 1.2em;font-size:14px}
details{margin:0 0 12px}
summary{cursor:pointer;font-size:14px;padding:6px 0}
.scroll{max-height:70vh;overflow:auto;border-bottom:1.5px solid var(--ink)}
.scroll table{border-bottom:0}
.data{font-variant-numeric:tabular-nums;font-size:13px;white-space:nowrap}
.data th,.data td{text-align:right;padding:3px 10px}
.data thead th{position:sticky;top:0;background:var(--band);z-index:1;box-shadow:inset 0 -1px var(--ink)}
.data .unit{font-weight:400;color:var(--soft)}
.data .words{text-align:left}
.runs th,.runs td{padding:3px 7px}
.runs thead th{white-space:normal;vertical-align:bottom}
.data tbody tr:nth-child(even){background:var(--band)}
.button{display:inline-block;padding:5px 12px;border:1px solid var(--rule);border-radius:4px;font-size:14px;text-decoration:none}
.button:hover,.button:focus{border-color:currentColor}
code{font-family:ui-monospace,"DejaVu Sans Mono",monospace;font-size:.9em}
footer{margin-top:40px;padding-top:12px;border-top:1px solid var(--rule);font-size:12.5px;color:var(--soft);overflow-wrap:anywhere}
@media screen and (max-width:760px){
main{padding:22px 15px 36px}
h1{font-size:24px}
.figures,.wide .panels,.columns{grid-template-columns:minmax(0,1fr)}
.results{grid-template-columns:repeat(2,minmax(0,1fr))}
.results dd{font-size:16px}
.properties th{width:38%}
.validity tr{display:grid;grid-template-columns:1fr auto;padding:5px 0;border-top:1px solid var(--rule)}
.validity th,.validity td{border:0;padding:1px 0;width:auto}.validity td+td{grid-column:1/-1}
}
@media print{
@page{margin:16mm 14mm}
body{font-size:10.5pt}
main{max-width:none;padding:0}
.results{grid-template-columns:repeat(5,1fr)}
.results dd{font-size:10.5pt}
figcaption,table,caption{font-size:9pt}
.figures,.wide .panels,.columns{column-gap:16px}
h2{break-after:avoid}
figure,.results,.warnings,tr{break-inside:avoid}
.button{display:none}
.scroll{max-height:none;overflow:visible}
.data thead th{position:static}
.data{font-size:8pt}
.data th,.data td{padding:1px 5px}
details::details-content{content-visibility:visible;block-size:auto}
a{color:inherit;text-decoration:none}
}
)css";
}

} // namespace searle::rheometry::report
