// A drawing of Vega (SVG of paths, lines, rectangles and texts, moved and turned) as commands of PGF, for LaTeX, which
// sets its texts in the font of the document.

const special = {'\\': '\\textbackslash{}', '~': '\\textasciitilde{}', '^': '\\textasciicircum{}', '−': '$-$', '×': '$\\times$',
                 '²': '$^2$', '≤': '$\\le$', '≥': '$\\ge$', 'Σ': '$\\Sigma$', 'ρ': '$\\rho$', '…': '\\dots{}', '·': '$\\cdot$',
                 '±': '$\\pm$', '→': '$\\to$', '∞': '$\\infty$'};
const entities = {'&lt;': '<', '&gt;': '>', '&quot;': '"', '&apos;': "'", '&amp;': '&'};

function tex(text) {
  return text.replaceAll(/&(lt|gt|quot|apos|amp);/g, entity => entities[entity])
             .replaceAll(/[#$%&_{}]/g, '\\$&')
             .replaceAll(/[^\x00-\x7f]|~|\^|\\(?![#$%&_{}])/g, letter => special[letter] ?? letter);
}

const attributesOf = text => Object.fromEntries([...text.matchAll(/([\w:-]+)="([^"]*)"/g)].map(([, name, value]) => [name, value]));

function moved([x, y], transform = '') {
  const [, dx, dy] = /translate\(([-\d.e]+),\s*([-\d.e]+)\)/.exec(transform) ?? [0, 0, 0];
  return [x + Number(dx), y + Number(dy)];
}

function colourOf(value) {
  const [, ...channels] = /^rgba?\((\d+),\s*(\d+),\s*(\d+)/.exec(value) ?? [];
  if (channels.length === 3) return channels.map(channel => Number(channel).toString(16).padStart(2, '0')).join('').toUpperCase();
  if (/^#[\da-f]{6}$/i.test(value)) return value.slice(1).toUpperCase();
  if (/^#[\da-f]{3}$/i.test(value)) return [...value.slice(1)].map(digit => digit + digit).join('').toUpperCase();
  throw new Error(`pgf.js knows no colour ${value}`);
}

const seen = value => value !== undefined && value !== 'none' && value !== 'transparent';

/** Circles, the only arcs of Vega's symbols, as curves: arcs of half a turn are lost in the arithmetic of TeX. */
function withoutArcs(path) {
  return path.replaceAll(/M([\d.]+),0(A\1,\1,0,1,1,-?\1,0){2}/g, (_, radius) => {
    const r = Number(radius), k = r * 4 / 3 * Math.tan(Math.PI / 8);
    const quarters = [[r, k, k, r, 0, r], [-k, r, -r, k, -r, 0], [-r, -k, -k, -r, 0, -r], [k, -r, r, -k, r, 0]];
    return `M${r},0` + quarters.map(quarter => `C${quarter.map(number => number.toFixed(4)).join(',')}`).join('');
  });
}

/** Filled and stroked as the attributes say; empty where neither. */
function painted(path, attributes, [x, y], scale) {
  const commands = [];
  const opacity = Number(attributes.opacity ?? 1);
  const uses = [];
  for (const use of ['fill', 'stroke']) {
    if (!seen(attributes[use]) || opacity === 0) continue;
    uses.push(use);
    commands.push(`\\definecolor{ffcolour}{HTML}{${colourOf(attributes[use])}}\\pgfset${use}color{ffcolour}`,
                  `\\pgfset${use}opacity{${opacity * Number(attributes[`${use}-opacity`] ?? 1)}}`);
  }
  if (uses.length === 0) return '';
  if (uses.includes('stroke')) {
    const pt = length => `${(Number(length) * scale).toFixed(3)}bp`;
    commands.push(`\\pgfsetlinewidth{${pt(attributes['stroke-width'] ?? 1)}}`);
    const dashes = attributes['stroke-dasharray']?.split(/[ ,]+/) ?? [];
    if (dashes.length > 0) commands.push(`\\pgfsetdash{${dashes.map(dash => `{${pt(dash)}}`).join('')}}{0bp}`);
  }
  const place = `\\pgftransformshift{\\pgfpoint{${(x * scale).toFixed(3)}bp}{${(-y * scale).toFixed(3)}bp}}`;
  // The library reads lengths as pt.
  const size = (scale * 72.27 / 72).toFixed(5);
  return `\\begin{pgfscope}${commands.join('')}${place}\\pgftransformxscale{${size}}\\pgftransformyscale{-${size}}` +
         `\\pgfpathsvg{${withoutArcs(path)}}\\pgfusepath{${uses.join(',')}}\\end{pgfscope}\n`;
}

/**
 * @param size `width` and `height` of the drawing, and the `scale` of its lengths, in bp
 * @return a pgfpicture that needs \usepackage{pgf} and \usepgflibrary{svg.path}
 */
export function pgf(svg, {width, height, scale}) {
  const bp = length => `${(length * scale).toFixed(3)}bp`;
  let out = '% \\usepackage{pgf} \\usepgflibrary{svg.path}; then \\input this file.\n\\begin{pgfpicture}\n' +
            `\\pgfpathrectangle{\\pgfpoint{0bp}{${bp(-height)}}}{\\pgfpoint{${bp(width)}}{${bp(height)}}}\\pgfusepath{use as bounding box}\n`;
  const places = [[0, 0]];
  const inherited = [{}];
  for (const [, closing, tag, attributeText, empty, content] of svg.matchAll(/<(\/?)(\w+)([^>]*?)(\/?)>([^<]*)/g)) {
    const own = attributesOf(attributeText);
    if (closing) {
      if (tag === 'g') places.pop(), inherited.pop();
      continue;
    }
    const at = moved(places.at(-1), own.transform);
    const attributes = {...inherited.at(-1), ...own};
    if (tag === 'g' && !empty) {
      places.push(at);
      const {fill, stroke} = attributes;
      inherited.push({...(fill && {fill}), ...(stroke && {stroke})});
    }
    if (own.display === 'none') continue;
    if (tag === 'path') out += painted(own.d, attributes, at, scale);
    if (tag === 'line') out += painted(`M0,0L${own.x2 ?? 0},${own.y2 ?? 0}`, attributes, at, scale);
    if (tag === 'rect' && places.length > 1) out += painted(`M${own.x ?? 0},${own.y ?? 0}h${own.width}v${own.height}h-${own.width}Z`, attributes, at, scale);
    if (tag === 'text' && content) {
      const side = {middle: '', end: 'right,'}[own['text-anchor']] ?? 'left,';
      const [, turned] = /rotate\(([-\d.]+)\)/.exec(own.transform ?? '') ?? [0, 0];
      const points = parseFloat(own['font-size']) * scale;
      out += `\\definecolor{ffcolour}{HTML}{${colourOf(own.fill)}}\\pgftext[x=${bp(at[0])},y=${bp(-at[1])},${side}base,rotate=${-turned}]` +
             `{\\color{ffcolour}\\fontsize{${points.toFixed(2)}}{${(1.2 * points).toFixed(2)}}\\selectfont ${tex(content)}}\n`;
    }
  }
  return out + '\\end{pgfpicture}%\n';
}
