// check_report.mjs CHROMIUM REPORT.html [SCREENSHOTS]: opens a report as its readers do, and exits with 1 if anything is
// wrong. With a folder, screenshots are left in it.

import {mkdirSync, statSync} from 'node:fs';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import * as checks from './checks.mjs';
import {open, withChromium} from './page.mjs';

const {answer, names, pictures, tooltips, isolation, choices, keyboard, saving, tables, accessibility} = checks;

const mostBytes = 1.5e6;

/** How it is looked at, and what is asked then. */
const views = [
  {name: 'wide', width: 1280, asked: {answer, names, pictures, tooltips, isolation, choices, saving, tables, keyboard, accessibility}},
  {name: 'dark', width: 1280, dark: true, asked: {pictures, accessibility}},
  {name: 'phone', width: 390, height: 844, asked: {answer, names, pictures, tooltips, accessibility}},
];

/** What of `report` is wrong; `only` names the checks of the first view that are made, all where it is not given. */
export async function problemsOf(browser, report, {screenshots, only} = {}) {
  const found = [];
  if (statSync(report).size > mostBytes) found.push(`it has ${statSync(report).size} bytes`);
  for (const view of only ? views.slice(0, 1) : views) {
    const {page, problems} = await open(browser, report, view);
    const picture = (what, options) =>
      screenshots && page.screenshot({path: join(screenshots, `${view.name}-${what}.png`), ...options});
    await picture('first-screen');
    if (await page.$('figure.picture .canvas') === null) problems.push('the program was built without pictures');
    for (const [name, check] of Object.entries(view.asked)) {
      if (!only || only.includes(name)) problems.push(...await check(page));
    }
    await page.evaluate(() => window.scrollTo(0, 0));
    await picture('all', {fullPage: true});
    found.push(...problems.map(problem => `${view.name}: ${problem}`));
    await page.close();
  }
  if (!only) found.push(...await printed(browser, report, screenshots));
  return found;
}

/** On paper every picture that is open is drawn, although nobody scrolled to it. */
async function printed(browser, report, screenshots) {
  const {page, problems} = await open(browser, report, {width: 1280});
  await page.pdf({format: 'A4', ...(screenshots && {path: join(screenshots, 'print.pdf')})});
  const missing = await page.$$eval('figure.picture', figures => figures
    .filter(figure => !figure.closest('details:not([open])') && figure.dataset.drawn !== 'true').map(figure => figure.id));
  await page.close();
  return [...problems, ...missing.map(id => `${id}: not drawn`)].map(problem => `print: ${problem}`);
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [chromium, report, screenshots] = process.argv.slice(2);
  if (screenshots) mkdirSync(screenshots, {recursive: true});
  const found = await withChromium(chromium, browser => problemsOf(browser, report, {screenshots}));
  for (const problem of found) console.error(problem);
  console.log(`${report}: ${found.length} problems`);
  process.exitCode = found.length === 0 ? 0 : 1;
}
