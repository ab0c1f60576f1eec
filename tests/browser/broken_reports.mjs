// broken_reports.mjs CHROMIUM REPORT.html: the checks, checked. Breaks a report in one way after the other, and exits with
// 1 unless each fault is found.

import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {problemsOf} from './check_report.mjs';
import {withChromium} from './page.mjs';

const replaced = (text, from, to) => {
  if (!text.includes(from)) throw new Error(`nothing to break: ${from}`);
  return text.replace(from, () => to);
};

/** Without the policy, whose hashes would stop a changed script from running at all. */
const changed = (text, from, to) =>
  replaced(text.replace(/<meta http-equiv="Content-Security-Policy"[^>]*>/, ''), from, to);

const faults = [
  {fault: 'an image from the network', only: [], finds: 'request: ',
   made: text => changed(text, '<main>', '<main><img alt="" src="https://example.org/a.png">')},
  {fault: 'a style that the policy forbids', only: [], finds: 'Content Security Policy',
   made: text => replaced(text, '<main>', '<main><p style="color: red">')},
  {fault: 'values that are no JSON', only: ['pictures'], finds: 'not drawn',
   made: text => replaced(text, '"columns":', '"columns"')},
  {fault: 'a picture without marks', only: ['pictures'], finds: 'has no marks',
   made: text => replaced(text, /"rows":\[\[.*?\]\]/.exec(text)[0], '"rows":[]')},
  {fault: 'a label that is cut off', only: ['pictures'], finds: 'label cut off',
   made: text => replaced(text, '"type":"fit-x"', '"type":"none"')},
  {fault: 'no text alternative', only: ['pictures'], finds: 'has no text alternative',
   made: text => text.replaceAll(/(<div class="canvas" role="img") aria-label="[^"]*"/g, '$1')},
  {fault: 'a table before the picture', only: ['answer'], finds: 'a table comes before the picture',
   made: text => replaced(text, '<h1>', '<table><tr><td>1</td></tr></table><h1>')},
  {fault: 'an answer below the first screen', only: ['answer'], finds: 'the answer is below',
   made: text => changed(text, '.verdict { ', '.verdict { margin-top: 60rem !important; ')},
  {fault: 'names of rows that scroll away', only: ['pictures', 'names'], finds: 'names of rows',
   made: text => changed(text, 'position: sticky; left: 0;', '')
     .replace('max-width: 75rem', 'max-width: 24rem')},
  {fault: 'a page that is too large', only: [], finds: 'it has ',
   made: text => text + '<!-- ' + 'x'.repeat(1.5e6) + ' -->'},
  {fault: 'no tooltips', only: ['pictures', 'tooltips'], finds: 'no tooltip',
   made: text => changed(text, '.tooltip(showTip)', '')},
  {fault: 'a legend that isolates nothing', only: ['pictures', 'isolation'], finds: 'isolating a series changes nothing',
   made: text => changed(text, 'view.signal("isolate"', 'void ("isolate"')},
  {fault: 'a choice of pairs that does nothing', only: ['pictures', 'choices'], finds: 'choosing changes nothing',
   made: text => changed(text, 'view.signal(signal, list.value).run()', 'list.value')},
  {fault: 'a button that Tab does not reach', only: ['pictures', 'keyboard'], finds: 'Tab does not reach',
   made: text => replaced(text, '<summary>', '<summary tabindex="-1">')},
  {fault: 'no sign of the focus', only: ['keyboard'], finds: 'no sign of the focus',
   made: text => changed(text, ':focus-visible {', ':focus { outline: none !important; } .nothing {')},
  {fault: 'SVG with colours of the page', only: ['pictures', 'saving'], finds: 'not saved as SVG',
   made: text => changed(text, '.replaceAll(/var', '.replaceAll(/never')},
  {fault: 'a table without its last row', only: ['pictures', 'tables'], finds: 'not shown as a table',
   made: text => changed(text, '...rows.map(row => cells("td", row))', '...rows.slice(1).map(row => cells("td", row))')},
  {fault: 'no language', only: ['accessibility'], finds: 'axe: html-has-lang',
   made: text => replaced(text, '<html lang="en">', '<html>')},
  {fault: 'text that is hardly seen', only: ['accessibility'], finds: 'axe: color-contrast',
   made: text => changed(text, '--quiet: #595959', '--quiet: #c0c0c0')},
  {fault: 'a page wider than the window', only: ['accessibility'], finds: 'the page is',
   made: text => changed(text, 'max-width: 75rem', 'width: 150rem')},
];

const [chromium, report] = process.argv.slice(2);
const text = readFileSync(report, 'utf8');
const folder = mkdtempSync(join(tmpdir(), 'ffstudy-broken-'));
let missed = 0;
await withChromium(chromium, async browser => {
  for (const {fault, only, finds, made} of faults) {
    const file = join(folder, 'report.html');
    writeFileSync(file, made(text));
    const found = await problemsOf(browser, file, {only});
    if (found.some(problem => problem.includes(finds))) continue;
    ++missed;
    console.error(`not found: ${fault}. Found instead:\n  ${found.join('\n  ')}`);
  }
});
rmSync(folder, {recursive: true});
console.log(`${faults.length - missed} of ${faults.length} faults found`);
process.exitCode = missed === 0 ? 0 : 1;
