// SPDX-License-Identifier: GPL-3.0-or-later
// The ends of the line can be dragged, or moved by the arrow keys. The page then runs the pseudo-code itself
// (interpreter.js); its sentences are those of the code with the numbers filled in.
'use strict';
(() => {
  const data = document.getElementById('trace');
  if (!page || !data) return;
  const { line, window: box, y, seen, size, kinds, visible, words } = JSON.parse(data.textContent);
  const code = [...document.querySelectorAll('.code li')].map(li => li.textContent);
  const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
  const run = ends => { try { return interpret(code, ends, box, kinds); } catch { return null; } };
  const own = run(line);
  if (!own || !same(own.visible, visible)) return; // the page cannot run this code

  // Between the drawing and the picture.
  const scale = [size[0] / (seen[2] - seen[0]), size[1] / (seen[3] - seen[1])];
  const placeX = x => (x - seen[0]) * scale[0];
  const placeY = v => y === 'up' ? size[1] - (v - seen[1]) * scale[1] : (v - seen[1]) * scale[1];
  const unit = 10 ** Math.floor(Math.log10(1 / scale[0])); // a move by less than this is not seen
  const round = v => Math.round(v / unit) * unit;
  const readable = v => Number(round(v).toPrecision(12));
  const drawingPoint = (px, py) => [readable(px / scale[0] + seen[0]),
    readable(y === 'up' ? (size[1] - py) / scale[1] + seen[1] : py / scale[1] + seen[1])];

  const number = v => String(Number(v.toPrecision(6))).replace('-', '\u2212');
  const point = (px, py) => '(' + number(px) + ', ' + number(py) + ')';
  const fill = (text, ...values) => values.reduce((all, value, i) => all.replaceAll('%' + (i + 1), value), text);

  const namespace = document.querySelector('.figure').namespaceURI;
  function element(name, attributes, ...children) {
    const made = document.createElementNS(namespace, name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    made.append(...children);
    return made;
  }
  function html(name, className, ...children) {
    const made = document.createElement(name);
    if (className) made.className = className;
    made.append(...children);
    return made;
  }
  const stroke = (a, b, color, width, dashes = '') => element('line', { x1: placeX(a[0]), y1: placeY(a[1]),
    x2: placeX(b[0]), y2: placeY(b[1]), class: 's-' + color, 'stroke-width': width, 'stroke-dasharray': dashes });

  let ends = [...line];

  // An end that can be moved, on every figure.
  function handle(i) {
    const made = element('circle', { class: 'handle', r: 16, tabindex: 0, role: 'button',
      'aria-label': fill(words.handle, i + 1) });
    made.addEventListener('pointerdown', event => {
      made.setPointerCapture(event.pointerId);
      event.preventDefault();
    });
    made.addEventListener('pointermove', event => {
      if (!made.hasPointerCapture(event.pointerId)) return;
      const inverse = made.ownerSVGElement.getScreenCTM().inverse();
      const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(inverse);
      move(i, drawingPoint(Math.min(Math.max(at.x, 0), size[0]), Math.min(Math.max(at.y, 0), size[1])));
    });
    made.addEventListener('keydown', event => {
      const up = y === 'up' ? 1 : -1;
      const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, up], ArrowDown: [0, -up] }[event.key];
      if (!way) return;
      event.preventDefault();
      event.stopPropagation();
      const far = unit * (event.shiftKey ? 10 : 1);
      move(i, [readable(ends[2 * i] + way[0] * far), readable(ends[2 * i + 1] + way[1] * far)]);
    });
    return made;
  }
  const isSeen = i => ends[2 * i] >= seen[0] && ends[2 * i] <= seen[2]
    && ends[2 * i + 1] >= seen[1] && ends[2 * i + 1] <= seen[3];
  function place(made, i) {
    made.setAttribute('cx', placeX(ends[2 * i]));
    made.setAttribute('cy', placeY(ends[2 * i + 1]));
  }

  // The article for the steps of a moved line; its figure is kept, so that a drag goes on.
  const picture = element('g', {}), handles = [handle(0), handle(1)];
  const figure = element('svg', { class: 'figure', viewBox: '0 0 ' + size.join(' ') }, picture, ...handles);
  const told = html('p', 'sentence'), values = html('div', 'values'), back = html('button', '', words.back);
  const article = html('article', 'step own', figure, told, values, html('p', 'moved', words.moved + ' ', back));
  article.hidden = true;
  document.querySelector('.step').parentElement.append(article);

  function paint(step) {
    const [a, b] = [ends.slice(0, 2), ends.slice(2)], left = step.left;
    const parts = [element('rect', { width: size[0], height: size[1], class: 'f-paper' })];
    for (const x of [box[0], box[2]]) parts.push(stroke([x, seen[1]], [x, seen[3]], 'border', 1.2, '6 5'));
    for (const v of [box[1], box[3]]) parts.push(stroke([seen[0], v], [seen[2], v], 'border', 1.2, '6 5'));
    const corners = [[box[0], box[1]], [box[2], box[1]], [box[2], box[3]], [box[0], box[3]]];
    corners.forEach((corner, i) => parts.push(stroke(corner, corners[(i + 1) % 4], 'window', 2.3)));
    parts.push(stroke(a, b, 'muted', 2, '6.5 4.8'));
    if (step.what !== 'reject')
      parts.push(stroke(left.slice(0, 2), left.slice(2), 'text', step.what === 'accept' ? 5 : 4));
    [a, b].forEach((end, i) => {
      const x = placeX(end[0]), v = placeY(end[1]), isLeft = end[0] < [b, a][i][0]; // the label is beyond the end
      parts.push(element('circle', { cx: x, cy: v, r: 6, class: 'f-paper s-text', 'stroke-width': 2.3 }),
        element('text', { x: isLeft ? Math.max(x - 12, 140) : Math.min(x + 12, size[0] - 140), class: 'f-text',
          y: Math.min(Math.max(v - 8, 16), size[1] - 6), 'font-size': 15, 'text-anchor': isLeft ? 'end' : 'start' },
        fill(words.end, i + 1) + ' ' + point(...end)));
    });
    picture.replaceChildren(...parts);
    figure.setAttribute('role', 'group');
    figure.setAttribute('aria-label', fill(words.line, point(...a), point(...b)));
    handles.forEach(place);
  }

  const filled = (text, known) => text.replace(/[A-Za-z_]\w*(\[\w+\])?/g, name => {
    const key = name.replace(/\[(\w+)\]/, (_, index) => '[' + (known.has(index) ? known.get(index) : index) + ']');
    const given = known.has(key) ? key : key[0] + known.get(key[1]); // xi is the x that was given of end i
    return known.has(given) ? number(known.get(given)) : name;
  });
  function sentenceOf(steps, i) {
    const step = steps[i];
    const text = code[step.line - 1].trim();
    if (step.what === 'accept')
      return fill(words.accept, point(...step.left.slice(0, 2)), point(...step.left.slice(2)));
    if (step.what === 'reject') return words.reject;
    if (step.what === 'test') {
      const asked = /^(?:\w+\([^)]*\): )?(?:else )?(?:if|while) (.*?)(?:(?<! ):(?: .*)?)?$/.exec(text)[1];
      return fill(words.test, asked, filled(asked, step.values), step.holds ? words.yes : words.no);
    }
    const now = valuesOf(steps, i).filter(({ changed }) => changed).map(({ name, value }) => name + ' = ' + value);
    return fill(words.does, step.line, text) + (now.length > 0 ? ' ' + fill(words.now, now.join(', ')) : '');
  }
  function table(caption, rows) {
    const made = html('table', '', html('caption', '', caption)), body = html('tbody');
    for (const { name, value, was, changed } of rows)
      body.append(html('tr', changed ? 'changed' : '', html('th', '', name), html('td', '', value),
        html('td', 'was', was)));
    made.append(body);
    return made;
  }
  function valuesOf(steps, i) {
    const now = steps[i].values, before = i > 0 ? steps[i - 1].values : new Map();
    return [...now].filter(([, v]) => typeof v === 'number').map(([name, v]) => {
      const changed = before.get(name) !== v;
      const was = changed && before.has(name) ? fill(words.was, number(before.get(name))) : '';
      return { name, value: number(v), changed, was };
    });
  }
  function costOf(steps, i) {
    const all = steps[steps.length - 1].counts;
    return Object.entries(steps[i].counts).filter(([kind]) => all[kind] > 0)
      .map(([kind, count]) => ({ name: words[kind], value: String(count), was: fill(words.of, all[kind]) }));
  }

  const moved = steps => ({
    count: steps.length,
    number: () => 'moved',
    line: i => steps[i].line,
    place: i => fill(words.place, i + 1, steps.length),
    sentence: i => sentenceOf(steps, i),
    show(i) {
      article.hidden = false;
      paint(steps[i]);
      told.textContent = sentenceOf(steps, i);
      values.replaceChildren(table(words.variables, valuesOf(steps, i)), table(words.operations, costOf(steps, i)));
    },
    leave() { article.hidden = true; },
  });

  function move(i, to) {
    const wanted = [...ends];
    wanted.splice(2 * i, 2, ...to);
    const found = run(wanted);
    if (!found || same(wanted, ends)) return;
    ends = wanted;
    const holds = document.activeElement.classList.contains('handle') && article.hidden;
    page.use(moved(found.steps), found.steps.length - 1, false);
    if (holds) handles[i].focus();
  }

  // On the written figures: a drag begins there and goes on in the article of the moved line.
  back.type = 'button';
  back.addEventListener('click', () => {
    ends = [...line];
    page.use(page.written, 0, true);
  });
  for (const svg of document.querySelectorAll('.step:not(.own) .figure'))
    for (const i of [0, 1]) {
      if (!isSeen(i)) continue;
      const start = handle(i);
      place(start, i);
      start.addEventListener('pointerdown', event => {
        event.stopImmediatePropagation();
        page.use(moved(own.steps), own.steps.length - 1, false);
        handles[i].setPointerCapture(event.pointerId);
      }, { capture: true });
      svg.append(start);
    }
})();
