#include <nipref/verify/report/internal/sections.hpp>

namespace nipref::verify {

// Light and dark as the reader has it set; plots stay on white. Contrasts are 4.5 to 1 at least.
const char* const style_sheet = R"css(
:root { color-scheme: light dark; --back: #ffffff; --text: #1b1f24; --soft: #57606a; --line: #d0d7de; --card: #f6f8fa;
  --link: #0b5cad; --good: #1a7f37; --bad: #b3261e; --odd: #855000; --good-back: #e3f5e6; --bad-back: #fde4e1;
  --odd-back: #fff1d6; --ask-back: #e8e6f5; }
@media (prefers-color-scheme: dark) { :root { --back: #14181d; --text: #e4e8ec; --soft: #a3adb8; --line: #39424d; --card: #1d232a;
  --link: #7cb7ff; --good: #66cc7d; --bad: #ff8f84; --odd: #f0b95a; --good-back: #173321; --bad-back: #42201d;
  --odd-back: #3a2d12; --ask-back: #2a2843; } }
* { box-sizing: border-box; }
html { scroll-padding-top: 1rem; }
body { margin: 0; background: var(--back); color: var(--text); font: 1rem/1.5 system-ui, sans-serif; overflow-wrap: break-word; }
main, header, nav, footer { max-width: 88rem; margin: 0 auto; padding: 0 1rem; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 1.5rem 0 .5rem; }
h2 { font-size: 1.35rem; margin: 3rem 0 .5rem; padding-top: .75rem; border-top: 2px solid var(--line); }
h3 { font-size: 1.05rem; margin: 1.5rem 0 .5rem; }
p, li { max-width: 48rem; }
a { color: var(--link); }
a:focus-visible, summary:focus-visible, .scroll:focus-visible { outline: 3px solid var(--link); outline-offset: 2px; }
code, pre, .code { font-family: ui-monospace, monospace; font-size: .88em; }
pre { background: var(--card); border: 1px solid var(--line); padding: .75rem; overflow-x: auto; }
nav ul { list-style: none; padding: 0; display: flex; flex-wrap: wrap; gap: .25rem 1rem; max-width: none; }
.soft { color: var(--soft); }
.headline { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 15rem), 1fr)); gap: .75rem; padding: 0; list-style: none; }
.headline li { background: var(--card); border: 1px solid var(--line); border-radius: .4rem; padding: .75rem; max-width: none; }
.headline b { display: block; font-size: 1.6rem; line-height: 1.2; }
.plots { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 24rem), 1fr)); gap: 1rem; }
.beside { display: grid; grid-template-columns: minmax(0, 30rem) minmax(0, 1fr); gap: 1rem; align-items: start; margin-bottom: 1rem; }
@media (max-width: 60rem) { .beside { grid-template-columns: minmax(0, 1fr); } }
figure { margin: 0; min-width: 0; }
figure img { display: block; width: 100%; height: auto; background: #ffffff; border: 1px solid var(--line); border-radius: .3rem; }
figcaption { font-size: .88rem; color: var(--soft); padding: .25rem 0; }
figure.sheet { max-width: 60rem; margin-bottom: 1.5rem; }
figure.sheet .scroll img { min-width: 40rem; }
.missing { border: 1px dashed var(--line); padding: .75rem; color: var(--soft); }
.scroll { overflow-x: auto; max-width: 100%; margin: .5rem 0; }
table { border-collapse: collapse; font-size: .85rem; }
caption { text-align: left; color: var(--soft); padding: .25rem 0; }
th, td { padding: .2rem .5rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; font-variant-numeric: tabular-nums; }
tbody th { font-weight: 600; }
thead th { vertical-align: bottom; border-bottom: 2px solid var(--line); }
.n { text-align: right; white-space: nowrap; }
.keep { white-space: nowrap; }
thead .n { white-space: normal; }
.wide { min-width: 16rem; }
tr:target, :target > summary { outline: 3px solid var(--link); }
details { border: 1px solid var(--line); border-radius: .3rem; margin: .5rem 0; padding: 0 .75rem; }
details[open] { padding-bottom: .75rem; }
summary { cursor: pointer; padding: .5rem 0; font-weight: 600; }
summary .soft { font-weight: 400; }
td details, td details[open] { margin: 0; border: 0; padding: 0; } td summary { padding: 0; font-weight: 400; } td ul { padding-left: 1rem; margin: .25rem 0; }
.good { color: var(--good); } .bad { color: var(--bad); font-weight: 700; } .odd { color: var(--odd); }
.match { background: var(--good-back); } .misprint { background: var(--odd-back); } .seed-error { background: var(--bad-back); }
.unexplained { background: var(--ask-back); } .input { color: var(--soft); }
@page { size: A4 landscape; margin: 12mm; }
@media print {
  :root { color-scheme: light; --back: #ffffff; --text: #000000; --soft: #444444; --line: #999999; --card: #ffffff; --link: #000000;
    --good: #0b5c22; --bad: #8f1d17; --odd: #5f3900; --good-back: #e3f5e6; --bad-back: #fde4e1; --odd-back: #fff1d6; --ask-back: #e8e6f5; }
  body { font-size: 9.5pt; print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  main, header, nav, footer { max-width: none; padding: 0; }
  .plots { grid-template-columns: 1fr 1fr 1fr; }
  figure, tr, .headline li { break-inside: avoid; } h2, h3, summary { break-after: avoid; }
  .scroll { overflow: visible; } figure.sheet .scroll img { min-width: 0; } table { font-size: 6.5pt; }
  th, td { padding: .1rem .25rem; } .wide { min-width: 26mm; overflow-wrap: anywhere; }
}
)css";

}  // namespace nipref::verify
