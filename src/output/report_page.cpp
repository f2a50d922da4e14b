// SPDX-License-Identifier: MIT
#include "output/report_page.hpp"

#include <fmt/format.h>

#include "base/sha256.hpp"

namespace posepack::output {
namespace {

constexpr std::string_view kStyle = R"css(
:root {
  color-scheme: light;
  --page: #f6f7f9; --card: #ffffff; --ink: #1c2330; --soft: #5b6675; --line: #dfe3e9; --faint: #eef0f4;
  --mark: #fff6dd; --accent: #1f5fbf;
  --s0: #6f7885; --s1: #2469c8; --s2: #d2691e; --s3: #1d8a57; --s4: #8a3fb0; --s5: #b3893a; --s6: #14919b; --s7: #c0395b;
  --front: #1c2330; --chosen: #c2185b;
  --h0: #f4f4f1; --h1: #fdf0c4; --h2: #fcdf94; --h3: #fbc36a; --h4: #f79c4f; --h5: #ec7245; --h6: #d84a45;
  --h7: #b42a4e; --h8: #831a52; --h9: #4d1048;
}
@media screen and (prefers-color-scheme: dark) {
  :root {
    color-scheme: dark;
    --page: #12161d; --card: #1a2029; --ink: #e6eaf0; --soft: #9aa6b5; --line: #313a47; --faint: #242c37;
    --mark: #3a3216; --accent: #79aef2;
    --s0: #98a2b0; --s1: #5b9df0; --s2: #ee9350; --s3: #4fc08a; --s4: #c48be2; --s5: #d8b36a; --s6: #4cc3cd; --s7: #f0799a;
    --front: #e6eaf0; --chosen: #ff6fa8;
    --h0: #202731; --h1: #34243f; --h2: #4f2255; --h3: #74245f; --h4: #992f5f; --h5: #bd4055; --h6: #dc5a47;
    --h7: #f0823e; --h8: #f9b248; --h9: #fdeb9a;
  }
}
* { box-sizing: border-box; }
html { scroll-padding-top: 64px; -webkit-text-size-adjust: 100%; }
body { margin: 0; background: var(--page); color: var(--ink); font: 15px/1.5 system-ui, -apple-system, "Segoe UI", Roboto,
  "Helvetica Neue", "Noto Sans", "DejaVu Sans", sans-serif; }
header, main, footer { max-width: 1240px; margin: 0 auto; padding: 0 20px; }
header { padding-top: 28px; }
h1 { font-size: 26px; line-height: 1.2; margin: 0 0 4px; font-weight: 650; }
h2 { font-size: 20px; margin: 0 0 2px; font-weight: 650; overflow-wrap: anywhere; }
h3 { font-size: 15px; margin: 18px 0 6px; font-weight: 600; }
p { margin: 4px 0 10px; }
.sub, .note { color: var(--soft); }
.note { font-size: 13px; }
a { color: var(--accent); }
section { background: var(--card); border: 1px solid var(--line); border-radius: 10px; padding: 18px 20px 16px; margin: 18px 0; }
.tiles { display: grid; grid-template-columns: repeat(auto-fit, minmax(170px, 1fr)); gap: 10px; margin: 18px 0 6px; }
.tiles div { background: var(--card); border: 1px solid var(--line); border-radius: 10px; padding: 10px 14px 11px; }
.tiles dt { color: var(--soft); font-size: 13px; }
.tiles dd { margin: 0; font-size: 21px; font-weight: 650; line-height: 1.25; }
.tiles small { display: block; color: var(--soft); font-size: 12.5px; font-weight: 400; overflow-wrap: anywhere; }
dl { margin: 0; }
.pick { position: fixed; top: 0; left: 0; opacity: 0; pointer-events: none; }
nav { position: sticky; top: 0; z-index: 2; background: var(--page); border-bottom: 1px solid var(--line); margin-top: 14px; }
nav > div { max-width: 1240px; margin: 0 auto; padding: 8px 20px; display: flex; flex-wrap: wrap; gap: 6px 22px; align-items: center;
  font-size: 14px; }
nav span, .show label { color: var(--soft); margin-right: 4px; }
.seg label { display: inline-block; padding: 2px 10px; border: 1px solid var(--line); background: var(--card); cursor: pointer; }
.seg label + label { border-left: 0; }
.seg label:first-of-type { border-radius: 6px 0 0 6px; }
.seg label:last-of-type { border-radius: 0 6px 6px 0; }
nav select { font: inherit; color: inherit; background: var(--card); border: 1px solid var(--line); border-radius: 6px; padding: 2px 6px;
  max-width: 260px; }
.charts { display: grid; grid-template-columns: repeat(auto-fit, minmax(420px, 1fr)); gap: 8px 22px; }
figure { margin: 0; min-width: 0; }
figcaption { font-size: 14px; font-weight: 600; margin: 8px 0 2px; }
svg { display: block; width: 100%; height: auto; overflow: visible; }
svg text { font-size: 12px; fill: var(--soft); }
.legend { list-style: none; display: flex; flex-wrap: wrap; gap: 3px 18px; margin: 8px 0 2px; padding: 0; font-size: 13.5px; }
.legend li { display: flex; align-items: center; gap: 6px; }
.legend svg { width: 26px; height: 18px; flex: none; }
.heatkey li { gap: 0; }
.heatkey { gap: 0; }
.heatkey i { display: inline-block; width: 56px; height: 12px; }
.heatkey li { flex-direction: column; align-items: flex-start; font-size: 12px; color: var(--soft); }
.g0, .g1, .ax, .fr, .cu, .hf { fill: none; }
.g0 { stroke: var(--faint); }
.g1 { stroke: var(--line); }
.ax { stroke: var(--soft); }
.tx { text-anchor: middle; }
.ty { text-anchor: end; }
.at { text-anchor: middle; }
svg .at { font-size: 13px; fill: var(--ink); }
.fr { stroke: var(--front); stroke-width: 1.4; stroke-dasharray: 5 3; opacity: .75; }
.cu { stroke-width: 1.2; opacity: .38; }
svg .lf, svg .lc { font-size: 12px; fill: var(--ink); paint-order: stroke; stroke: var(--card); stroke-width: 3px; }
svg .lc { fill: var(--chosen); font-weight: 650; }
.e { text-anchor: end; }
.p circle { stroke-width: 1.8; }
.p:hover circle { stroke-width: 4; }
)css"
                                    R"css(
.s0 { --c: var(--s0); } .s1 { --c: var(--s1); } .s2 { --c: var(--s2); } .s3 { --c: var(--s3); }
.s4 { --c: var(--s4); } .s5 { --c: var(--s5); } .s6 { --c: var(--s6); } .s7 { --c: var(--s7); }
.cu { stroke: var(--c); }
.p circle { fill: var(--c); stroke: var(--c); }
.p .ch { fill: none; stroke: var(--chosen); stroke-width: 2; }
.o circle:not(.ch) { fill: var(--card); }
.h0 { fill: var(--h0); background: var(--h0); } .h1 { fill: var(--h1); background: var(--h1); }
.h2 { fill: var(--h2); background: var(--h2); } .h3 { fill: var(--h3); background: var(--h3); }
.h4 { fill: var(--h4); background: var(--h4); } .h5 { fill: var(--h5); background: var(--h5); }
.h6 { fill: var(--h6); background: var(--h6); } .h7 { fill: var(--h7); background: var(--h7); }
.h8 { fill: var(--h8); background: var(--h8); } .h9 { fill: var(--h9); background: var(--h9); }
.hf { stroke: var(--line); }
svg .hb { font-size: 9.5px; text-anchor: end; }
svg .hc { font-size: 11px; fill: var(--ink); }
svg .hs { font-size: 10.5px; text-anchor: middle; }
.ho { fill: transparent; }
.ho:hover { stroke: var(--ink); }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: 12.5px; font-variant-numeric: tabular-nums; margin: 6px 0; min-width: 100%; }
th, td { padding: 3px 6px; text-align: right; white-space: nowrap; border-bottom: 1px solid var(--faint); }
th { color: var(--soft); font-weight: 600; border-bottom-color: var(--line); vertical-align: bottom; white-space: normal; }
.l { text-align: left; }
.sorts th { cursor: pointer; }
th[aria-sort=ascending]::after { content: " \25B4"; }
th[aria-sort=descending]::after { content: " \25BE"; }
tbody tr:hover { background: var(--faint); }
tr.c td, tbody tr.c:hover { background: var(--mark); }
tr.c td:first-child { box-shadow: inset 3px 0 0 var(--chosen); }
details { margin-top: 12px; }
summary { cursor: pointer; font-weight: 600; }
footer { color: var(--soft); font-size: 13.5px; padding-bottom: 40px; }
.k-ns, .k-fetches, .k-alu, .e-max, .e-p999, .e-rms { display: none; }
#e-max:checked ~ main .e-max.k-bytes, #e-p999:checked ~ main .e-p999.k-bytes, #e-rms:checked ~ main .e-rms.k-bytes,
#e-max:checked ~ #k-ns:checked ~ main .e-max.k-ns, #e-max:checked ~ #k-fetches:checked ~ main .e-max.k-fetches,
#e-max:checked ~ #k-alu:checked ~ main .e-max.k-alu, #e-p999:checked ~ #k-ns:checked ~ main .e-p999.k-ns,
#e-p999:checked ~ #k-fetches:checked ~ main .e-p999.k-fetches, #e-p999:checked ~ #k-alu:checked ~ main .e-p999.k-alu,
#e-rms:checked ~ #k-ns:checked ~ main .e-rms.k-ns, #e-rms:checked ~ #k-fetches:checked ~ main .e-rms.k-fetches,
#e-rms:checked ~ #k-alu:checked ~ main .e-rms.k-alu { display: block; }
#e-max:checked ~ nav [for=e-max], #e-p999:checked ~ nav [for=e-p999], #e-rms:checked ~ nav [for=e-rms],
#k-ns:checked ~ nav [for=k-ns], #k-fetches:checked ~ nav [for=k-fetches], #k-alu:checked ~ nav [for=k-alu] {
  background: var(--accent); border-color: var(--accent); color: var(--card); }
