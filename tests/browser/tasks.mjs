// tasks.mjs CHROMIUM RESULTS: what someone with a minute asks of a report, answered from its first screen alone, beside
// what results.json says. RESULTS has the folders of `run reports`. Exits with 1 where an answer is missing or another.

import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {open, withChromium} from './page.mjs';

const [chromium, results] = process.argv.slice(2);

/** The rows of the picture beside the answer, by heading, from top to bottom. */
async function ranking(page) {
  const labels = await page.$$eval('header figure.picture .role-axis-label text', texts => texts
    .map(text => ({text: text.textContent, bold: getComputedStyle(text).fontWeight >= 600, box: text.getBoundingClientRect()}))
    .filter(({text, box}) => text && box.top < window.innerHeight)
    .sort((a, b) => a.box.top - b.box.top));
  const blocks = {};
  let block;
  for (const {text, bold} of labels) {
    if (bold) block = blocks[text] = [];
    else block?.push(text);
  }
  return blocks;
}

/** Ladders on a class of pairs, with the error at this size. */
const errorsAt = (json, pairClass, evaluations) => json.slopes.flatMap(({label, classes}) => classes
  .filter(each => each.pair_class === pairClass).flatMap(({sizes}) => sizes
    .filter(size => size.evaluations === evaluations && size.efficiency !== null).map(({rmse}) => ({label, rmse}))));

/** A number to two significant digits. */
const inShort = number => String(Number(Number(number).toPrecision(2)));

const tasks = [
  {study: 'ladders', asks: 'Which method is best for adjacent faces at 256 evaluations per face?',
   async reads(page) {
     const name = 'errors at 256 evaluations per face';
     const value = await page.$$eval('header .alternatives option', (options, name) =>
       options.find(option => option.textContent === name)?.value, name);
     await page.select('header .alternatives select', value);
     await page.waitForFunction(() => /RMSE/.test(document.querySelector('header figure.picture svg').textContent));
     return (await ranking(page))['adjacent pairs']?.[0];
   },
   knows: json => errorsAt(json, 'adjacent', 256).sort((a, b) => a.rmse - b.rmse)[0].label},
  {study: 'ladders', asks: 'Which method converges fastest on parallel faces?',
   async reads(page) { return (await ranking(page))['parallel pairs']?.[0]; },
   knows: json => json.slopes.map(({label, classes}) => ({label, slope: classes.find(each => each.pair_class === 'parallel').slopes[0].slope}))
     .sort((a, b) => a.slope - b.slope)[0].label},
  {study: 'paper', asks: 'How many contradictions do the published tables have?',
   async reads(page) {
     return /contain (\d+) contradictions/.exec(await page.$eval('.verdict', node => node.textContent))?.[1];
   },
   knows: json => String(json.published.audit.filter(({severity}) => severity === 'contradiction').length)},
  {study: 'paper', asks: 'Does PDM, as the paper describes it, give the figures of the paper?',
   async reads(page) {
     return /PDM as described does not give the figures printed for it/.test(await page.$eval('.verdict', node => node.textContent));
   },
   knows: json => json.published.claims.some(claim => claim.as_printed_only)},
  {study: 'light', asks: 'How wrong is the exitance by SR at reflectance 0.9?',
   async reads(page) {
     const verdict = await page.$eval('.verdict', node => node.textContent);
     return inShort(/reflectance 0\.9 .*?([\d.]+)(?: ± [\d.]+)? % with SR/.exec(verdict)?.[1]);
   },
   knows: json => {
     const found = json.radiosity.consequences.find(each => each.cell.startsWith('SR') && each.treatment === 'reciprocal' && each.between === 'faces');
     return inShort(100 * found.settings[1].light_error);
   }},
];

const problems = [];
await withChromium(chromium, async browser => {
  for (const {study, asks, reads, knows} of tasks) {
    const {page} = await open(browser, join(results, study, 'report.html'), {width: 1280});
    await page.waitForSelector('header figure.picture[data-drawn=true]', {timeout: 20_000});
    const read = await reads(page);
    const known = knows(JSON.parse(readFileSync(join(results, study, 'results.json'), 'utf8')));
    console.log(`${asks} ${read}`);
    if (read !== known) problems.push(`${asks} The first screen says ${read}, results.json ${known}.`);
    await page.close();
  }
});
for (const problem of problems) console.error(problem);
process.exitCode = problems.length === 0 ? 0 : 1;
