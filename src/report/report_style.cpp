// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/report/report_sections.hpp"

namespace abut::report {

std::string style_sheet() {
    return R"(
:root { color-scheme: light; }
body { margin: 0; background: #fff; color: #1c1c1c; font: 14px/1.45 system-ui, "Segoe UI", "Helvetica Neue", "DejaVu Sans", Arial, sans-serif; }
main { max-width: 1120px; margin: 0 auto; padding: 20px 24px 48px; }
h1 { font-size: 24px; margin: 0 0 8px; overflow-wrap: anywhere; }
h2 { font-size: 18px; margin: 30px 0 10px; border-bottom: 1px solid #ccc; padding-bottom: 3px; }
h3 { font-size: 15px; margin: 20px 0 6px; overflow-wrap: anywhere; }
p { margin: 4px 0 8px; }
.verdict { margin: 0; padding: 10px 14px; border-left: 6px solid #2b8a3e; background: #eef8f0; font-size: 16px; overflow-wrap: anywhere; }
.verdict.failed { border-color: #c92a2a; background: #fdeeee; color: #8a1010; font-weight: 600; }
.verdict.doubtful { border-color: #d98200; background: #fff6e5; }
.facts { margin: 6px 0 0; padding: 0 20px; color: #333; }
.warnings { margin: 10px 0 0; padding: 8px 14px; border-left: 6px solid #d98200; background: #fff6e5; }
.warnings ul { margin: 2px 0 0; padding-left: 20px; }
.row { display: flex; flex-wrap: wrap; gap: 20px 24px; align-items: flex-start; }
figure { margin: 0; flex: none; max-width: 100%; }
figcaption { font-size: 13px; color: #444; margin: 0 0 4px; }
svg { display: block; width: 100%; height: auto; font-family: inherit; }
svg text { font-size: 12px; fill: #1c1c1c; }
svg .axes line { stroke: #777; stroke-width: 0.8; }
svg .axes line.grid { stroke: #e2e2e2; }
svg .axes text { font-size: 11px; fill: #444; }
svg text.axis-title, svg .axes text.axis-title { font-size: 11.5px; fill: #222; }
svg text.bar-title { font-size: 12px; }
svg text.note { font-size: 11px; fill: #444; }
svg text.number { font-size: 11.5px; font-weight: 700; fill: #fff; }
svg text.part-name { font-size: 12px; fill: #222; }
svg text.halo { paint-order: stroke; stroke: #fff; stroke-width: 3px; stroke-linejoin: round; }
.legends { flex: 1 1 240px; }
.legend { list-style: none; margin: 0 0 12px; padding: 0; font-size: 13px; display: flex; flex-wrap: wrap; gap: 3px 22px; }
.legend li { display: flex; align-items: center; gap: 6px; overflow-wrap: anywhere; }
.legend b { font-weight: 600; }
.swatch { flex: none; width: 16px; height: 12px; border: 1px solid #555; margin-right: 2px; }
svg.sign { flex: none; width: 26px; height: 14px; }
.disc { display: inline-block; min-width: 21px; height: 21px; line-height: 21px; border-radius: 11px; background: #d3102b; color: #fff; text-align: center; font-size: 13px; }
article { break-inside: avoid; margin-bottom: 18px; }
.table { overflow-x: auto; margin-bottom: 8px; }
table { border-collapse: collapse; font-size: 13px; font-variant-numeric: tabular-nums; }
th, td { padding: 3px 12px 3px 0; text-align: left; vertical-align: top; border-bottom: 1px solid #e3e3e3; }
th { font-weight: 600; border-bottom: 1px solid #888; white-space: nowrap; vertical-align: bottom; }
th.n, td.n { text-align: right; white-space: nowrap; padding-left: 8px; }
td { overflow-wrap: anywhere; }
.times { width: 560px; max-width: 100%; }
.times td.bars { width: 65%; }
.bar { display: block; height: 11px; margin-top: 4px; background: #5b84c4; min-width: 1px; }
footer { margin-top: 30px; color: #666; font-size: 12px; }
@media print {
  main { max-width: none; padding: 0; }
  body { font-size: 11px; }
  figure, table, .verdict, .warnings { break-inside: avoid; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)";
}

}  // namespace abut::report
