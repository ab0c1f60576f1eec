// draw_svg.mjs PICTURES.json OUT: draws every picture of the file into OUT/ID.svg, without a browser.

import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {View, expressionInterpreter, parse, prepare, settle} from './runtime.js';

// The colours of the light theme: for paper.
const colours = {ground: '#ffffff', ink: '#1b1b1b', quiet: '#595959', rule: '#d0d0d0'};
const width = 640;

/** Says what is shown where readers of report.html can choose. */
function titled(specification, {choose}) {
  if (!choose) return specification;
  return {...specification, title: {text: `${choose.label}: ${choose.values[0]}`, anchor: 'start', fontWeight: 'normal'}};
}

const [file, out] = process.argv.slice(2);
const {kinds, pictures} = JSON.parse(readFileSync(file, 'utf8'));
for (const {id, kind, values} of pictures) {
  const view = new View(parse(titled(prepare(kinds[kind], values), values), null, {ast: true}),
                        {expr: expressionInterpreter, renderer: 'none'});
  const svg = await settle(view, values, width).toSVG();
  writeFileSync(join(out, `${id}.svg`), svg.replaceAll(/var\(--(\w+)\)/g, (_, name) => colours[name]));
}
