// SPDX-License-Identifier: MIT
//
// Evaluated in a page: what it lacks for a screen reader, the margins that it sets for print, in CSS
// pixels, and which of `signs` no font has.
(signs) => {
  const root = document.documentElement;
  const all = (selector) => Array.from(document.querySelectorAll(selector));
  const wrong = [];
  const demand = (holds, sentence) => holds || wrong.push(sentence);

  if (root.tagName !== 'svg') {
    demand(root.lang, 'html has no lang');
    demand(document.title.trim(), 'no title');
    demand(document.characterSet === 'UTF-8' && all('meta[charset]').length, 'no meta charset');
    demand(all('meta[name=viewport]').some((m) => /width=device-width/.test(m.content)),
      'no meta viewport: a phone would show it tiny');
    demand(all('main').length === 1, `${all('main').length} main landmarks, not one`);
    const levels = all('h1,h2,h3,h4,h5,h6').map((h) => Number(h.tagName[1]));
    demand(levels.filter((l) => l === 1).length === 1, 'not exactly one h1');
    demand(levels.every((l, i) => i === 0 ? l === 1 : l <= levels[i - 1] + 1),
      `headings jump: h${levels.join(', h')}`);
  }
  for (const svg of all('svg')) {
    const named = (svg.getAttribute('aria-label') || '').trim() ||
      [...svg.children].some((e) => e.tagName === 'title' && e.textContent.trim());
    demand(svg.getAttribute('aria-hidden') === 'true' || svg.parentElement?.closest('svg') ||
      (svg.getAttribute('role') === 'img' && named), 'a picture without role=img and a title');
  }
  for (const table of all('table')) {
    const heads = Array.from(table.querySelectorAll('th'));
    const name = (table.caption || table).textContent.trim().slice(0, 30);
    demand(heads.length && heads.every((th) => th.scope), `table "${name}": th scope missing`);
    demand(table.caption || table.matches('[aria-label],[aria-labelledby]'),
      `table "${name}": no caption`);
  }
  for (const img of all('img')) {
    demand(img.hasAttribute('alt'), 'an img without alt');
  }
  const ids = all('[id]').map((e) => e.id);
  for (const id of new Set(ids.filter((id, i) => ids.indexOf(id) !== i))) {
    wrong.push(`id ${id} twice`);
  }

  // A sign that no font has is drawn as the same box as an unassigned code.
  const canvas = document.createElementNS('http://www.w3.org/1999/xhtml', 'canvas');
  const draw = (sign) => {
    const ink = canvas.getContext('2d', {willReadFrequently: true});
    ink.clearRect(0, 0, 300, 150);
    ink.font = '40px sans-serif';
    ink.fillText(sign, 10, 60);
    return ink.getImageData(0, 0, 100, 100).data.join();
  };
  const nothing = draw('\u{10FFFE}');
  const missing = Array.from(signs).filter((sign) => draw(sign) === nothing);

  const margins = {};
  const probe = document.createElementNS('http://www.w3.org/1999/xhtml', 'div');
  root.appendChild(probe);
  for (const sheet of document.styleSheets) {
    for (const rule of Array.from(sheet.cssRules).filter((r) => r instanceof CSSPageRule)) {
      for (const side of ['Left', 'Top', 'Right', 'Bottom']) {
        probe.style.paddingLeft = rule.style['margin' + side];
        if (rule.style['margin' + side]) {
          margins[side] = parseFloat(getComputedStyle(probe).paddingLeft);
        }
      }
    }
  }
  probe.remove();
  return {wrong, missing, margins};
}
