// first_screens.mjs CHROMIUM OUT REPORT.html...: what readers see first of each report, at two widths, light and dark, as
// OUT/STUDY-WIDTH-GROUND.png; a study is named after its folder. Exits with 1 if the answer is not on it.

import {mkdirSync} from 'node:fs';
import {basename, dirname, join} from 'node:path';
import {setTimeout} from 'node:timers/promises';
import {answer} from './checks.mjs';
import {open, withChromium} from './page.mjs';

const [chromium, out, ...reports] = process.argv.slice(2);
mkdirSync(out, {recursive: true});
const found = [];
await withChromium(chromium, async browser => {
  for (const report of reports) {
    for (const {width, height} of [{width: 1280, height: 900}, {width: 390, height: 844}]) {
      for (const dark of [false, true]) {
        const {page, problems} = await open(browser, report, {width, height, dark});
        await page.waitForSelector('header figure.picture[data-drawn=true]', {timeout: 10_000}).catch(() => {});
        await setTimeout(100);
        const name = `${basename(dirname(report))}-${width}-${dark ? 'dark' : 'light'}`;
        await page.screenshot({path: join(out, `${name}.png`)});
        found.push(...[...problems, ...await answer(page)].map(problem => `${name}: ${problem}`));
        await page.close();
      }
    }
  }
});
for (const problem of found) console.error(problem);
process.exitCode = found.length === 0 ? 0 : 1;
