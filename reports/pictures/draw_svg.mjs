// draw_svg.mjs PICTURES.json OUT: draws every picture of the file into OUT/ID.svg, without a browser; with `style`, as a
// figure of that size for a paper.

import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

// The runtime is a script for browsers, which defines `vega`.
const runtime = readFileSync(new URL('vega.js', import.meta.url), 'utf8');
const {View, expressionInterpreter, parse, prepare, settle} = new Function(`${runtime}; return vega;`)();

// The colours of the light theme: for paper.
const colours = {ground: '#ffffff', ink: '#1b1b1b', quiet: '#595959', rule: '#d0d0d0'};
const widthOfReports = 640;
const letters = 12;  // px, of every specification
const pxOfMm = 96 / 25.4, pxOfPoint = 96 / 72;

/** Says what is shown where readers of report.html can choose. */
function titled(specification, {choose}) {
  if (!choose) return specification;
  return {...specification, title: {text: `${choose.label}: ${choose.values[0]}`, anchor: 'start', fontWeight: 'normal'}};
}

async function draw(kind, values, width, height) {
  const view = new View(parse(titled(prepare(kind, values), values), null, {ast: true}),
                        {expr: expressionInterpreter, renderer: 'none'});
  settle(view, values, width);
  if (height) {
    const drawn = Number(/ height="([\d.]+)"/.exec(await view.toSVG())[1]);
    view.height(view.height() + height - drawn);  // axes and titles keep theirs
  }
  return (await view.toSVG()).replaceAll(/var\(--(\w+)\)/g, (_, name) => colours[name]);
}

/** A figure is drawn with the letters of all pictures on paper of another size, and scaled: all its parts stay in proportion. */
async function figure(kind, values, style) {
  const scale = style.fontSize * pxOfPoint / letters;
  const px = mm => mm * pxOfMm / scale;
  const svg = await draw(kind, values, px(style.width), style.height && px(style.height));
  const [, width, height] = / width="([\d.]+)" height="([\d.]+)"/.exec(svg);
  const mm = length => `${(length * scale / pxOfMm).toFixed(3)}mm`;
  return svg.replace(/ width="[\d.]+" height="[\d.]+"/, ` width="${mm(width)}" height="${mm(height)}"`)
            .replaceAll(/font-family="[^"]*"/g, given => style.font ? `font-family="${style.font}"` : given);
}

const [file, out] = process.argv.slice(2);
const {kinds, pictures, style} = JSON.parse(readFileSync(file, 'utf8'));
for (const {id, kind, values} of pictures) {
  const svg = style ? await figure(kinds[kind], values, style) : await draw(kinds[kind], values, widthOfReports);
  writeFileSync(join(out, `${id}.svg`), svg);
}
