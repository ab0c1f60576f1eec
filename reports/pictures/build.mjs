// build.mjs OUT: compiles every *.vl.json beside this file into OUT/NAME.json, a Vega specification, bundles the runtime into
// OUT/vega.js, copies draw_svg.mjs, and lists what the bundle is made of in OUT/LICENCES. Called by scripts/pictures.

import {build} from 'esbuild';
import {copyFileSync, mkdirSync, readFileSync, readdirSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {compile} from 'vega-lite';

const here = dirname(fileURLToPath(import.meta.url));
const [out] = process.argv.slice(2);
const read = file => JSON.parse(readFileSync(join(here, file), 'utf8'));
const config = read('config.json');
const lineLabels = read('line_labels.json');
mkdirSync(out, {recursive: true});

const warnings = [];
const logger = {level: () => logger, error: text => warnings.push(text), warn: text => warnings.push(text),
                info: () => logger, debug: () => logger};
for (const file of readdirSync(here).filter(name => name.endsWith('.vl.json')).sort()) {
  const picture = read(file);
  picture.layer = picture.layer?.flatMap(layer => layer === 'line_labels' ? lineLabels : [layer]);
  const {spec} = compile(picture, {config, logger});
  spec.autosize = {type: 'fit-x', contains: 'padding'};  // as wide as there is room, as high as it takes
  writeFileSync(join(out, file.replace('.vl.json', '.json')), JSON.stringify(spec));
  if (warnings.length > 0) throw new Error(`${file}: ${warnings.join('; ')}`);
}

const {metafile} = await build({
  bundle: true, minify: true, legalComments: 'none', metafile: true, absWorkingDir: here, entryPoints: ['runtime.js'],
  outfile: join(out, 'vega.js'), format: 'iife', globalName: 'vega', target: 'es2020'});
copyFileSync(join(here, 'draw_svg.mjs'), join(out, 'draw_svg.mjs'));

/** Packages that went into the bundle, grouped by the text of their licence. */
const packages = new Set(Object.keys(metafile.inputs).map(file => /^(node_modules\/.*?[^/]+)\/(?:src|build|dist|index)/.exec(file)?.[1]));
const byLicence = new Map();
for (const folder of [...packages].filter(Boolean).sort()) {
  const {name, version, license, repository} = read(join(folder, 'package.json'));
  // Some parts of Vega leave the text to the package of the whole, from the same repository.
  const place = [folder, 'node_modules/vega'].find(each => readdirSync(join(here, each)).includes('LICENSE'));
  if (place !== folder && repository !== 'vega/vega') throw new Error(`${name}: no file with its licence`);
  const text = readFileSync(join(here, place, 'LICENSE'), 'utf8').trim();
  byLicence.set(text, [...byLicence.get(text) ?? [], `${name} ${version} (${license})`]);
}
writeFileSync(join(out, 'LICENCES'), 'vega.js contains these packages:\n' +
              [...byLicence].map(([text, names]) => `\n${names.join('\n')}\n\n${text}\n`).join('\n'));
