// SPDX-License-Identifier: GPL-3.0-or-later
// Asks the questions of a lesson. Without it, all pages stand below each other, as on paper, and the answers at
// the end. As in the window: a right first try counts, a second try and a shown answer teach and earn nothing.
'use strict';
(() => {
  const find = id => document.getElementById(id);
  const words = JSON.parse(find('words').textContent);
  const fill = (text, ...values) => values.reduce((all, value, i) => all.replaceAll('%' + (i + 1), value), text);
  const articles = [...document.querySelectorAll('.page')];
  let pages = [], at = 0;

  function shuffle(things) {
    for (let i = things.length - 1; i > 0; --i) {
      const k = Math.floor(Math.random() * (i + 1));
      [things[i], things[k]] = [things[k], things[i]];
    }
    return things;
  }

  // A page with one of its lines, unanswered. `before` is the number of the line that it had.
  function freshPage(article, before) {
    const lines = [...article.querySelectorAll('.about')];
    const others = lines.map((_, i) => i).filter(i => i !== before || lines.length === 1);
    const number = others[Math.floor(Math.random() * others.length)];
    lines.forEach((line, i) => { line.hidden = i !== number; });
    const line = lines[number], form = line.querySelector('.ask');
    const page = { article, number, line, form, wrong: 0, settled: !form, atOnce: false, choices: [] };
    if (!form) return page;
    if (!form.original) form.original = [...form.querySelectorAll('.choice')];
    page.right = form.original[Number(form.dataset.right)];
    page.choices = shuffle([...form.original]);
    const fieldset = form.querySelector('fieldset'), last = form.querySelector('.show');
    page.choices.forEach((choice, i) => {
      fieldset.insertBefore(choice, last);
      choice.className = 'choice';
      choice.disabled = false;
      choice.removeAttribute('aria-description');
      choice.title = String(i + 1);
      choice.onclick = () => choose(page, choice);
    });
    last.hidden = false;
    last.onclick = () => settle(page, '');
    form.onsubmit = () => false;
    form.querySelector('.verdict').textContent = '';
    reveal(page, false);
    return page;
  }

  function reveal(page, answered) {
    const told = page.line.querySelector('.told'), after = page.line.querySelector('.answered');
    if (told) told.hidden = !answered;
    if (!after) return;
    after.hidden = !answered;
    page.line.querySelector('.asked').hidden = answered;
  }

  function settle(page, sentence) {
    const reason = page.form.querySelector('.reason').innerHTML, verdict = page.form.querySelector('.verdict');
    page.settled = true;
    page.choices.forEach(choice => { choice.disabled = choice !== page.right; });
    page.right.classList.add('is-right');
    page.form.querySelector('.show').hidden = true;
    verdict.innerHTML = sentence ? fill(sentence, reason) : reason;
    reveal(page, true);
    showBar();
    if (at < pages.length - 1) find('next').focus({ preventScroll: true });
  }

  function choose(page, choice) {
    if (page.settled || choice.disabled) return;
    if (choice === page.right) {
      page.atOnce = page.wrong === 0;
      return settle(page, words.right);
    }
    choice.classList.add('is-wrong');
    choice.disabled = true;
    if (++page.wrong === 2) return settle(page, words.wrong);
    const hint = page.form.querySelector('.hint').innerHTML;
    page.form.querySelector('.verdict').innerHTML = fill(words.again, hint);
  }

  function showBar() {
    const page = pages[at], right = pages.filter(one => one.atOnce).length, isLast = at === pages.length - 1;
    find('place').textContent = fill(words.place, at + 1, pages.length);
    find('score').textContent = words.questions > 0 ? fill(words.score, right, words.questions, words.needed) : '';
    find('back').disabled = at === 0;
    find('skip').hidden = page.settled;
    find('next').disabled = !page.settled || isLast;
    find('ending').hidden = !isLast || !page.settled || words.questions === 0;
    find('verdict').textContent =
      fill(right >= words.needed ? words.passed : words.failed, right, words.questions, words.needed);
  }

  function go(page) {
    if (page < 0 || page >= pages.length || (page > at && !pages[at].settled)) return;
    at = page;
    pages.forEach((one, i) => { one.article.hidden = i !== at; });
    showBar();
    window.scrollTo(0, 0);
  }

  function begin() {
    pages = articles.map((article, i) => freshPage(article, pages[i] ? pages[i].number : -1));
    at = 0;
    go(0);
  }

  function skip() {
    if (!pages[at].settled) settle(pages[at], '');
    if (at < pages.length - 1) go(at + 1);
  }

  document.documentElement.classList.add('js');
  articles.forEach(article => article.querySelector('.about').classList.add('for-paper'));
  find('bar').hidden = false;
  find('back').onclick = () => go(at - 1);
  find('next').onclick = () => go(at + 1);
  find('skip').onclick = skip;
  find('repeat').onclick = begin;
  document.addEventListener('keydown', event => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.shiftKey) return;
    const by = { PageDown: 1, ArrowRight: 1, PageUp: -1, ArrowLeft: -1 }[event.key];
    const choice = pages[at].choices[Number(event.key) - 1];
    if (!by && !(choice && !pages[at].settled)) return;
    event.preventDefault();
    if (by) go(at + by);
    else choose(pages[at], choice);
  });
  begin();
})();
