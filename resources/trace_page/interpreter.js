// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a pseudo-code as it stands on the page. `interpret(code, line, window)` gives the steps, the operations and the
// result; it throws if the code has a line that it cannot run.
'use strict';
const interpret = (() => {
  const sign = v => v > 0 ? 1 : v < 0 ? -1 : 0;
  const edges = { xmin: 0, xmax: 0, ymin: 1, ymax: 1 }; // the axis of each
  const constants = { true: 1, false: 0, LEFT: 1, RIGHT: 2, BOTTOM: 4, TOP: 8 };
  const functions = { outcode: 2, sign: 1, min: 2, max: 2, abs: 1, held: 1, atEdge: 1, vertical: 1, edge: 1 };
  const levels = [['or'], ['and'], [], ['<', '>', '<=', '>=', '==', '!='], ['|'], ['&'], ['+', '-'], ['*', '/']];
  const operation = { '+': 'additions', '-': 'additions', '*': 'multiplications', '/': 'divisions', '<': 'comparisons',
    '>': 'comparisons', '<=': 'comparisons', '>=': 'comparisons', '==': 'comparisons', '!=': 'comparisons' };
  const compute = { '+': (a, b) => a + b, '-': (a, b) => a - b, '*': (a, b) => a * b, '/': (a, b) => a / b,
    '|': (a, b) => (a | b) >>> 0, '&': (a, b) => (a & b) >>> 0, '<': (a, b) => +(a < b), '>': (a, b) => +(a > b),
    '<=': (a, b) => +(a <= b), '>=': (a, b) => +(a >= b), '==': (a, b) => +(a === b), '!=': (a, b) => +(a !== b) };

  // The formulas of a line, from left to right.
  class Reader {
    constructor(text, loops) {
      this.tokens = text.match(/[A-Za-z_]\w*|\d[\d.]*|[<>=!]=|\S/g) || [];
      this.at = 0;
      this.loops = loops;
    }
    get done() { return this.at >= this.tokens.length; }
    sees(token, further = 0) { return this.tokens[this.at + further] === token; }
    takes(token) { return this.sees(token) && ++this.at > 0; }
    expect(token) {
      if (!this.takes(token)) throw new Error('“' + token + '” is missing in: ' + this.tokens.join(' '));
    }
    next() { return this.tokens[this.at++]; }
    expression() {
      const test = this.level(0);
      if (!this.takes('?')) return test;
      const yes = this.expression();
      this.expect(':');
      return { is: 'choice', parts: [test, yes, this.expression()] };
    }
    list() {
      const all = [this.expression()];
      while (this.takes(',')) all.push(this.expression());
      return all;
    }
    level(n) {
      if (n === levels.length) return this.unary();
      if (n === 2 && this.takes('not')) return { is: 'not', parts: [this.level(n)] };
      let left = this.level(n + 1);
      while (levels[n].includes(this.tokens[this.at]))
        left = { is: this.next(), parts: [left, this.level(n + 1)] };
      return left;
    }
    unary() {
      if (this.takes('-')) return { is: 'negative', parts: [this.unary()] };
      if (this.takes('~')) return { is: 'complement', parts: [this.unary()] };
      if (this.takes('(')) {
        const inner = this.expression();
        this.expect(')');
        return inner;
      }
      const word = this.next();
      if (word === undefined) throw new Error('A formula ends too early: ' + this.tokens.join(' '));
      if (/^\d/.test(word)) return { is: 'value', value: /^[01]{4}$/.test(word) ? parseInt(word, 2) : Number(word) };
      if (!/^[A-Za-z_]/.test(word)) throw new Error('“' + word + '” is not understood');
      if (word in constants) return { is: 'value', value: constants[word] };
      if (this.takes('(')) {
        const parts = this.sees(')') ? [] : this.list();
        this.expect(')');
        if (word in functions && functions[word] !== parts.length) throw new Error(word + ' has other arguments');
        return { is: word in functions ? 'function' : 'call', name: word, parts };
      }
      if (this.takes('[')) {
        const index = this.expression();
        this.expect(']');
        return { is: 'element', name: word, parts: [index], close: ']', open: '[' };
      }
      if (/^[xy].$/.test(word) && this.loops.has(word[1])) // xi is the x that was given of end i
        return { is: 'element', name: word[0], parts: [{ is: 'name', name: word[1], parts: [] }], open: '', close: '' };
      return { is: 'name', name: word, parts: [] };
    }
  }

  // A line as a statement; what follows after a colon is its body.
  function statementOf(text, number, loops) {
    const reader = new Reader(text, loops);
    const one = { number, text, body: [] };
    const rest = reader.tokens.slice(1);
    if (reader.takes('accept')) {
      one.is = 'accept';
      if (!reader.done) {
        reader.at = 4; // accept the line from
        one.ends = [reader.expression()];
        for (const between of [',', 'to', ',']) { reader.expect(between); one.ends.push(reader.expression()); }
      }
    } else if (reader.takes('reject')) one.is = 'reject';
    else if (reader.takes('return')) one.is = 'return';
    else if (reader.takes('hold')) return { ...one, is: 'hold' };
    else if (reader.takes('give')) return { ...one, is: 'give up', most: Number(rest.find(t => /^\d/.test(t))) };
    else if (reader.takes('turn') || reader.takes('mirror') || reader.sees('(', 1)) {
      one.is = 'call';
      one.turns = reader.at > 0;
      one.call = reader.expression();
      if (one.call.is !== 'call') throw new Error('This is no statement: ' + text);
    } else {
      one.is = 'let';
      one.sets = [];
      do {
        if (reader.takes('return')) { one.returns = true; break; }
        const target = reader.unary();
        if (target.is !== 'name' && target.is !== 'element') throw new Error('This is no statement: ' + text);
        reader.expect('=');
        one.sets.push({ target, value: reader.expression() });
      } while (reader.takes(','));
    }
    if (!reader.done) throw new Error('The end of this line is not understood: ' + text);
    return one;
  }

  function lineOf(text, number, loops) {
    const made = (head, body) => {
      const one = { number, text, ...head, body: [] };
      if (body) one.body.push(statementOf(body, number, loops));
      return one;
    };
    let found;
    if ((found = /^(\w+)\(([\w, ]*)\): *(.*)$/.exec(text)) && !/^(if|while|else)\b/.test(text)) {
      const names = found[2].split(',').map(name => name.trim()).filter(Boolean);
      const body = found[3] ? [lineOf(found[3], number, loops)] : [];
      return { number, text, is: 'define', name: found[1], names, body };
    }
    if (text === 'repeat') return made({ is: 'repeat' });
    if (text.startsWith('for each edge')) return made({ is: 'each' });
    if ((found = /^for (\w+) = (.*)$/.exec(text)))
      return made({ is: 'for', name: found[1], values: new Reader(found[2], loops).list() });
    if ((found = /^(else )?(if|while) (.*)$/.exec(text))) {
      const reader = new Reader(found[3], loops), test = reader.expression();
      const colon = reader.takes(':');
      if (!colon && !reader.done) throw new Error('This condition is not understood: ' + text);
      const body = colon ? reader.tokens.slice(reader.at).join(' ') : '';
      return made({ is: found[2], otherwise: !!found[1], test }, body);
    }
    if ((found = /^else(?:: *(.*))?$/.exec(text))) return made({ is: 'else', otherwise: true }, found[1]);
    return statementOf(text, number, loops);
  }

  // The lines as a tree, by their indentation.
  function programOf(code) {
    const loops = new Set(code.map(line => /^ *for (\w+) =/.exec(line)).filter(Boolean).map(found => found[1]));
    const root = { body: [] }, open = [root];
    code.forEach((text, i) => {
      const depth = /^ */.exec(text)[0].length / 2;
      const one = lineOf(text.trim(), i + 1, loops);
      const above = open[Math.min(depth, open.length - 1)];
      if (one.is === 'define') one.body.forEach(inner => { open[depth + 2] = inner; });
      above.body.push(one);
      open.length = depth + 1;
      open.push(one);
    });
    const accepts = root.body.map(one => one.is).lastIndexOf('accept');
    const isTable = (one, i) => i > accepts && one.is === 'let' && accepts >= 0;
    return {
      tables: root.body.filter(isTable),
      define: new Map(root.body.filter(one => one.is === 'define').map(one => [one.name, one])),
      body: root.body.filter((one, i) => one.is !== 'define' && !isTable(one, i)),
    };
  }

  function acceptedIn(body) {
    for (const one of body) {
      if (one.ends) return one.ends;
      const deeper = acceptedIn(one.body);
      if (deeper) return deeper;
    }
    return null;
  }

  class Ended { constructor(outcome) { this.outcome = outcome; } }
  class Returned {}

  class Run {
    constructor(program, line, window, kinds) {
      this.program = program;
      this.kinds = kinds;
      this.values = new Map(['x1', 'y1', 'x2', 'y2'].map((name, i) => [name, line[i]]));
      ['xmin', 'ymin', 'xmax', 'ymax'].forEach((name, i) => this.values.set(name, window[i]));
      this.counts = { comparisons: 0, additions: 0, multiplications: 0, divisions: 0, negations: 0 };
      this.steps = [];
      this.places = new Map(); // the edge at which a variable got its value
      this.given = new Map();  // how often a line that gives up was reached
      this.edge = null;
      this.planes = [];
      this.looked = new Set();
      this.tables = new Map();
      for (const table of program.tables)
        for (const { target } of table.sets) this.tables.set(this.keyOf(target), table);
      this.cutAt = [null, null]; // the axis of the edge at which each end was cut last
      const ends = acceptedIn(program.body.concat([...program.define.values()]));
      this.ends = (ends || []).map(end => this.keyOf(end));
      if (this.ends.length !== 4) throw new Error('No line accepts an end');
    }
    // A line below the end is a table: it is run when a procedure first uses it.
    get(name) {
      const table = this.tables.get(name);
      if (table && !this.looked.has(table)) {
        this.looked.add(table);
        for (const { target, value } of table.sets) this.set(target, this.value(value));
        if (table.sets.some(({ value }) => value.parts && value.is !== 'name')) this.tell(table, 'let', false);
      }
      if (!this.values.has(name)) throw new Error(name + ' has no value yet');
      return this.values.get(name);
    }
    keyOf(target) {
      return target.is === 'name' ? target.name
        : target.name + target.open + this.value(target.parts[0]) + target.close;
    }
    isNumber(e) {
      if (e.is === 'name' || e.is === 'element') {
        const key = this.keyOf(e);
        return !(this.kinds[key] || this.kinds[e.name + e.open] || '').match(/whole|bits|truth/);
      }
      if ('+-*/'.includes(e.is) || e.is === 'negative') return e.parts.some(part => this.isNumber(part));
      if (e.is === 'choice') return this.isNumber(e.parts[1]) || this.isNumber(e.parts[2]);
      return e.is === 'function' && ['min', 'max', 'abs', 'held', 'edge'].includes(e.name);
    }
    count(kind, times = 1) { this.counts[kind] += times; }
    clamped(value, low, high) {
      this.count('comparisons', value < low ? 1 : 2);
      return value < low ? low : value > high ? high : value;
    }
    call(e) {
      const inner = () => this.value(e.parts[0]);
      const place = () => this.places.get(e.parts[0].is === 'name' ? e.parts[0].name : '');
      switch (e.name) {
        case 'outcode': {
          const [x, y] = e.parts.map(part => this.value(part));
          const side = (v, low, high) => {
            this.count('comparisons', v < low ? 1 : 2);
            return v < low ? 1 : v > high ? 2 : 0;
          };
          return side(x, this.get('xmin'), this.get('xmax')) + 4 * side(y, this.get('ymin'), this.get('ymax'));
        }
        case 'sign': this.count('comparisons'); return sign(inner());
        case 'abs': this.count('comparisons'); return Math.abs(inner());
        case 'min': { this.count('comparisons'); const a = inner(), b = this.value(e.parts[1]); return b < a ? b : a; }
        case 'max': { this.count('comparisons'); const a = inner(), b = this.value(e.parts[1]); return a < b ? b : a; }
        case 'held': return this.clamped(inner(), this.get(this.axis + 'min'), this.get(this.axis + 'max'));
        case 'atEdge': return +(place() !== undefined);
        case 'vertical': return +(edges[place()] === 0);
        default: return this.get(place());
      }
    }
    value(e) {
      const part = i => this.value(e.parts[i]);
      switch (e.is) {
        case 'value': return e.value;
        case 'name': case 'element': return this.get(this.keyOf(e));
        case 'negative': if (this.isNumber(e.parts[0])) this.count('negations'); return -part(0);
        case 'complement': return ~part(0) >>> 0;
        case 'not': return +!part(0);
        case 'and': return +(part(0) !== 0 && part(1) !== 0);
        case 'or': return +(part(0) !== 0 || part(1) !== 0);
        case 'choice': return part(0) !== 0 ? part(1) : part(2);
        case 'function': return this.call(e);
        case 'call': this.procedure(e, false); return 1;
        default:
          if (operation[e.is] && e.parts.some(p => this.isNumber(p))) this.count(operation[e.is]);
          return compute[e.is](part(0), part(1));
      }
    }
    // What is left of the line, in the picture.
    left() {
      const [x1, y1, x2, y2] = this.ends.map(name => this.values.has(name) ? this.values.get(name) : NaN);
      let ends = [[x1, y1], [x2, y2]];
      for (const plane of [...this.planes].reverse())
        ends = ends.map(end => {
          const before = [];
          plane.forEach(({ axis, factor }, k) => { before[axis] = factor * end[k]; });
          return before;
        });
      return ends.flat();
    }
    tell(one, what, holds) {
      const left = this.left();
      this.steps.push({ line: one.number, what, holds, left: left.some(Number.isNaN) ? this.before : left,
        values: new Map(this.values), counts: { ...this.counts } });
      this.before = this.steps[this.steps.length - 1].left;
    }
    set(target, value) {
      const key = this.keyOf(target);
      this.values.set(key, value);
      this.edge ? this.places.set(key, this.edge) : this.places.delete(key);
      return key;
    }
    procedure(e, turns) {
      const define = this.program.define.get(e.name);
      if (!define || define.names.length !== e.parts.length) throw new Error('No line defines ' + e.name);
      const names = e.parts.map(part => JSON.stringify(part).match(/[xy](?:min|max)/g)).flat().filter(Boolean);
      const window = ['xmin', 'ymin', 'xmax', 'ymax'].map(name => [name, this.get(name)]);
      const edge = this.edge;
      this.looked.clear();
      if (names.length === 1) this.edge = names[0];
      const values = e.parts.map(part => this.value(part));
      if (turns) this.turn(define.names, e.parts);
      define.names.forEach((name, i) => this.set({ is: 'name', name }, values[i]));
      try { this.run(define.body); } catch (end) { if (!(end instanceof Returned)) throw end; }
      if (turns) this.turnBack(window);
      this.edge = edge;
    }
    turn(names, parts) {
      const plane = ['xmin', 'ymin'].map(name => {
        const part = parts[names.indexOf(name)], isNegative = part.is === 'negative';
        return { axis: edges[(isNegative ? part.parts[0] : part).name], factor: isNegative ? -1 : 1 };
      });
      const old = [['x1', 'y1'], ['x2', 'y2']].map(end => end.map(name => this.get(name)));
      old.forEach((end, i) => plane.forEach(({ axis, factor }, k) => {
        if (factor < 0) this.count('negations');
        this.values.set('xy'[k] + (i + 1), factor * end[axis]);
      }));
      this.planes.push(plane);
    }
    turnBack(window) {
      const left = [['x1', 'y1'], ['x2', 'y2']].map(end => end.map(name => this.get(name))), plane = this.planes.pop();
      left.forEach((end, i) => plane.forEach(({ axis, factor }, k) => {
        if (factor < 0) this.count('negations');
        this.values.set('xy'[axis] + (i + 1), factor * end[k]);
      }));
      window.forEach(([name, value]) => this.values.set(name, value));
    }
    let(one) {
      let moves = false;
      for (const { target, value } of one.sets) {
        const end = this.ends.indexOf(this.keyOf(target));
        this.axis = this.keyOf(target)[0];
        const found = this.value(value), key = this.set(target, found);
        moves = moves || end >= 0;
        if (end >= 0 && value.is === 'name' && value.name in edges) this.cutAt[end >> 1] = end % 2;
        if (key in edges) throw new Error('The window is assigned to');
      }
      this.tell(one, moves ? 'cut' : 'let', false);
      if (one.returns) throw new Returned();
    }
    hold(one) {
      this.ends.forEach((name, k) => {
        if (one.text.includes('new') && (this.cutAt[k >> 1] === null || this.cutAt[k >> 1] === k % 2)) return;
        const axis = 'xy'[k % 2];
        this.values.set(name, this.clamped(this.get(name), this.get(axis + 'min'), this.get(axis + 'max')));
      });
      this.tell(one, 'cut', false);
    }
    asks(one) {
      const holds = this.value(one.test) !== 0;
      if (one.test.is !== 'call') this.tell(one, 'test', holds);
      return holds;
    }
    each(one) { // counterclockwise from the bottom edge
      const [xmin, ymin, xmax, ymax] = ['xmin', 'ymin', 'xmax', 'ymax'].map(name => this.get(name));
      const rows = [['ymin', xmin, ymin, xmax, ymin, 0, 1], ['xmax', xmax, ymin, xmax, ymax, -1, 0],
        ['ymax', xmax, ymax, xmin, ymax, 0, -1], ['xmin', xmin, ymax, xmin, ymin, 1, 0]];
      for (const [edge, ...values] of rows) {
        this.edge = edge;
        ['xv', 'yv', 'xw', 'yw', 'nx', 'ny'].forEach((name, i) => this.values.set(name, values[i]));
        this.run(one.body);
      }
      this.edge = null;
    }
    run(body) {
      let chosen = false;
      for (const one of body) {
        if (this.steps.length > 20000) throw new Error('This run does not end');
        if (one.otherwise && chosen) continue;
        if (!one.otherwise) chosen = false;
        switch (one.is) {
          case 'let': this.let(one); break;
          case 'hold': this.hold(one); break;
          case 'call': this.procedure(one.call, one.turns); break;
          case 'return': throw new Returned();
          case 'accept': this.tell(one, 'accept', false); throw new Ended('visible');
          case 'reject': this.tell(one, 'reject', false); throw new Ended('invisible');
          case 'give up': {
            const times = (this.given.get(one) || 0) + 1;
            this.given.set(one, times);
            if (times > one.most) { this.tell(one, 'give up', false); throw new Ended('did not end'); }
            break;
          }
          case 'if': if (this.asks(one)) { chosen = true; this.run(one.body); } break;
          case 'else': this.run(one.body); break;
          case 'while': while (this.asks(one)) this.run(one.body); break;
          case 'repeat': for (;;) this.run(one.body);
          case 'each': this.each(one); break;
          case 'for':
            for (const value of one.values) {
              this.values.set(one.name, this.value(value));
              this.run(one.body);
            }
            break;
          case 'define': break;
          default: throw new Error('This line cannot be run: ' + one.text);
        }
      }
    }
  }

  // A window without height or width is met in one point, whatever the rounding of its ends: the library's corrected
  // forms, which hold their ends, return one.
  function asOnePoint([x1, y1, x2, y2], line, [xmin, ymin, xmax, ymax]) {
    const [, , bx, by] = line;
    const crosses = (xmin === xmax && line[0] !== bx) || (ymin === ymax && line[1] !== by);
    if (!crosses) return [x1, y1, x2, y2];
    const isInside = bx >= xmin && bx <= xmax && by >= ymin && by <= ymax;
    return isInside ? [x2, y2, x2, y2] : [x1, y1, x1, y1];
  }

  return (code, line, window, kinds = {}) => {
    const run = new Run(programOf(code), line, window, kinds);
    run.before = line;
    let outcome = 'visible';
    try { run.run(run.program.body); } catch (end) {
      if (!(end instanceof Ended)) throw end;
      outcome = end.outcome;
    }
    let visible = outcome === 'visible' ? run.left() : null;
    if (visible && code.some(text => /^ *hold /.test(text))) visible = asOnePoint(visible, line, window);
    return { outcome, visible, steps: run.steps, counts: run.counts };
  };
})();
if (typeof module !== 'undefined') module.exports = interpret;
