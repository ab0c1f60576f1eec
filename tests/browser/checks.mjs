// What must hold of a report in a browser. Each check is given a page, and returns what is wrong, a line each.

import {existsSync, mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {setTimeout} from 'node:timers/promises';
import {drawAll, unfold} from './page.mjs';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

/** Every picture is drawn, with marks, with no label cut off and none over another. */
export async function pictures(page) {
  await unfold(page);
  const missing = (await drawAll(page)).map(id => `${id}: not drawn`);
  const wrong = await page.$$eval('figure.picture[data-drawn=true]', figures => figures.flatMap(figure => {
    const problems = [];
    const svg = figure.querySelector('svg');
    const frame = svg.getBoundingClientRect();
    const marks = [...svg.querySelectorAll('.mark-rect path, .mark-symbol path, .mark-line path, .mark-rule line')]
      .filter(mark => !mark.closest('.role-legend, .role-axis'));
    if (marks.length < 2) problems.push('has no marks');
    if (/NaN|undefined/.test(svg.outerHTML)) problems.push('has marks without a place');
    if (frame.width > figure.getBoundingClientRect().width + 1) problems.push('is wider than its place');
    const labels = [...svg.querySelectorAll('.role-axis text, .role-legend text, .role-axis-title text')]
      .filter(text => text.textContent && getComputedStyle(text).opacity > 0)
      .map(text => ({text: text.textContent, box: text.getBoundingClientRect()}));
    for (const {text, box} of labels) {
      const cut = box.left < frame.left - 1 || box.right > frame.right + 1 || box.top < frame.top - 1 || box.bottom > frame.bottom + 1;
      if (cut) problems.push(`label cut off: ${text}`);
    }
    labels.forEach((a, i) => labels.slice(i + 1).forEach(b => {
      const width = Math.min(a.box.right, b.box.right) - Math.max(a.box.left, b.box.left);
      const height = Math.min(a.box.bottom, b.box.bottom) - Math.max(a.box.top, b.box.top);
      if (width > 1 && height > 3) problems.push(`labels overlap: ${a.text} and ${b.text}`);
    }));
    if (!figure.querySelector('.canvas').getAttribute('aria-label')) problems.push('has no text alternative');
    return problems.map(problem => `${figure.id}: ${problem}`);
  }));
  return [...missing, ...wrong];
}

/** The first picture of each kind. */
async function oneOfEachKind(page) {
  return page.$$eval('figure.picture[data-drawn=true]', figures =>
    [...new Map(figures.reverse().map(figure => [figure.dataset.kind, figure.id])).values()]);
}

/** A mark of each kind of picture tells its numbers when it is pointed at. */
export async function tooltips(page) {
  const problems = [];
  for (const id of await oneOfEachKind(page)) {
    await page.evaluate(id => document.querySelector(`#${id} svg`).scrollIntoView({block: 'center'}), id);
    const spots = await page.$eval(`#${id}`, figure => {
      const marks = figure.querySelectorAll('.mark-symbol[role] path, .mark-rect[role] path');
      return [...marks].filter(mark => !mark.closest('.role-legend, .role-axis')).slice(0, 40)
        .map(mark => mark.getBoundingClientRect()).map(box => [box.x + box.width / 2, box.y + box.height / 2]);
    });
    let told = '';
    for (const [x, y] of spots) {
      await page.mouse.move(x + 1, y);
      await page.mouse.move(x, y);
      told = await page.$eval('.tip', tip => tip.hidden ? '' : tip.textContent);
      if (told) break;
    }
    if (!/\d/.test(told)) problems.push(`${id}: no tooltip on ${spots.length} marks`);
  }
  await page.mouse.move(0, 0);
  return problems;
}

/** With the keyboard alone a series is shown by itself, and all again. */
export async function isolation(page) {
  const problems = [];
  const faint = id => page.$eval(`#${id} svg`, svg =>
    [...svg.querySelectorAll('.mark-symbol path')].filter(path => path.getAttribute('opacity') < 0.5).length);
  const ids = await page.$$eval('figure.picture', figures => figures
    .filter(figure => figure.querySelectorAll('button[aria-pressed]').length > 1).map(figure => figure.id));
  if (ids.length === 0) return ['no picture has series to show alone'];
  for (const id of ids) {
    const [first, second] = await page.$$(`#${id} button[aria-pressed]`);
    const press = async button => {
      await button.focus();
      await page.keyboard.press('Enter');
      return faint(id);
    };
    const alone = await press(first);
    if (alone === 0) problems.push(`${id}: isolating a series changes nothing`);
    if (alone > 0 && await press(second) >= alone) problems.push(`${id}: a second series does not come back beside the first`);
    await press(first);
    if (alone > 0 && await press(second) > 0) problems.push(`${id}: the other series do not come back`);
  }
  return problems;
}

/** Choosing another pair changes what is drawn. */
export async function choices(page) {
  const problems = [];
  for (const id of await page.$$eval('figure.picture:has(select)', figures => figures.map(figure => figure.id))) {
    const drawn = () => page.$eval(`#${id} svg`, svg => svg.outerHTML);
    const before = await drawn();
    const second = await page.$eval(`#${id} select`, list => list.options[1].value);
    await page.select(`#${id} select`, second);
    await page.waitForFunction((id, before) => document.querySelector(`#${id} svg`).outerHTML !== before,
                               {timeout: 5000}, id, before).catch(() => problems.push(`${id}: choosing changes nothing`));
  }
  return problems;
}

/** Tab alone goes to everything that can be used, and shows where it is. */
export async function keyboard(page) {
  const usable = 'a[href], button, select, summary, [tabindex="0"]';
  const wanted = await page.$$eval(usable, nodes => nodes
    .filter(node => node.checkVisibility()).map((node, i) => { node.dataset.stop = i; return String(i); }));
  await page.evaluate(() => { document.activeElement.blur(); window.scrollTo(0, 0); });
  const reached = new Set();
  const unseen = [];
  for (let i = 0; i < wanted.length + 5; ++i) {
    await page.keyboard.press('Tab');
    const at = await page.evaluate(() => {
      const node = document.activeElement;
      return {stop: node.dataset?.stop, outlined: getComputedStyle(node).outlineStyle !== 'none', html: node.outerHTML.slice(0, 80)};
    });
    if (at.stop === undefined) continue;
    reached.add(at.stop);
    if (!at.outlined) unseen.push(`no sign of the focus on ${at.html}`);
  }
  const lost = wanted.filter(stop => !reached.has(stop));
  const named = await page.evaluate(stops => stops.map(stop => document.querySelector(`[data-stop="${stop}"]`).outerHTML.slice(0, 80)), lost);
  return [...unseen.slice(0, 5), ...named.slice(0, 5).map(html => `Tab does not reach ${html}`)];
}

/** One picture of each kind is saved as a file that is SVG by itself. */
export async function saving(page) {
  const problems = [];
  const folder = mkdtempSync(join(tmpdir(), 'ffstudy-saved-'));
  const session = await page.createCDPSession();
  await session.send('Browser.setDownloadBehavior', {behavior: 'allow', downloadPath: folder, eventsEnabled: true});
  // Under its own name the file is there before its content is: only the event says that it is whole.
  const saved = () => new Promise(resolve => {
    const ended = ({state}) => {
      if (state === 'inProgress') return;
      session.off('Browser.downloadProgress', ended);
      resolve(state);
    };
    session.on('Browser.downloadProgress', ended);
  });
  for (const id of await oneOfEachKind(page)) {
    const end = Promise.race([saved(), setTimeout(20_000, 'never', {ref: false})]);
    await page.$$eval(`#${id} .controls button`, buttons => buttons.find(button => button.textContent === 'Save as SVG').click());
    const state = await end;
    await setTimeout(200);  // browsers let a page save ten files at once and no more
    const file = join(folder, `${id}.svg`);
    if (state !== 'completed' || !existsSync(file)) {
      problems.push(`${id}: not saved (${state})`);
      continue;
    }
    const svg = readFileSync(file, 'utf8');
    const root = await page.evaluate(text => new DOMParser().parseFromString(text, 'image/svg+xml').documentElement.localName, svg);
    if (root !== 'svg' || svg.includes('var(')) problems.push(`${id}: not saved as SVG that stands alone`);
  }
  await session.send('Browser.setDownloadBehavior', {behavior: 'default'});
  rmSync(folder, {recursive: true});
  return problems;
}

/** The data of every picture can be read as a table, a row for each row. */
export async function tables(page) {
  await page.$$eval('figure[data-drawn=true] details.data', nodes => nodes.forEach(node => { node.open = true; }));
  await setTimeout(500);
  const problems = await page.$$eval('figure.picture[data-drawn=true]', figures => figures.filter(figure => {
    const rows = JSON.parse(figure.querySelector('.values').textContent).rows.length;
    return figure.querySelectorAll('details.data tbody tr').length !== rows;
  }).map(figure => `${figure.id}: the data are not shown as a table`));
  await page.$$eval('details.data', nodes => nodes.forEach(node => { node.open = false; }));
  return problems;
}

/** axe finds nothing (drawings are one image each, with a text), and nothing is wider than the window. */
export async function accessibility(page) {
  await page.evaluate(axe);
  const violations = await page.evaluate(async () => (await window.axe.run({exclude: ['.canvas svg']})).violations.map(
    ({id, help, nodes}) => `axe: ${id}: ${help} (${nodes.length} times, first ${nodes[0].html.slice(0, 100)})`));
  const [wide, room] = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
  return wide > room ? [...violations, `the page is ${wide} wide, the window ${room}`] : violations;
}

/** The first screen has the title, the answer and the beginning of a picture, in this order and before any table. */
export async function answer(page) {
  await page.evaluate(() => window.scrollTo(0, 0));
  return page.evaluate(() => {
    const parts = {title: 'h1', answer: '.verdict', picture: 'header figure.picture'};
    const problems = [];
    let above = 0;
    for (const [name, selector] of Object.entries(parts)) {
      const node = document.querySelector(selector);
      if (!node) return [...problems, `no ${name} on the first screen`];
      const box = node.getBoundingClientRect();
      if (box.top < above - 1) problems.push(`the ${name} is out of order`);
      if ((name === 'picture' ? box.top + 150 : box.bottom) > window.innerHeight) problems.push(`the ${name} is below the first screen`);
      above = box.bottom;
    }
    const table = document.querySelector('table');
    if (table && table.getBoundingClientRect().top < above) problems.push('a table comes before the picture');
    return problems;
  });
}

/** The column that names a row stays in sight while the others are scrolled. */
export async function names(page) {
  return page.evaluate(() => [...document.querySelectorAll('main .scroll')].filter(place => place.scrollWidth > place.clientWidth + 1)
    .flatMap(place => {
      place.scrollLeft = 200;
      const name = place.querySelector('tbody th');
      const lost = name && name.getBoundingClientRect().left < place.getBoundingClientRect().left - 1;
      place.scrollLeft = 0;
      return lost ? [`${place.getAttribute('aria-labelledby')}: names of rows are scrolled out of sight`] : [];
    }));
}
