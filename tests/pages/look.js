// SPDX-License-Identifier: MIT
//
// Evaluated in a page: checks its current layout and returns what is wrong, as lists of sentences.
// `view`: {print: bool, font: smallest size in CSS pixels}.
//
// Text is every text node that shows; generated content (::before) is not checked. Marks are the
// shapes of pictures, except for the classes grid, paper, shade and area. elementsFromPoint finds
// what is behind a point, so the viewport must be as high as the page.
(view) => {
  const NO_TEXT = 'style,title,desc,script,metadata,template,noscript';
  const SHAPES = 'line,polyline,polygon,path,circle,ellipse,rect';
  const DECORATIVE = '.grid,.paper,.shade,.area';
  const NOT_DRAWN = 'defs,clipPath,mask,pattern,marker,symbol,linearGradient,radialGradient';
  const TOLERANCE = 1;  // pixels
  const SAMPLES = 200;  // marks of each kind that are checked in a picture
  const found = {cut: [], overlap: [], text: [], marks: [], small: [], smallest: null,
                 paper: [], colours: [], words: ''};
  const root = document.documentElement;
  const isSvg = (e) => e instanceof SVGElement;
  const style = (e) => getComputedStyle(e);
  const quote = (s) => '"' + s.trim().replace(/\s+/g, ' ').slice(0, 40) + '"';
  const describe = (e) => '<' + e.tagName + (e.getAttribute('class') ? ' class="' +
    e.getAttribute('class') + '"' : '') + '>';
  const number = (x) => String(Math.round(x * 100) / 100);
  // Computes only once what does not change during the check: a page has some 100,000 questions
  // about some 1,000 elements.
  const once = (ask) => {
    const answers = new Map();
    return (e) => {
      if (!answers.has(e)) {
        answers.set(e, ask(e));
      }
      return answers.get(e);
    };
  };

  // ---- colours: [r, g, b, alpha], 0 ... 1 ----
  const canvas = document.createElementNS('http://www.w3.org/1999/xhtml', 'canvas');
  canvas.width = canvas.height = 1;
  const ink = canvas.getContext('2d', {willReadFrequently: true});
  const known = new Map();
  const colour = (css) => {
    if (!known.has(css)) {
      ink.clearRect(0, 0, 1, 1);
      ink.fillStyle = css;
      ink.fillRect(0, 0, 1, 1);
      known.set(css, Array.from(ink.getImageData(0, 0, 1, 1).data, (v) => v / 255));
    }
    return known.get(css);
  };
  const over = (top, below) =>
    [0, 1, 2].map((i) => top[i] * top[3] + below[i] * (1 - top[3])).concat(1);
  const luminance = (c) => {
    const [r, g, b] = c.map((v) => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const contrast = (a, b) => {
    const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
    return (high + 0.05) / (low + 0.05);
  };
  const hex = (c) => '#' + c.slice(0, 3).map((v) =>
    Math.round(255 * v).toString(16).padStart(2, '0')).join('');
  const opacity = once((e) => e ? Number(style(e).opacity) * opacity(e.parentElement) : 1);
  const bare = () => { // what a page without any background shows
    if (view.print || isSvg(root)) {
      return [1, 1, 1, 1];
    }
    const probe = document.createElement('i');
    probe.style.color = 'Canvas';
    root.appendChild(probe);
    const c = colour(style(probe).color);
    probe.remove();
    return c;
  };
  const BARE = bare();

  // The colours of a fill or stroke: one, or those of the stops of a gradient.
  const findPaint = (e, which) => {
    const value = style(e)[which];
    const alpha = style(e)[which + 'Opacity'] * opacity(e);
    const gradient = /^url\("?#([^")]+)"?\)/.exec(value);
    if (value === 'none') {
      return [];
    }
    const list = gradient
      ? Array.from(document.getElementById(gradient[1]).querySelectorAll('stop'), (stop) => {
        const c = colour(style(stop).stopColor);
        return [c[0], c[1], c[2], c[3] * style(stop).stopOpacity];
      })
      : [colour(value)];
    return list.map((c) => [c[0], c[1], c[2], c[3] * alpha]);
  };
  const paints = {fill: once((e) => findPaint(e, 'fill')),
    stroke: once((e) => findPaint(e, 'stroke'))};
  const paint = (e, which) => paints[which](e);
  const isShape = once((e) => e.matches(SHAPES));
  // The shades at the edges of a table that can be scrolled leave any text 6:1.
  const hasPicture = once((e) => style(e).backgroundImage !== 'none' && !e.matches('.scroll'));
  const background = once((e) => {
    if ((isSvg(e) && e.tagName !== 'svg') ||
      (view.print && style(e).printColorAdjust !== 'exact')) {
      return []; // text; backgrounds are not printed
    }
    const c = colour(style(e).backgroundColor);
    return [[c[0], c[1], c[2], c[3] * opacity(e)]];
  });

  // What an element paints at a point: its possible colours there, or none.
  const painted = (e, x, y) => {
    if (isShape(e)) {
      const at = new DOMPoint(x, y).matrixTransform(e.getScreenCTM().inverse());
      const stroke = e.isPointInStroke(at) ? paint(e, 'stroke') : [];
      return stroke.length ? stroke : e.isPointInFill(at) ? paint(e, 'fill') : [];
    }
    return background(e);
  };

  // The possible colours of layers, topmost first.
  const blend = (layers) => layers.reverse().reduce((below, layer) => {
    const sums = layer.length ? below.flatMap((b) => layer.map((c) => over(c, b))) : below;
    return [...new Map(sums.map((c) => [hex(c), c])).values()];
  }, [BARE]);

  // ---- text ----
  const clipsAt = (rect, box) => rect.left < box.left - TOLERANCE ||
    rect.right > box.right + TOLERANCE || rect.top < box.top - TOLERANCE ||
    rect.bottom > box.bottom + TOLERANCE;
  const scrolls = (overflow) => !view.print && (overflow === 'auto' || overflow === 'scroll');
  const scroller = (e) => e && e !== document.body && e !== root
    ? (!isSvg(e) && scrolls(style(e).overflowX) ? e : scroller(e.parentElement)) : null;

  let marks = null; // where those are that are not decoration, until something is scrolled
  const showIn = (area, box) => { // scrolls a box into view
    const b = area && area.getBoundingClientRect();
    if (area && (box.right > b.right || box.left < b.left)) {
      marks = null;
      area.scrollLeft += (box.left + box.right - b.left - b.right) / 2;
    }
  };

  // Why the part of `e` in `rect` is not fully visible, or null.
  const cutBy = (e, rect) => {
    const r = {left: rect.left, right: rect.right, top: rect.top, bottom: rect.bottom};
    for (let a = e; a; a = a.parentElement) {
      const s = style(a);
      const b = a.getBoundingClientRect();
      if (s.clipPath !== 'none') {
        return 'clip-path of ' + describe(a);
      }
      if (a.tagName === 'svg') {
        if (clipsAt(r, b)) {
          return 'edge of its picture';
        }
      } else if (!isSvg(a) && a !== root && a !== document.body && s.display !== 'inline') {
        const box = {left: b.left + a.clientLeft, top: b.top + a.clientTop};
        box.right = box.left + a.clientWidth;
        box.bottom = box.top + a.clientHeight;
        for (const [overflow, from, to] of [[s.overflowX, 'left', 'right'],
          [s.overflowY, 'top', 'bottom']]) {
          if (scrolls(overflow)) {
            r[from] = Math.min(Math.max(r[from], box[from]), box[to]);
            r[to] = Math.min(Math.max(r[to], box[from]), box[to]);
          } else if (overflow !== 'visible' &&
            (r[from] < box[from] - TOLERANCE || r[to] > box[to] + TOLERANCE)) {
            return 'overflow of ' + describe(a);
          }
        }
      }
    }
    return clipsAt(r, {left: 0, top: 0, right: root.clientWidth, bottom: Infinity})
      ? 'edge of the page' : null;
  };

  // Line boxes are taller than letters: the part of the height where this text has ink.
  const inkOf = (text, s) => {
    ink.font = [s.fontStyle, s.fontWeight, s.fontSize, s.fontFamily].join(' ');
    const m = ink.measureText(text);
    const height = m.fontBoundingBoxAscent + m.fontBoundingBoxDescent;
    return [(m.fontBoundingBoxAscent - m.actualBoundingBoxAscent) / height,
      (m.fontBoundingBoxAscent + m.actualBoundingBoxDescent) / height];
  };
  const boxesOf = (t) => {
    const matrix = isSvg(t.element) ? t.element.getScreenCTM() : null;
    const [top, bottom] = matrix && (matrix.b || matrix.c) ? [0, 1] : inkOf(t.string, t.style);
    const range = document.createRange();
    range.selectNodeContents(t.node);
    return Array.from(range.getClientRects()).filter((r) => r.width > 0).map((r) => ({
      left: r.left, right: r.right, top: r.top + top * r.height, bottom: r.top + bottom * r.height,
    }));
  };
  const isForReadersOnly = (e) => { // cut off on purpose, for screen readers
    const b = e.getBoundingClientRect();
    return !isSvg(e) && style(e).overflow === 'hidden' && b.width <= 1 && b.height <= 1;
  };
  const texts = [];
  const walker = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const node = walker.currentNode;
    const element = node.parentElement;
    if (node.data.trim() && !element.closest(NO_TEXT) && !isForReadersOnly(element) &&
      element.checkVisibility({checkOpacity: true, checkVisibilityCSS: true})) {
      const t = {node, element, style: style(element), string: node.data};
      t.boxes = boxesOf(t);
      texts.push(t);
    }
  }
  found.words = texts.map((t) => t.string).join(' ');

  // ---- nothing cut off ----
  if (root.scrollWidth > root.clientWidth) {
    found.cut.push(`the page is ${root.scrollWidth} px wide, the window ${root.clientWidth}`);
  }
  for (const t of texts) {
    const reason = t.boxes.map((b) => cutBy(t.element, b)).find((r) => r);
    if (reason) {
      found.cut.push(`${quote(t.string)}: ${reason}`);
      t.isCut = true;
    }
  }
  for (const t of texts.filter((t) => t.boxes.length > 1)) {
    for (const m of t.string.matchAll(/(?<![\w.])[-+±−]?\d+(\.\d+)?(?![\w.])/g)) {
      const range = document.createRange();
      range.setStart(t.node, m.index);
      range.setEnd(t.node, m.index + m[0].length);
      if (new Set(Array.from(range.getClientRects(), (r) => r.top)).size > 1) {
        found.cut.push(`the number ${m[0]}: broken over two lines`);
      }
    }
  }
  const drawn = Array.from(document.querySelectorAll(SHAPES)).filter((e) =>
    !e.closest(NOT_DRAWN) && e.checkVisibility({checkOpacity: true, checkVisibilityCSS: true}));
  for (const e of drawn) {
    const reason = e.closest('[clip-path]') || cutBy(e, e.getBoundingClientRect());
    if (typeof reason === 'string') {
      found.cut.push(`${describe(e)}: ${reason}`);
    }
  }
  for (const e of document.body ? document.body.querySelectorAll('*') : []) {
    if (e.getBoundingClientRect().right > root.clientWidth + TOLERANCE && !scroller(e) &&
      !isSvg(e) && e.checkVisibility()) {
      found.cut.push(`${describe(e)}: beyond the right edge`);
    }
  }

  // ---- no overlap ----
  const runs = texts.flatMap((t) => t.boxes.map((b) => ({b, t})));
  runs.sort((p, q) => p.b.top - q.b.top);
  runs.forEach((p, i) => {
    for (let k = i + 1; k < runs.length && runs[k].b.top < p.b.bottom; k++) {
      const q = runs[k];
      const wide = Math.min(p.b.right, q.b.right) - Math.max(p.b.left, q.b.left);
      const high = Math.min(p.b.bottom, q.b.bottom) - q.b.top;
      const least = Math.min(p.b.bottom - p.b.top, q.b.bottom - q.b.top);
      if (Math.min(wide, high) > Math.max(TOLERANCE, 0.05 * least)) {
        found.overlap.push(`${quote(p.t.string)} and ${quote(q.t.string)}: ` +
          `${number(wide)} x ${number(high)} px`);
      }
    }
  });

  // ---- size ----
  const sizeOf = (t) => {
    const m = isSvg(t.element) ? t.element.getScreenCTM() : {a: 1, b: 0, c: 0, d: 1};
    return parseFloat(t.style.fontSize) * Math.sqrt(Math.abs(m.a * m.d - m.b * m.c));
  };
  for (const t of texts) {
    const size = sizeOf(t);
    if (found.smallest === null || size < found.smallest) {
      found.smallest = size;
    }
    if (size < view.font - 0.005) {
      found.small.push(`${quote(t.string)}: ${number(size)} px`);
    }
  }

  // ---- contrast of text ----
  // WCAG 2.2, 1.4.3: large letters need less.
  const needed = (size, weight) => size >= 24 || (size >= 18.66 && weight >= 700) ? 3 : 4.5;
  // A few points of a text; if marks are near, each pixel along its middle, in both directions, so
  // that no line runs through it unnoticed.
  const pointsIn = (b, t) => {
    marks ||= drawn.filter((e) => !e.matches(DECORATIVE)).map((e) => e.getBoundingClientRect());
    const near = isSvg(t.element) && marks.some((m) =>
      m.left < b.right && m.right > b.left && m.top < b.bottom && m.bottom > b.top);
    const steps = (n, from, to) =>
      Array.from({length: n}, (_, k) => from + (k + 0.5) / n * (to - from));
    const row = steps(near ? Math.ceil(b.right - b.left) : 3, b.left, b.right);
    const column = steps(near ? Math.ceil(b.bottom - b.top) : 1, b.top, b.bottom);
    return [...row.map((x) => [x, (b.top + b.bottom) / 2]),
      ...column.map((y) => [(b.left + b.right) / 2, y])];
  };
  const lookAt = (t) => {
    const s = t.style;
    const fore = isSvg(t.element) ? paint(t.element, 'fill')
      : [colour(s.color).slice(0, 3).concat(colour(s.color)[3] * opacity(t.element))];
    const isHaloed = isSvg(t.element) && s.paintOrder.startsWith('stroke');
    const halo = isHaloed ? paint(t.element, 'stroke') : [];
    const area = scroller(t.element);
    let boxes = boxesOf(t); // the area may have been scrolled since
    let least = null;
    for (let i = 0; i < boxes.length; i++) {
      showIn(area, boxes[i]);
      boxes = area ? boxesOf(t) : boxes;
      const b = boxes[i];
      for (const [x, y] of pointsIn(b, t)) {
        const stack = document.elementsFromPoint(x, y);
        const at = stack.findIndex((e) => e === t.element || t.element.contains(e));
        if (at < 0) {
          continue; // between the letters, or scrolled away
        }
        const hidden = stack.slice(0, at).find((e) => painted(e, x, y).some((c) => c[3] > 0.5));
        if (hidden) {
          return `${quote(t.string)}: covered by ${describe(hidden)}`;
        }
        const picture = stack.slice(at).find(hasPicture);
        if (picture) {
          return `${quote(t.string)}: a background picture lies behind it`;
        }
        const behind = blend([halo, ...stack.slice(at).map((e) => painted(e, x, y))]);
        const sheet = stack.filter((e) => e.matches('.paper') || !isShape(e));
        const dark = blend(sheet.map((e) => painted(e, x, y))).find((c) => luminance(c) < 0.7);
        if (dark) {
          found.paper.push(`${quote(t.string)} on ${hex(dark)}`);
        }
        for (const back of behind) {
          for (const f of fore) {
            const c = contrast(over(f, back), back);
            least = least === null || c < least.c ? {c, f: over(f, back), back} : least;
          }
        }
      }
    }
    return least === null ? `${quote(t.string)}: not to be seen`
      : least.c < needed(sizeOf(t), Number(s.fontWeight))
        ? `${quote(t.string)}: ${hex(least.f)} on ${hex(least.back)}, ${number(least.c)}:1` : null;
  };
  for (const t of texts) {
    const fault = t.boxes.length && !t.isCut ? lookAt(t) : null;
    if (fault) {
      found.text.push(fault);
    }
  }

  // ---- contrast of marks, colours in use ----
  // A mark stands out if its fill or its stroke does, from the paper or shade behind it, or one from
  // the other; marks below it do not count as background.
  const kindOf = (e) => {
    const s = style(e);
    if (e.matches('line,polyline') || (e.matches('path') && s.fill === 'none')) {
      return 'line ' + s.strokeDasharray;
    }
    return e.tagName + (e.points ? e.points.length : '') +
      (e.matches('path') ? e.getAttribute('d').replace(/[^A-Za-z]/g, '').slice(0, 20) : '');
  };
  const seen = new Map();
  for (const e of drawn) {
    const size = e.getBoundingClientRect();
    if (e.closest(DECORATIVE) || Math.max(size.width, size.height) < 0.5) {
      continue;
    }
    const picture = e.ownerSVGElement;
    const kind = [e.tagName, e.getAttribute('class'), e.getAttribute('style'),
      style(e).fill, style(e).stroke].join();
    if (!seen.has(picture)) {
      seen.set(picture, {count: new Map(), colours: {}});
    }
    const here = seen.get(picture);
    const count = here.count.get(kind) || 0;
    here.count.set(kind, count + 1);
    if (count >= SAMPLES) {
      continue;
    }
    showIn(scroller(e), size);
    const at = e.getPointAtLength(e.getTotalLength() / 2).matrixTransform(e.getScreenCTM());
    const below = document.elementsFromPoint(at.x, at.y).filter((b) =>
      b.matches('.paper,.shade,.area') || !isSvg(b) || b.tagName === 'svg');
    let best = {c: 0};
    for (const back of blend(below.map((b) => painted(b, at.x, at.y)))) {
      const rate = (which) => paint(e, which).map((c) => over(c, back))
        .map((c) => ({c: contrast(c, back), f: c, back})).sort((p, q) => p.c - q.c)[0] || {c: 0};
      const [fill, stroke] = [rate('fill'), rate('stroke')];
      const b = {...(fill.c > stroke.c ? fill : stroke)};
      if (fill.f && stroke.f && parseFloat(style(e).strokeWidth) >= 1) {
        b.c = Math.max(b.c, contrast(fill.f, stroke.f));
      }
      best = !best.c || b.c < best.c ? b : best;
    }
    if (best.c < 3) {
      found.marks.push(best.f ? `${describe(e)}: ${hex(best.f)} on ${hex(best.back)}, ` +
        `${number(best.c)}:1` : `${describe(e)}: not to be seen`);
    } else if (!e.closest('.rule,.ink,.soft')) {
      (here.colours[hex(best.f)] ||= new Set()).add(kindOf(e));
    }
  }
  found.colours = Array.from(seen.values(), (p) =>
    Object.entries(p.colours).map(([c, kinds]) => [c, [...kinds]]));
  document.querySelectorAll('*').forEach((e) => { e.scrollLeft = 0; });
  for (const key of ['cut', 'overlap', 'text', 'marks', 'small', 'paper']) {
    found[key] = [...new Set(found[key])];
  }
  return found;
}
