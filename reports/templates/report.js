"use strict";

// Draws the pictures of the report as they come into view, and gives each its controls: show only some methods, choose what is
// shown, save as SVG, read the data as a table.
(() => {
  const read = node => JSON.parse(node.textContent);

  // The numbers of a picture, with the texts of rows, which are numbers of lists on the page.
  const unpacked = ({texts, rows, ...values}) => ({
    ...values, rows: rows.map(row => row.map((cell, i) => i in texts && cell !== null ? texts[i][cell] : cell)),
  });
  const valuesOf = figure => unpacked(read(figure.querySelector(".values")));

  const kinds = Object.fromEntries(
    [...document.querySelectorAll("script[data-kind]")].map(node => [node.dataset.kind, read(node)]));

  function element(name, properties = {}, ...children) {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
  }

  const tip = element("div", {className: "tip", hidden: true});
  document.body.append(tip);

  function showTip(handler, event, item, value) {
    tip.hidden = !value || typeof value !== "object";
    if (tip.hidden) return;
    const lines = Object.entries(value).filter(([, text]) => text !== "" && text !== "null" && text !== undefined);
    tip.replaceChildren(element("dl", {}, ...lines.flatMap(
      ([name, text]) => [element("dt", {textContent: name}), element("dd", {textContent: text})])));
    const room = document.documentElement.clientWidth + window.scrollX - tip.offsetWidth - 8;
    tip.style.left = `${Math.max(8, Math.min(event.pageX + 14, room))}px`;
    tip.style.top = `${event.pageY + 14}px`;
  }

  function addIsolation(controls, view, names) {
    const buttons = names.map(name => element("button", {type: "button", textContent: name, ariaPressed: "false"}));
    for (const button of buttons) {
      button.addEventListener("click", () => {
        button.ariaPressed = String(button.ariaPressed === "false");
        const pressed = buttons.filter(each => each.ariaPressed === "true");
        view.signal("isolate", pressed.map(each => each.textContent)).run();
      });
    }
    controls.append(element("span", {textContent: "Show only:"}), ...buttons);
  }

  function addChoice(controls, view, {signal, label, values}) {
    const list = element("select", {}, ...values.map(value => element("option", {textContent: value})));
    list.addEventListener("change", () => view.signal(signal, list.value).run());
    controls.append(element("label", {}, `${label} `, list));
  }

  function addSaving(controls, view, id) {
    const button = element("button", {type: "button", textContent: "Save as SVG"});
    button.addEventListener("click", async () => {
      const style = getComputedStyle(document.documentElement);
      const svg = (await view.toSVG()).replaceAll(/var\((--\w+)\)/g, (_, name) => style.getPropertyValue(name).trim());
      const link = element("a", {href: URL.createObjectURL(new Blob([svg], {type: "image/svg+xml"})), download: `${id}.svg`});
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
    });
    controls.append(button);
  }

  function fillTable(place, {columns, rows}) {
    const cells = (name, texts) => element("tr", {}, ...texts.map(text => element(name, {textContent: text ?? ""})));
    place.replaceChildren(element("table", {}, element("thead", {}, cells("th", columns)),
                                  element("tbody", {}, ...rows.map(row => cells("td", row)))));
  }

  // One picture among several is in its place: its words, its numbers and its drawing.
  function addAlternatives(figure, all, redraw) {
    const list = element("select", {}, ...all.map(({name}, i) => element("option", {value: i, textContent: name})));
    list.addEventListener("change", () => {
      const {title, finding, description, values} = all[list.value];
      figure.querySelector("figcaption").replaceChildren(element("b", {textContent: title}), ` ${finding}`);
      figure.querySelector(".canvas").ariaLabel = description;
      figure.querySelector(".values").textContent = JSON.stringify(values);
      const table = figure.querySelector("details.data .scroll");
      if (table.firstChild) fillTable(table, valuesOf(figure));
      redraw();
    });
    figure.querySelector(".canvas").before(element("label", {className: "alternatives"}, "Show ", list));
  }

  async function draw(figure) {
    const canvas = figure.querySelector(".canvas");
    const controls = figure.querySelector(".controls");
    let view, values, width;
    const show = async () => {
      values = valuesOf(figure);
      const runtime = vega.parse(vega.prepare(kinds[figure.dataset.kind], values), null, {ast: true});
      const place = element("div", {ariaHidden: "true"});
      const next = new vega.View(runtime, {expr: vega.expressionInterpreter, renderer: "svg", hover: true})
        .initialize(place).tooltip(showTip);
      width = canvas.clientWidth;
      await vega.settle(next, values, width).runAsync();
      view?.finalize();
      view = next;
      canvas.replaceChildren(place);
      controls.replaceChildren();
      if (values.isolate) addIsolation(controls, view, values.isolate);
      if (values.choose) addChoice(controls, view, values.choose);
      addSaving(controls, view, figure.id);
    };
    await show();
    const alternatives = figure.querySelector(".alternatives");
    if (alternatives) addAlternatives(figure, read(alternatives), show);
    figure.dataset.drawn = "true";
    new ResizeObserver(() => {
      if (canvas.clientWidth === width || canvas.clientWidth === 0) return;
      width = canvas.clientWidth;
      vega.resize(view, values, width).run();
    }).observe(canvas);
  }

  function drawOnce(figure) {
    if (figure.dataset.drawn) return;
    figure.dataset.drawn = "begun";
    seen.unobserve(figure);
    draw(figure);
  }

  const seen = new IntersectionObserver(
    entries => entries.filter(entry => entry.isIntersecting).forEach(entry => drawOnce(entry.target)),
    {rootMargin: "400px"});
  for (const figure of document.querySelectorAll("figure.picture")) {
    seen.observe(figure);
    const details = figure.querySelector("details.data");
    details.addEventListener("toggle", () => {
      const place = details.querySelector(".scroll");
      if (!place.firstChild) fillTable(place, valuesOf(figure));
    });
  }
  window.addEventListener("beforeprint", () => {
    for (const figure of document.querySelectorAll("figure.picture")) {
      if (!figure.closest("details:not([open])")) drawOnce(figure);
    }
  });
})();
