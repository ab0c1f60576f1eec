// check_scene.mjs CHROMIUM REPORT.html SCREENSHOTS: turns, clicks and reads the report of a scene as its readers do, and
// exits with 1 if anything is wrong, or if the checks do not find a report that is broken on purpose.

import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {accessibility} from './checks.mjs';
import {open, withChromium} from './page.mjs';

const views = [{name: 'wide', width: 1280}, {name: 'dark', width: 1280, dark: true}, {name: 'phone', width: 390, height: 844}];

const image = (page, id) => page.$eval(`#${id}`, canvas => canvas.toDataURL());
const text = (page, selector) => page.$eval(selector, node => node.textContent);

/** Presses the mouse at a share of a canvas, moves it and lets it go. */
async function drag(page, id, [x, y], [dx, dy]) {
  await page.$eval(`#${id}`, canvas => canvas.scrollIntoView({block: 'center'}));
  const box = await (await page.$(`#${id}`)).boundingBox();
  const from = [box.x + x * box.width, box.y + y * box.height];
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(from[0] + dx, from[1] + dy, {steps: 4});
  await page.mouse.up();
}

async function uses(page) {
  const problems = [];
  const expect = (fine, problem) => { if (!fine) problems.push(problem); };
  const blank = await page.evaluate(() => {
    const canvas = document.getElementById('drawing');
    return new Set(canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data).size < 10;
  });
  expect(!blank, 'the scene is not drawn');
  expect(/^-?\d/.test(await text(page, '#legend span')), `the legend has no number: ${await text(page, '#legend span')}`);

  const before = await image(page, 'drawing');
  await drag(page, 'drawing', [0.5, 0.5], [80, 0]);
  expect(await image(page, 'drawing') !== before, 'dragging does not turn the scene');
  expect(await page.$('tr.chosen') === null, 'dragging chooses a face');

  await drag(page, 'drawing', [0.5, 0.55], [0, 0]);
  const face = await page.$eval('#chosen', node => node.querySelector('h2')?.textContent ?? '');
  expect(face !== '', 'a click chooses no face');
  expect(await page.$eval('#chosen', (node, face) => document.querySelector('tr.chosen th')?.textContent === face, face),
         'the row of the chosen face is not marked');

  const coloured = await image(page, 'drawing');
  const options = await page.$$eval('#quantity option', all => all.map(option => option.value));
  await page.select('#quantity', options[Math.min(2, options.length - 1)]);
  if (options.length > 1) expect(await image(page, 'drawing') !== coloured, 'another quantity changes no colour');

  await drag(page, 'matrix', [0.93, 0.3], [0, 0]);
  expect(/^F .+ to .+ = \d/.test(await text(page, '#cell')), `the matrix does not say what is clicked: ${await text(page, '#cell')}`);
  const whole = await image(page, 'matrix');
  await page.click('#nearer');
  expect(await image(page, 'matrix') !== whole, 'the matrix is not enlarged');
  await page.click('#farther');
  await page.click('#farther');

  await page.focus('#drawing');
  const still = await image(page, 'drawing');
  await page.keyboard.press('ArrowLeft');
  expect(await image(page, 'drawing') !== still, 'arrow keys do not turn the scene');
  return [...problems, ...await accessibility(page)];
}

async function problemsOf(browser, report, screenshots) {
  const found = [];
  for (const view of views) {
    const {page, problems} = await open(browser, report, view);
    problems.push(...await uses(page));
    await page.evaluate(() => window.scrollTo(0, 0));
    if (screenshots) await page.screenshot({path: join(screenshots, `${view.name}.png`), fullPage: true});
    found.push(...problems.map(problem => `${view.name}: ${problem}`));
    await page.close();
  }
  return found;
}

/** What is wrong with a report, and what has to be found then. */
const faults = [
  ['requestless', '<main>', '<main><img alt="" src="https://example.org/a.png">', 'request: '],
  ['turning', 'azimuth -= dx / 120;', '', 'dragging does not turn the scene'],
  ['clicking', 'if (inside) return face;', '', 'a click chooses no face'],
  ['legend', 'text.textContent = range > 0', 'void range', 'the legend has no number'],
  ['matrix', 'count = Math.min(Math.max(Math.round(count / by)', 'const same = Math.min(Math.max(Math.round(count / by)',
   'the matrix is not enlarged'],
];

const [chromium, report, screenshots] = process.argv.slice(2);
mkdirSync(screenshots, {recursive: true});
const found = await withChromium(chromium, async browser => {
  const problems = await problemsOf(browser, report, screenshots);
  const page = readFileSync(report, 'utf8');
  for (const [name, from, to, finds] of faults) {
    if (!page.includes(from)) { problems.push(`nothing to break: ${from}`); continue; }
    const file = join(screenshots, `broken-${name}.html`);
    // Without the policy, whose hashes would stop a changed script from running at all.
    writeFileSync(file, page.replace(/<meta http-equiv="Content-Security-Policy"[^>]*>/, '').replace(from, () => to));
    if (!(await problemsOf(browser, file)).some(problem => problem.includes(finds))) problems.push(`not found: ${finds}`);
  }
  return problems;
});
for (const problem of found) console.error(problem);
console.log(`${report}: ${found.length} problems`);
process.exitCode = found.length === 0 ? 0 : 1;
