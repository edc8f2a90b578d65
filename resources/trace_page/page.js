// SPDX-License-Identifier: GPL-3.0-or-later
// Shows one step of the page at a time. Without it, all steps stand below each other, as on paper.
'use strict';
const page = (() => {
  const articles = [...document.querySelectorAll('.step')];
  const lines = [...document.querySelectorAll('.code li')];
  const find = id => document.getElementById(id);
  const slider = find('slider'), heard = find('heard');
  if (articles.length === 0) return null;

  // The steps of the page as it was written. drag.js has others.
  const written = {
    count: articles.length,
    number: i => articles[i].id.replace('step-', ''),
    line: i => Number(articles[i].dataset.line),
    place: i => articles[i].dataset.place,
    sentence: i => articles[i].querySelector('.sentence').textContent,
    show: i => articles.forEach((one, k) => { one.hidden = k !== i; }),
    leave: () => articles.forEach(one => { one.hidden = true; }),
  };
  let steps = written, at = 0;

  function mark(number) {
    lines.forEach((line, i) => {
      if (i + 1 !== number) return line.removeAttribute('aria-current');
      line.setAttribute('aria-current', 'step');
      const box = line.parentElement.parentElement;
      const above = line.offsetTop - box.offsetTop - box.clientHeight / 3;
      if (box.scrollHeight > box.clientHeight) box.scrollTop = above;
    });
  }

  function show(step, tells) {
    at = Math.min(Math.max(step, 0), steps.count - 1);
    steps.show(at);
    mark(steps.line(at));
    slider.value = at;
    slider.setAttribute('aria-valuetext', steps.place(at));
    find('place').textContent = steps.place(at);
    find('first').disabled = find('back').disabled = at === 0;
    find('next').disabled = find('last').disabled = at === steps.count - 1;
    if (!tells) return;
    heard.textContent = steps.place(at) + '. ' + steps.sentence(at);
    try { history.replaceState(null, '', '#' + steps.number(at)); } catch { /* not everywhere */ }
  }

  function use(others, step, tells) {
    if (others !== steps) steps.leave();
    steps = others;
    slider.max = Math.max(steps.count - 1, 1);
    show(step, tells);
  }

  document.documentElement.classList.add('js');
  find('steps').hidden = false;
  const ways = { first: () => 0, back: () => at - 1, next: () => at + 1, last: () => steps.count - 1 };
  const keys = { ArrowLeft: 'back', ArrowRight: 'next', Home: 'first', End: 'last' };
  for (const way of Object.keys(ways)) find(way).addEventListener('click', () => show(ways[way](), true));
  slider.addEventListener('input', () => show(Number(slider.value), true));
  document.addEventListener('keydown', event => {
    const way = keys[event.key];
    if (!way || event.target === slider || event.ctrlKey || event.altKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    show(ways[way](), true);
  });

  let touch = null;
  const stage = document.querySelector('main');
  stage.addEventListener('touchstart', event => {
    touch = event.touches.length === 1 && !event.target.closest('.handle') ? event.touches[0] : null;
  }, { passive: true });
  stage.addEventListener('touchend', event => {
    if (!touch) return;
    const x = event.changedTouches[0].clientX - touch.clientX, y = event.changedTouches[0].clientY - touch.clientY;
    touch = null;
    if (Math.abs(x) > 40 && Math.abs(x) > 2 * Math.abs(y)) show(ways[x < 0 ? 'next' : 'back'](), true);
  }, { passive: true });

  // The number of a step is no id on the page, so that the browser does not scroll there.
  use(written, Math.max(articles.findIndex((_, i) => '#' + written.number(i) === location.hash), 0), false);
  return { use, written, step: () => at };
})();
