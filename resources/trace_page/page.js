// SPDX-License-Identifier: GPL-3.0-or-later
// Shows one step of the page at a time. Without it, all steps stand below each other, as on paper.
'use strict';
(() => {
  const steps = [...document.querySelectorAll('.step')];
  const lines = [...document.querySelectorAll('.code li')];
  const find = id => document.getElementById(id);
  const slider = find('slider'), heard = find('heard');
  if (steps.length < 2) return;
  document.documentElement.classList.add('js');
  find('steps').hidden = false;
  slider.max = steps.length - 1;
  let at = 0;

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
    at = Math.min(Math.max(step, 0), steps.length - 1);
    steps.forEach((one, i) => { one.hidden = i !== at; });
    const here = steps[at];
    mark(Number(here.dataset.line));
    slider.value = at;
    slider.setAttribute('aria-valuetext', here.dataset.place);
    find('place').textContent = here.dataset.place;
    find('first').disabled = find('back').disabled = at === 0;
    find('next').disabled = find('last').disabled = at === steps.length - 1;
    if (!tells) return;
    heard.textContent = here.dataset.place + '. ' + here.querySelector('.sentence').textContent;
    try { history.replaceState(null, '', '#' + here.id); } catch { /* not everywhere */ }
  }

  const ways = { first: () => 0, back: () => at - 1, next: () => at + 1, last: () => steps.length - 1 };
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
    touch = event.touches.length === 1 ? event.touches[0] : null;
  }, { passive: true });
  stage.addEventListener('touchend', event => {
    if (!touch) return;
    const x = event.changedTouches[0].clientX - touch.clientX, y = event.changedTouches[0].clientY - touch.clientY;
    touch = null;
    if (Math.abs(x) > 40 && Math.abs(x) > 2 * Math.abs(y)) show(ways[x < 0 ? 'next' : 'back'](), true);
  }, { passive: true });

  const wanted = steps.findIndex(step => '#' + step.id === location.hash);
  show(Math.max(wanted, 0), false);
})();
