// A sweep: the chosen quantity over one axis as curves with error bars, over two as a map, and the chosen case in
// words.
const CURVES = ["s0", "s1", "s2", "s3", "s4", "s5"], MARKS = ["\u25cf", "\u25a0", "\u25b2", "\u25c6", "\u25cb", "\u25a1"];
const escaped = (text) => String(text).replace(/[&<>"]/g, (letter) => `&#${letter.charCodeAt(0)};`);

async function readSweep(about) {
  const values = new Float32Array((await unpack(about.values)).buffer), errors = new Float32Array((await unpack(about.errors)).buffer);
  return { ...about, values, errors, cases: about.axes.reduce((product, axis) => product * axis.values.length, 1) };
}

function sweepOf(sweep) {
  const { axes, quantities, cases } = sweep, by = (id) => document.getElementById(id), many = axes.map((axis, k) => k).filter((k) => axes[k].values.length > 1);
  const numeric = many.filter((k) => axes[k].is_numeric), chosen = axes.map(() => 0), curves = by("curves"), cells = by("cells");
  const state = { quantity: 0, along: numeric.length ? numeric[numeric.length - 1] : many[many.length - 1] || 0, across: -1 };
  state.across = [...many].reverse().find((k) => k !== state.along) ?? -1;
  const placeOf = (indices) => indices.reduce((place, index, k) => place * axes[k].values.length + index, 0);
  const at = (changes) => { const indices = [...chosen]; for (const [k, index] of changes) indices[k] = index; return placeOf(indices); };
  const value = (place) => sweep.values[state.quantity * cases + place] / quantities[state.quantity].size;
  const error = (place) => sweep.errors[state.quantity * cases + place] / quantities[state.quantity].size;
  const word = (k, index) => { const it = axes[k].values[index]; return typeof it === "number" ? written(it, 5) : escaped(it); };
  const unitOf = (unit) => (unit ? "\u00a0" + escaped(unit) : ""), labelOf = ({ label, unit }) => escaped(label) + (unit ? ", " + escaped(unit) : "");

  // Room at the left of the map: that of the longest word of a category.
  const leftOf = () => (state.across < 0 ? 66 : Math.min(220, Math.max(66, 34 + 7.2 * Math.max(...axes[state.across].values.map((it, k) => word(state.across, k).length)))));

  function choices(id, list, selected, change) {
    const select = by(id);
    select.innerHTML = list.map(([key, text]) => `<option value="${key}"${key === selected ? " selected" : ""}>${text}</option>`).join("");
    select.onchange = () => { change(+select.value); draw(); };
  }
  function controls() {
    const named = (list) => list.map((k) => [k, escaped(axes[k].label)]);
    choices("quantity", quantities.map((it, k) => [k, escaped(it.label)]), state.quantity, (k) => { state.quantity = k; });
    choices("axis-along", named(many), state.along, (k) => { if (state.across === k) state.across = state.along; state.along = k; });
    choices("axis-across", [[-1, "none"], ...named(many.filter((k) => k !== state.along))], state.across, (k) => { state.across = k; });
    const others = many.filter((k) => k !== state.along && k !== state.across);
    by("fixed").innerHTML = others.map((k) => `<label>${escaped(axes[k].label)} <select id="fixed-${k}"></select></label>`).join("");
    for (const k of others) choices(`fixed-${k}`, axes[k].values.map((it, index) => [index, word(k, index) + unitOf(axes[k].unit)]), chosen[k], (index) => { chosen[k] = index; });
  }
  // Where the values of an axis are, between 0 and 1, and its marks.
  function scaleOf(axis) {
    const list = axis.values, words = list.map((it, k) => word(axes.indexOf(axis), k));
    const every = Math.ceil((list.length * (1 + Math.max(...words.map((text) => text.length))) * 7.2) / 418);
    if (!axis.is_numeric) return { of: list.map((it, k) => (k + 0.5) / list.length), marks: words.map((text, k) => [(k + 0.5) / list.length, text]).filter((mark, k) => k % every === 0) };
    const low = Math.min(...list), high = Math.max(...list), isLog = low > 0 && high / low > 50, place = isLog ? (v) => Math.log(v / low) / Math.log(high / low) : (v) => (v - low) / (high - low);
    return { of: list.map(place), marks: isLog ? list.filter((v, k) => k % Math.ceil(list.length / 6) === 0).map((v) => [place(v), written(v, 3)]) : roundNumbers(low, high, 6).map((v) => [place(v), written(v, 4)]) };
  }
  function drawCurves() {
    const axis = axes[state.along], scale = scaleOf(axis), w = 520, h = 330, l = 66, r = 16, t = 12, b = 48, out = [], isLog = by("logarithmic").checked;
    const count = state.across < 0 ? 1 : axes[state.across].values.length, shown = Math.min(count, CURVES.length);
    let family = Array.from({ length: shown }, (it, k) => (shown > 1 ? Math.round((k * (count - 1)) / (shown - 1)) : 0));
    if (state.across >= 0 && !family.includes(chosen[state.across])) family = family.map((index, k) => (k === Math.round((chosen[state.across] * (shown - 1)) / (count - 1)) ? chosen[state.across] : index));
    const lines = family.map((index) => axis.values.map((it, k) => { const place = at([[state.along, k], ...(state.across < 0 ? [] : [[state.across, index]])]); return [value(place), error(place)]; }));
    const isShown = ([v]) => Number.isFinite(v) && (!isLog || v > 0), all = lines.flat().filter(isShown);
    let low = Math.min(...all.map(([v, e]) => (isLog || !(e > 0) ? v : v - e))), high = Math.max(...all.map(([v, e]) => (e > 0 ? v + e : v)));
    if (!isLog && low > 0 && low < 0.5 * high) low = 0;
    if (!(high > low)) { low -= Math.abs(low) * 0.05 || 1; high += Math.abs(high) * 0.05 || 1; }
    const room = isLog ? 1 : (high - low) * 0.04;
    if (!isLog) { if (low !== 0) low -= room; high += room; }
    const X = (s) => l + 10 + s * (w - l - r - 20), share = isLog ? (v) => Math.log(v / low) / Math.log(high / low) : (v) => (v - low) / (high - low), Y = (v) => h - b - Math.min(1, Math.max(0, share(v))) * (h - t - b);
    if (!all.length) out.push(svgText(w / 2, h / 2, "no film in any of these cases"));
    const decades = []; for (let k = Math.ceil(Math.log10(low)); isLog && k <= Math.log10(high); k++) decades.push(10 ** k);
    const marks = !all.length ? [] : isLog ? (decades.length > 1 ? decades : [low, high]) : roundNumbers(low, high, 5);
    for (const v of marks) out.push(svgLine(l, Y(v), w - r, Y(v), "grid"), svgText(l - 6, Y(v) + 4, written(v, 4), "te"));
    for (const [s, text] of scale.marks) out.push(svgLine(X(s), h - b, X(s), h - b + 4, "tick"), svgText(X(s), h - b + 17, text));
    const X0 = X(scale.of[chosen[state.along]]);
    out.push(svgLine(X0, t, X0, h - b, "cursor"));
    lines.forEach((line, n) => {
      const kind = CURVES[n];
      let path = "", pen = "M";
      line.forEach((point, k) => {
        if (!isShown(point)) { pen = "M"; return; }
        const [v, e] = point, x = X(scale.of[k]), y = Y(v);
        path += `${pen}${x.toFixed(1)} ${y.toFixed(1)}`; pen = "L";
        if (e > 0) { const a = Y(v + e), c = Y(isLog ? Math.max(low, v - e) : v - e); if (c - a > 1.5) out.push(svgLine(x, a, x, c, "bar " + kind), svgLine(x - 3, a, x + 3, a, "bar " + kind), svgLine(x - 3, c, x + 3, c, "bar " + kind)); }
        out.push(`<text class="mark ${kind}" x="${x.toFixed(1)}" y="${(y + 3.4).toFixed(1)}">${MARKS[n]}</text>`);
      });
      out.push(`<path class="curve ${axis.is_numeric ? kind : "none"}" d="${path}"/>`);
    });
    out.push(`<rect class="frame" x="${l}" y="${t}" width="${w - l - r}" height="${h - t - b}"/>`, svgText(l + (w - l - r) / 2, h - 8, labelOf(axis)), upright(14, t + (h - t - b) / 2, labelOf(quantities[state.quantity])));
    curves.innerHTML = out.join("");
    by("legend").innerHTML = state.across < 0 ? "" : `${escaped(axes[state.across].label)}: ` + family.map((index, n) => `<span class="k0"><span class="${CURVES[n]}" aria-hidden="true">${MARKS[n]}</span> ${word(state.across, index)}${unitOf(axes[state.across].unit)}</span>`).join("") + (shown < count ? `<span>(${shown} of ${count})</span>` : "");
  }
  function drawCells() {
    const hasMap = state.across >= 0;
    cells.toggleAttribute("hidden", !hasMap);
    if (!hasMap) return;
    const x = axes[state.along], y = axes[state.across], w = 520, h = 330, l = leftOf(), r = 74, t = 12, b = 48, out = [], columns = x.values.length, rows = y.values.length;
    const known = []; for (let k = 0; k < cases; k++) if (Number.isFinite(value(k))) known.push(value(k));
    let low = Math.min(...known), high = Math.max(...known);
    const isDiverging = low < 0 && high > 0, table = colourTable(isDiverging ? sweep.diverging : sweep.sequential);
    if (isDiverging) { high = Math.max(high, -low); low = -high; }
    if (!(high > low)) { high = low + (Math.abs(low) || 1); }
    const dx = (w - l - r) / columns, dy = (h - t - b) / rows, shade = (s) => 3 * Math.round(1023 * Math.min(1, Math.max(0, s))), colour = (i) => `rgb(${table[i]},${table[i + 1]},${table[i + 2]})`;
    for (let j = 0; j < rows; j++) for (let k = 0; k < columns; k++) {
      const v = value(at([[state.along, k], [state.across, j]])), X = l + k * dx, Y = h - b - (j + 1) * dy, isFilm = Number.isFinite(v), i = shade((v - low) / (high - low)), text = isFilm ? written(v, 3) : "\u2013";
      out.push(`<rect class="${isFilm ? "cell" : "cell empty"}" x="${X.toFixed(1)}" y="${Y.toFixed(1)}" width="${(dx - 1).toFixed(1)}" height="${(dy - 1).toFixed(1)}"${isFilm ? ` fill="${colour(i)}"` : ""}/>`);
      if (dx > 7 * text.length && dy > 13) out.push(`<text class="word ${isFilm && 0.3 * table[i] + 0.59 * table[i + 1] + 0.11 * table[i + 2] < 140 ? "pale" : ""}" x="${(X + dx / 2).toFixed(1)}" y="${(Y + dy / 2 + 4).toFixed(1)}">${text}</text>`);
    }
    const every = (count, size, words) => Math.max(1, Math.ceil((words * 7) / size));
    const wide = every(columns, dx, Math.max(...x.values.map((it, k) => word(state.along, k).length)) + 1), tall = Math.max(1, Math.ceil(14 / dy));
    for (let k = 0; k < columns; k += wide) out.push(svgText(l + (k + 0.5) * dx, h - b + 17, word(state.along, k)));
    for (let j = 0; j < rows; j += tall) out.push(svgText(l - 6, h - b - (j + 0.5) * dy + 4, word(state.across, j), "te"));
    out.push(svgText(l + (w - l - r) / 2, h - 8, labelOf(x)), upright(14, t + (h - t - b) / 2, labelOf(y)));
    const bar = w - r + 14, parts = 40, height = h - t - b;
    for (let k = 0; k < parts; k++) out.push(`<rect x="${bar}" y="${(t + height - ((k + 1) * height) / parts).toFixed(2)}" width="12" height="${(height / parts + 0.6).toFixed(2)}" fill="${colour(shade(k / (parts - 1)))}"/>`);
    for (const v of roundNumbers(low, high, 5)) { const Y = t + height * (1 - (v - low) / (high - low)); out.push(svgLine(bar + 12, Y, bar + 16, Y, "tick"), svgText(bar + 19, Y + 4, written(v, 3), "ts")); }
    out.push(`<rect class="frame" x="${bar}" y="${t}" width="12" height="${height}"/><rect class="chosen" x="${(l + chosen[state.along] * dx - 0.5).toFixed(1)}" y="${(h - b - (chosen[state.across] + 1) * dy - 0.5).toFixed(1)}" width="${dx.toFixed(1)}" height="${dy.toFixed(1)}"/>`);
    cells.innerHTML = out.join("");
  }
  function tell() {
    const place = placeOf(chosen), { label, unit } = quantities[state.quantity], v = value(place), e = error(place), plain = unit ? "\u00a0" + unit : "";
    const where = many.map((k) => `${axes[k].label} ${typeof axes[k].values[chosen[k]] === "number" ? written(axes[k].values[chosen[k]], 5) : axes[k].values[chosen[k]]}${axes[k].unit ? "\u00a0" + axes[k].unit : ""}`).join(", ");
    const found = Number.isFinite(v) ? `${label} ${written(v, 5)}${e > 0 ? ` \u00b1 ${written(e, 2)}` : ""}${plain}` : "no value";
    by("readout").textContent = `Case ${place + 1}, ${where}: ${found}; ${sweep.remarks[place] || "not computed"}`;
  }
  function draw() { controls(); drawCurves(); drawCells(); tell(); }
  function choose(changes) {
    for (const [k, index] of changes) if (k >= 0) chosen[k] = Math.max(0, Math.min(axes[k].values.length - 1, index));
    drawCurves(); drawCells(); tell();
  }
  for (const box of [curves, cells]) {
    box.addEventListener("keydown", (event) => {
      const [along, across] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] || [];
      if (along === undefined) return;
      choose([[state.along, chosen[state.along] + along], [state.across, state.across < 0 ? 0 : chosen[state.across] + across]]);
      event.preventDefault();
    });
    box.addEventListener("pointerdown", (event) => {
      const size = box.getBoundingClientRect(), x = ((event.clientX - size.left) / size.width) * 520, y = ((event.clientY - size.top) / size.height) * 330, isMap = box === cells;
      const left = leftOf();
      if (isMap) return choose([[state.along, Math.floor(((x - left) / (446 - left)) * axes[state.along].values.length)], [state.across, Math.floor(((282 - y) / 270) * axes[state.across].values.length)]]);
      const of = scaleOf(axes[state.along]).of.map((s) => Math.abs(76 + s * 418 - x));
      choose([[state.along, of.indexOf(Math.min(...of))]]);
    });
  }
  by("logarithmic").addEventListener("change", draw);
  draw();
}
