// build.mjs OUT: compiles every *.vl.json beside this file into OUT/NAME.json, a Vega specification, and bundles the
// runtime into OUT/vega.js (report.html) and OUT/draw_svg.mjs (pictures without a browser).

import {build} from 'esbuild';
import {mkdirSync, readFileSync, readdirSync, writeFileSync} from 'node:fs';
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

const common = {bundle: true, minify: true, legalComments: 'none', nodePaths: [join(here, 'node_modules')]};
await build({...common, entryPoints: [join(here, 'runtime.js')], outfile: join(out, 'vega.js'), format: 'iife',
             globalName: 'vega', target: 'es2020'});
await build({...common, entryPoints: [join(here, 'draw_svg.mjs')], outfile: join(out, 'draw_svg.mjs'), format: 'esm',
             platform: 'browser', external: ['node:*'], target: 'node18'});
