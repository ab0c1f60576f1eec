// How a picture's values become a view; shared by report.html and draw_svg.mjs.

/** The specification with the picture's values as its table. */
export function prepare(specification, {columns, rows}) {
  const prepared = structuredClone(specification);
  const table = prepared.data.find(({name}) => name === 'table');
  table.values = rows.map(row => Object.fromEntries(columns.map((column, i) => [column, row[i]])));
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
