"use strict";

// Draws the scene and the matrix of a report of `form_factors` or `heat`, and joins them with its table: a face that is
// chosen in one of them is in all.
(() => {
  const {faces, polygons, quantities, matrix} = JSON.parse(document.getElementById("data").textContent);
  const rgb = hex => [0, 2, 4].map(at => parseInt(hex.slice(at, at + 2), 16));
  const sequential = ["440154", "472d7b", "3b528b", "2c728e", "21918c", "28ae80", "5ec962", "addc30", "fde725"]
    .map(rgb);  // viridis
  const $ = id => document.getElementById(id);
  const style = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const number = (value, digits = 5) => value !== 0 && Math.abs(value) < 1e-4
    ? value.toExponential(digits - 1).replace(/\.?0*e/, "e") : Number(value.toPrecision(digits)).toString();
  const withError = (value, error, unit) => `${number(value, 7)}${error > 0 ? ` ± ${number(error, 2)}` : ""} ${unit}`.trim();

  const diverging = ["2166ac", "67a9cf", "d1e5f0", "f7f7f7", "fddbc7", "ef8a62", "b2182b"].map(rgb);  // blue takes up

  function colour(share, light = 1, stops = sequential) {
    const at = Math.min(Math.max(share, 0), 1) * (stops.length - 1);
    const i = Math.min(Math.floor(at), stops.length - 2);
    return `rgb(${stops[i].map((c, k) => Math.round(light * (c + (at - i) * (stops[i + 1][k] - c)))).join()})`;
  }

  /** A canvas at the screen's resolution, with its size in CSS pixels. */
  function begin(canvas) {
    const {clientWidth: width, clientHeight: height} = canvas;
    const scale = window.devicePixelRatio || 1;
    canvas.width = Math.round(width * scale);
    canvas.height = Math.round(height * scale);
    const context = canvas.getContext("2d");
    context.scale(scale, scale);
    context.clearRect(0, 0, width, height);
    return {context, width, height};
  }

  // What is chosen and shown.
  let chosen = -1;
  let shown = quantities[0];
  const rows = matrix.rows.map(row => {
    const entries = new Map();
    for (let k = 0; k < row.length; k += 3) entries.set(row[k], {factor: row[k + 1], error: row[k + 2]});
    return entries;
  });
  const whole = matrix.step === 1;

  function choose(face) {
    chosen = face;
    describe();
    drawScene();
    drawMatrix();
    for (const row of document.querySelectorAll("tbody tr")) row.className = row.dataset.face === String(face) ? "chosen" : "";
  }

  function element(name, text) {
    return Object.assign(document.createElement(name), {textContent: text});
  }

  function describe() {
    const place = $("chosen");
    place.replaceChildren();
    if (chosen < 0) {
      place.append(Object.assign(element("p", "No face is chosen."), {className: "remark"}));
      return;
    }
    const list = element("dl", "");
    for (const {name, unit, values, errors} of quantities)
      list.append(element("dt", name), element("dd", withError(values[chosen], errors[chosen], unit)));
    place.append(element("h2", faces[chosen]), list);
    if (!whole) return;
    const largest = [...rows[chosen]].sort((a, b) => b[1].factor - a[1].factor).slice(0, 8);
    const factors = element("dl", "");
    for (const [to, {factor, error}] of largest)
      factors.append(element("dt", `F to ${faces[to]}`), element("dd", withError(factor, error, "")));
    place.append(factors);
  }

  // The scene: parallel projection, far polygons first.
  const shapes = polygons.map(([face, ...at]) => {
    const corners = [];
    for (let k = 0; k < at.length; k += 3) corners.push(at.slice(k, k + 3));
    const normal = [0, 0, 0];
    for (let i = 1; i + 1 < corners.length; ++i) {
      const [u, v] = [corners[i], corners[i + 1]].map(corner => corner.map((x, k) => x - corners[0][k]));
      for (let k = 0; k < 3; ++k) normal[k] += u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
    }
    const length = Math.hypot(...normal) || 1;
    return {face, corners, normal: normal.map(x => x / length)};
  });
  const low = [Infinity, Infinity, Infinity];
  const high = low.map(x => -x);
  for (const {corners} of shapes) {
    for (const corner of corners) corner.forEach((x, k) => { low[k] = Math.min(low[k], x); high[k] = Math.max(high[k], x); });
  }
  const centre = low.map((x, k) => (x + high[k]) / 2);
  const radius = Math.hypot(...low.map((x, k) => (high[k] - x) / 2)) || 1;
  let azimuth = 0.6;
  let height = 0.45;
  let size = 1;
  let drawn = [];  // near polygons last

  function drawScene() {
    const canvas = $("drawing");
    const {context, width, height: tall} = begin(canvas);
    const [sa, ca, sh, ch] = [Math.sin(azimuth), Math.cos(azimuth), Math.sin(height), Math.cos(height)];
    const right = [-sa, ca, 0];
    const up = [-sh * ca, -sh * sa, ch];
    const towards = [ch * ca, ch * sa, sh];
    const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const scale = size * 0.48 * Math.min(width, tall) / radius;
    const scaleOfColours = coloursOf(shown);
    const from = x => x.map((c, k) => c - centre[k]);
    drawn = shapes.map(({face, corners, normal}) => {
      const places = corners.map(from);
      const depth = places.reduce((sum, place) => sum + dot(place, towards), 0) / places.length;
      const facing = dot(normal, towards);
      return {face, depth, facing, points: places.map(p => [width / 2 + scale * dot(p, right), tall / 2 - scale * dot(p, up)])};
    }).sort((a, b) => a.depth - b.depth);
    const ink = style("--ink");
    const outline = drawn.length < 3000;
    for (const {face, facing, points} of drawn) {
      context.beginPath();
      points.forEach(([x, y], k) => k === 0 ? context.moveTo(x, y) : context.lineTo(x, y));
      context.closePath();
      const behind = face >= 0 && facing <= 1e-9;
      if (!behind) {
        const light = 0.7 + 0.3 * Math.abs(facing);
        context.fillStyle = face < 0 ? "#8888" : scaleOfColours.colour(shown.values[face], light);
        context.fill();
      }
      context.globalAlpha = behind ? 0.25 : 0.5;
      context.strokeStyle = behind || outline || face === chosen ? ink : context.fillStyle;
      context.lineWidth = 0.6;
      if (face === chosen) { context.globalAlpha = 1; context.lineWidth = 2.5; }
      if (!behind || outline || face === chosen) context.stroke();
      context.globalAlpha = 1;
    }
    drawLegend(scaleOfColours);
  }

  /** Colours of a quantity: around 0 where it has both signs, one where its values do not differ beyond their errors. */
  function coloursOf({values, errors}) {
    const least = Math.min(...values);
    const most = Math.max(...values);
    const range = most - least > 2 * Math.max(...errors) ? most - least : 0;
    if (range > 0 && least < 0 && most > 0) {
      const largest = Math.max(-least, most);
      return {least, range, colour: (value, light = 1) => colour(0.5 + 0.5 * value / largest, light, diverging)};
    }
    return {least, range, colour: (value, light = 1) => colour(range > 0 ? (value - least) / range : 0.5, light)};
  }

  function drawLegend({least, range, colour}) {
    const [canvas, text] = $("legend").children;
    const context = canvas.getContext("2d");
    for (let x = 0; x < canvas.width; ++x) {
      context.fillStyle = colour(least + range * x / canvas.width);
      context.fillRect(x, 0, 1, canvas.height);
    }
    text.textContent = range > 0 ? `${number(least)} to ${number(least + range)} ${shown.unit}` : `${number(least)} ${shown.unit}`;
  }

  function faceAt(x, y) {
    for (let i = drawn.length - 1; i >= 0; --i) {
      const {face, facing, points} = drawn[i];
      if (face >= 0 && facing <= 1e-9) continue;
      let inside = false;
      for (let k = 0, j = points.length - 1; k < points.length; j = k++) {
        const [[ax, ay], [bx, by]] = [points[k], points[j]];
        if ((ay > y) !== (by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax)) inside = !inside;
      }
      if (inside) return face;
    }
    return -1;
  }

  /** Calls `moved` with steps of a drag, and `clicked` where the pointer did not move. */
  function onDrag(canvas, moved, clicked) {
    let last = null;
    let travelled = 0;
    canvas.addEventListener("pointerdown", event => {
      last = [event.offsetX, event.offsetY];
      travelled = 0;
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointermove", event => {
      if (!last) return;
      const [dx, dy] = [event.offsetX - last[0], event.offsetY - last[1]];
      travelled += Math.abs(dx) + Math.abs(dy);
      last = [event.offsetX, event.offsetY];
      if (travelled > 3) moved(dx, dy);
    });
    canvas.addEventListener("pointerup", event => {
      if (last && travelled <= 3) clicked(event.offsetX, event.offsetY);
      last = null;
    });
    canvas.addEventListener("pointercancel", () => { last = null; });
  }

  function turn(dx, dy) {
    azimuth -= dx / 120;
    height = Math.min(Math.max(height + dy / 120, -1.5), 1.5);
    drawScene();
  }

  onDrag($("drawing"), turn, (x, y) => choose(faceAt(x, y)));
  $("drawing").addEventListener("keydown", event => {
    const steps = {ArrowLeft: [12, 0], ArrowRight: [-12, 0], ArrowUp: [0, 12], ArrowDown: [0, -12]}[event.key];
    if (steps) turn(...steps);
    else if (event.key === "+" || event.key === "-") { size *= event.key === "+" ? 1.2 : 1 / 1.2; drawScene(); }
    else if (event.key === "Enter") choose((chosen + 1) % faces.length);
    else return;
    event.preventDefault();
  });

  // The matrix: logarithmic colours; `first` and `count` say what is seen of it.
  const n = rows.length;
  let count = n;
  const first = [0, 0];  // column, row
  const largest = Math.max(...rows.flatMap(row => [...row.values()].map(entry => entry.factor)), 1e-300);
  const decades = 5;
  const nameOf = k => whole ? faces[k] : `${faces[k * matrix.step]} – ${faces[Math.min((k + 1) * matrix.step, faces.length) - 1]}`;
  let margin = 0;

  function drawMatrix() {
    const {context, width} = begin($("matrix"));
    const named = count <= 40;
    margin = named ? Math.min(110, width / 4) : 0;
    const cell = (width - margin) / count;
    for (let i = 0; i < count; ++i) {
      for (const [column, {factor}] of rows[first[1] + i]) {
        const j = column - first[0];
        if (j < 0 || j >= count || factor <= 0) continue;
        context.fillStyle = colour(1 + Math.log10(factor / largest) / decades);
        context.fillRect(margin + j * cell, margin + i * cell, Math.ceil(cell), Math.ceil(cell));
      }
    }
    context.fillStyle = style("--ink");
    context.strokeStyle = style("--ink");
    context.font = `${Math.min(13, Math.max(8, cell))}px sans-serif`;
    const cut = name => name.length > 15 ? `${name.slice(0, 14)}…` : name;
    for (let k = 0; named && k < count; ++k) {
      context.textBaseline = "middle";
      context.textAlign = "right";
      context.fillText(cut(nameOf(first[1] + k)), margin - 4, margin + (k + 0.5) * cell, margin - 6);
      context.save();
      context.translate(margin + (k + 0.5) * cell, margin - 4);
      context.rotate(-Math.PI / 2);
      context.textAlign = "left";
      context.fillText(cut(nameOf(first[0] + k)), 0, 0, margin - 6);
      context.restore();
    }
    const row = Math.floor(chosen / matrix.step) - first[1];
    if (chosen >= 0 && row >= 0 && row < count) context.strokeRect(margin, margin + row * cell, width - margin, cell);
    $("matrix-note").textContent = `From the face of the row to that of the column; colours from ${number(largest * 10 ** -decades, 2)} to ` +
      `${number(largest, 3)}, logarithmic. ${whole ? "" : `Each square stands for ${matrix.step} by ${matrix.step} faces, by the largest factor among them. `}` +
      `${count < n ? `Rows ${first[1] + 1} to ${first[1] + count} of ${n}.` : ""}`;
  }

  function cellAt(x, y) {
    const cell = ($("matrix").clientWidth - margin) / count;
    const [column, row] = [x, y].map((at, k) => first[k] + Math.floor((at - margin) / cell));
    return x < margin || y < margin || row >= n || column >= n ? null : [row, column];
  }

  function look(x, y) {
    const at = cellAt(x, y);
    const entry = at && rows[at[0]].get(at[1]);
    $("cell").textContent = !at ? "" : `F ${nameOf(at[0])} to ${nameOf(at[1])} = ${entry ? withError(entry.factor, entry.error, "") : "0"}`;
    return at;
  }

  function move(columns, lines) {
    [columns, lines].forEach((by, k) => { first[k] = Math.min(Math.max(first[k] + by, 0), n - count); });
    drawMatrix();
  }

  function enlarge(by) {
    const before = count;
    count = Math.min(Math.max(Math.round(count / by), Math.min(n, 5)), n);
    move(Math.round((before - count) / 2), Math.round((before - count) / 2));
  }

  let [rest, restDown] = [0, 0];
  onDrag($("matrix"), (dx, dy) => {
    const cell = ($("matrix").clientWidth - margin) / count;
    [rest, restDown] = [rest - dx / cell, restDown - dy / cell];
    const [columns, lines] = [Math.trunc(rest), Math.trunc(restDown)];
    [rest, restDown] = [rest - columns, restDown - lines];
    move(columns, lines);
  }, (x, y) => {
    const at = look(x, y);
    if (at) choose(at[0] * matrix.step);
  });
  $("matrix").addEventListener("pointermove", event => look(event.offsetX, event.offsetY));
  $("matrix").addEventListener("keydown", event => {
    const step = Math.max(1, Math.round(count / 10));
    const by = {ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step]}[event.key];
    if (!by) return;
    move(...by);
    event.preventDefault();
  });
  $("nearer").addEventListener("click", () => enlarge(1.6));
  $("farther").addEventListener("click", () => enlarge(1 / 1.6));

  for (const {name, unit} of quantities) $("quantity").append(element("option", unit ? `${name}, ${unit}` : name));
  $("quantity").addEventListener("change", () => { shown = quantities[$("quantity").selectedIndex]; drawScene(); });
  const numbers = new Map(faces.map((name, face) => [name, face]));
  for (const row of document.querySelectorAll("caption:not(#groups) ~ tbody tr")) {
    row.dataset.face = numbers.get(row.querySelector("th").textContent);
    row.addEventListener("click", () => choose(Number(row.dataset.face)));
  }
  const redraw = () => { drawScene(); drawMatrix(); };
  window.addEventListener("resize", redraw);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
  redraw();
})();