#e-max:focus-visible ~ nav [for=e-max], #e-p999:focus-visible ~ nav [for=e-p999], #e-rms:focus-visible ~ nav [for=e-rms],
#k-ns:focus-visible ~ nav [for=k-ns], #k-fetches:focus-visible ~ nav [for=k-fetches], #k-alu:focus-visible ~ nav [for=k-alu] {
  outline: 2px solid var(--ink); outline-offset: 1px; }
.animal { content-visibility: auto; contain-intrinsic-size: auto 1100px; }
@media (max-width: 520px) { .charts { grid-template-columns: 1fr; } section { padding: 12px; } }
@page { margin: 11mm; }
@media print {
  body { background: none; font-size: 11pt; }
  header, main, footer { max-width: none; padding: 0; }
  nav { display: none; }
  section { border: 0; padding: 0; border-radius: 0; }
  .animal { break-before: page; content-visibility: visible; }
  figure, tr, .tiles div { break-inside: avoid; }
  .charts { grid-template-columns: 1fr 1fr; }
  .wide { overflow: visible; }
  table { font-size: 6.3pt; min-width: 0; }
  th, td { padding: 1pt 2.5pt; }
  td.l:last-child { white-space: normal; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)css";

constexpr std::string_view kScript = R"js(
'use strict';
(() => {
  const value = (row, column) => {
    const text = row.cells[column].textContent.trim();
    const number = Number(text.replace(/,/g, ''));
    return text !== '' && !Number.isNaN(number) ? number : text;
  };
  const compare = (a, b) => {
    if (typeof a === typeof b) return typeof a === 'number' ? a - b : a.localeCompare(b);
    return typeof a === 'number' ? -1 : 1;
  };
  const sort = (head) => {
    const table = head.closest('table');
    const body = table.tBodies[0];
    const isDown = head.getAttribute('aria-sort') === 'ascending';
    for (const other of head.parentNode.cells) other.removeAttribute('aria-sort');
    head.setAttribute('aria-sort', isDown ? 'descending' : 'ascending');
    const column = head.cellIndex;
    const rows = [...body.rows].map((row) => ({ row, key: value(row, column) }));
    rows.sort((a, b) => compare(a.key, b.key) * (isDown ? -1 : 1));
    body.append(...rows.map(({ row }) => row));
  };
  for (const table of document.querySelectorAll('table')) {
    table.classList.add('sorts');
    for (const head of table.tHead.rows[0].cells) {
      head.tabIndex = 0;
      head.addEventListener('click', () => sort(head));
      head.addEventListener('keydown', (event) => {
        if (event.key !== 'Enter' && event.key !== ' ') return;
        event.preventDefault();
        sort(head);
      });
    }
  }

  // One animal alone: by the list, or by an address that ends with "#only-a3".
  const chooser = document.getElementById('animal');
  const show = (id) => {
    chooser.value = id;
    for (const section of document.querySelectorAll('section.animal')) section.hidden = id !== '' && section.id !== id;
    for (const section of document.querySelectorAll('section.all')) section.hidden = id !== '';
  };
  const follow = () => {
    const only = location.hash.startsWith('#only-') ? location.hash.slice(6) : '';
    const isKnown = [...chooser.options].some((option) => option.value === only);
    show(isKnown ? only : '');
    const target = document.getElementById(location.hash.slice(1));
    if (target) target.scrollIntoView();
  };
  chooser.parentNode.hidden = false;
  chooser.addEventListener('change', () => {
    history.replaceState(null, '', chooser.value === '' ? '#' : `#only-${chooser.value}`);
    show(chooser.value);
    scrollTo(0, 0);
  });
  addEventListener('hashchange', follow);
  if (location.hash !== '') follow();
  addEventListener('beforeprint', () => {
    for (const folded of document.querySelectorAll('details')) folded.open = true;
  });
})();
)js";

std::string base64(std::span<const std::uint8_t> bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) {
            return i + k < bytes.size() ? std::uint32_t{bytes[i + k]} : 0u;
        };
        const std::uint32_t group = byte(0) << 16 | byte(1) << 8 | byte(2);
        for (std::size_t k = 0; k < 4; ++k)
            out += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63u] : '=';
    }
    return out;
}

}  // namespace

std::string_view report_style() {
    return kStyle;
}

std::string_view report_script() {
    return kScript;
}

std::string content_policy(std::string_view script) {
    const base::Sha256 digest =
        base::sha256({reinterpret_cast<const std::uint8_t*>(script.data()), script.size()});
    return fmt::format("default-src 'none'; style-src 'unsafe-inline'; script-src 'sha256-{}'",
                       base64(digest));
}

}  // namespace posepack::output
