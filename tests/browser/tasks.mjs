// tasks.mjs CHROMIUM RESULTS: what a newcomer asks of the built-in studies, answered from the first screens of their reports
// alone, at two widths, beside what results.json says. RESULTS has the folders of `run reports`. Exits with 1 where an answer is missing or another.

import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {open, withChromium} from './page.mjs';

const [chromium, results] = process.argv.slice(2);

/** The rows of the picture beside the answer, by heading, from top to bottom. On a phone headings are not on the axis. */
async function ranking(page) {
  const labels = await page.$$eval('header figure.picture .role-axis-label text, header figure.picture .mark-text text', texts => texts
    .map(text => ({text: text.textContent, bold: getComputedStyle(text).fontWeight >= 600,
                   axis: text.closest('.role-axis-label') !== null, box: text.getBoundingClientRect()}))
    .filter(({text, bold, axis, box}) => text && (bold || axis) && box.top < window.innerHeight)
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

/** The answer, where all of it is on the first screen. */
const verdict = page => page.$eval('.verdict', node =>
  node.getBoundingClientRect().bottom <= window.innerHeight ? node.textContent : '');

const tasks = [
  {study: 'low_discrepancy', asks: 'Which sampler is best for adjacent faces at 4096 rays?',
   async reads(page) { return (await verdict(page)).match(/Take (\w+): at 4096 rays it errs .* on parallel and adjacent pairs/)?.[1]; },
   knows: json => errorsAt(json, 'adjacent', 4096).sort((a, b) => a.rmse - b.rmse)[0].label},
  {study: 'convergence_rays', asks: 'Which of all samplers is, once that number of rays is chosen?',
   async reads(page) {
     const name = 'errors at 4096 evaluations per face';
     const value = await page.$$eval('header .alternatives option', (options, name) =>
       options.find(option => option.textContent === name)?.value, name);
     await page.select('header .alternatives select', value);
     await page.waitForFunction(() => /RMSE/.test(document.querySelector('header figure.picture svg').textContent));
     return (await ranking(page))['adjacent pairs']?.[0];
   },
   knows: json => errorsAt(json, 'adjacent', 4096).sort((a, b) => a.rmse - b.rmse)[0].label},
  {study: 'sr_vs_pdm', asks: 'SR or PDM?',
   async reads(page) { return (await verdict(page)).match(/On adjacent pairs (\w+) errs/)?.[1]; },
   knows: json => json.cells.filter(({method, patches_per_face, samples_per_patch}) =>
     patches_per_face === 169 && (method === 'PDM' || (method === 'SR' && samples_per_patch === 625)))
     .map(({method, summaries}) => ({method, rmse: Math.max(...summaries
       .filter(each => each.kind === 'form_factor' && each.pair_class === 'adjacent').map(({rmse}) => rmse))}))
     .sort((a, b) => a.rmse - b.rmse)[0].method},
  {study: 'occlusion', asks: 'Does PDM suffer from occlusion?',
   async reads(page) {
     const facts = await page.$$eval('.numbers li b', nodes => nodes
       .filter(node => node.getBoundingClientRect().bottom <= window.innerHeight).map(node => node.textContent));
     return facts.some(text => /^PDM suffers most: on \d+ of \d+ pairs$/.test(text));
   },
   knows: () => true},
  {study: 'radiosity_consequences', asks: 'What do errors by SR do to the light at reflectance 0.9?',
   async reads(page) {
     return inShort(/reflectance 0\.9 .*?([\d.]+)(?: ± [\d.]+)? % with SR/.exec(await verdict(page))?.[1]);
   },
   knows: json => {
     const errors = json.radiosity.consequences
       .filter(each => each.cell.startsWith('SR, 25 ') && each.treatment === 'reciprocal' && each.between === 'faces')
       .map(found => found.settings[4].light_error);
     return inShort(100 * errors[0]);
   }},
  {study: 'coverage', asks: 'Which interval with 5 replicates?',
   async reads(page) { return (await verdict(page)).match(/From 5 replicates on take ([^:]+?)(?: where the variance is finite)?:/)?.[1]; },
   knows: () => "Student's t"},
];

const problems = [];
await withChromium(chromium, async browser => {
  for (const {study, asks, reads, knows} of tasks) {
    for (const width of [1280, 390]) {
      const {page} = await open(browser, join(results, study, 'report.html'), {width, height: width > 390 ? 900 : 844});
      await page.waitForSelector('header figure.picture[data-drawn=true]', {timeout: 20_000});
      const read = await reads(page);
      const known = knows(JSON.parse(readFileSync(join(results, study, 'results.json'), 'utf8')));
      console.log(`${asks} ${read}`);
      if (read !== known) problems.push(`${asks} At ${width} px the first screen says ${read}, results.json ${known}.`);
      await page.close();
    }
  }
});
for (const problem of problems) console.error(problem);
process.exitCode = problems.length === 0 ? 0 : 1;
