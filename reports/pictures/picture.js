// How a picture's values become a view; shared by report.html and draw_svg.mjs.

/** What the values say about scales and axes: domains and ranges by the name of a scale, titles, a logarithmic x axis, which
 * stands above a tall picture. */
function fit(specification, {log, tall, titles = {}, scales = {}}) {
  for (const scale of specification.scales ?? []) {
    if (log && scale.name === 'x') {
      scale.type = 'log';
      delete scale.zero;
    }
    Object.assign(scale, scales[scale.name]);
  }
  for (const axis of specification.axes ?? []) {
    if (axis.title && titles[axis.scale]) axis.title = titles[axis.scale];
    if (tall && axis.orient === 'bottom') axis.orient = 'top';
  }
}

/** The specification with the picture's values as its table. */
export function prepare(specification, values) {
  const {columns, rows} = values;
  const prepared = structuredClone(specification);
  const data = name => prepared.data.find(each => each.name === name);
  data('table').values = rows.map(row => Object.fromEntries(columns.map((column, i) => [column, row[i]])));
  if (values.labels) data('labels').values = values.labels;
  fit(prepared, values);
  return prepared;
}

/** Makes the view as wide as there is room; `aspect` is height / width, where a picture has one. */
export function resize(view, {aspect}, width) {
  view.width(width);
  return aspect ? view.height(width * aspect) : view;
}

/** Sets what the values say about a new view. */
export function settle(view, values, width) {
  if (values.choose) view.signal(values.choose.signal, values.choose.values[0]);
  for (const [name, value] of Object.entries(values.signals ?? {})) view.signal(name, value);
  return resize(view, values, width);
}
