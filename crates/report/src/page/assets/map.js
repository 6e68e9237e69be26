// The unrolled liner and the profiles through its cursor.
const millimetres = (z) => Math.round(z * 1e6) / 1e3;
const svgLine = (a, b, c, d, kind) => `<line class="${kind}" x1="${a.toFixed(1)}" y1="${b.toFixed(1)}" x2="${c.toFixed(1)}" y2="${d.toFixed(1)}"/>`;
const svgText = (x, y, text, kind = "") => `<text class="tl ${kind}" x="${x.toFixed(1)}" y="${y.toFixed(1)}">${text}</text>`;
const nameOf = (field) => `<tspan class="sy">${field.symbol}</tspan>${field.unit ? ", " + field.unit : ""}`;
const upright = (x, y, text) => `<text class="tl" transform="translate(${x} ${y.toFixed(1)}) rotate(-90)">${text}</text>`;

// Every dot is the value of the field itself, lines of equal value follow its gradient.
function paintMap(film, field, options, picture, dots) {
  const { width: W, height: H, data } = picture, { triangles, x, z, curved, table = field.table } = film;
  const sx = W / film.width, sz = H / (film.top - film.bottom), [low, high] = field.colours, v = field.values;
  const isConstant = field.interpolation === "constant", scale = field.is_logarithmic ? 1 / Math.log(high / low) : 1 / (high - low);
  const levels = field.is_logarithmic ? [] : marksOf(field, 10), step = options.lines && levels.length > 1 && !isConstant ? levels[1] - levels[0] : 0, half = 0.45 * dots;
  const P = new Float64Array(12), whole = 2 * Math.PI, floor = field.floor ?? -Infinity;

  // Dots of a straight triangle with corners a, b, c whose values are the quadratic of q.
  function straight(p, q, sides) {
    const [Ax, Ay, Bx, By, Cx, Cy] = p, det = (Bx - Ax) * (Cy - Ay) - (By - Ay) * (Cx - Ax);
    if (!det) return;
    const bdx = (Cy - Ay) / det, bdy = -(Cx - Ax) / det, cdx = -(By - Ay) / det, cdy = (Bx - Ax) / det, [v0, v1, v2, v3, v4, v5] = q;
    const la = 1 / Math.hypot(bdx + cdx, bdy + cdy), lb = 1 / Math.hypot(bdx, bdy), lc = 1 / Math.hypot(cdx, cdy);
    const i0 = Math.max(0, Math.floor(Math.min(Ax, Bx, Cx) - 0.5)), i1 = Math.min(W - 1, Math.ceil(Math.max(Ax, Bx, Cx) + 0.5));
    const j0 = Math.max(0, Math.floor(Math.min(Ay, By, Cy) - 0.5)), j1 = Math.min(H - 1, Math.ceil(Math.max(Ay, By, Cy) + 0.5));
    for (let j = j0; j <= j1; j++) for (let i = i0; i <= i1; i++) {
      const px = i + 0.5 - Ax, py = j + 0.5 - Ay, b = px * bdx + py * bdy, c = px * cdx + py * cdy, a = 1 - b - c;
      if (a < -1e-9 || b < -1e-9 || c < -1e-9) continue;
      const value = Math.max(floor, v0 * a * (2 * a - 1) + v1 * b * (2 * b - 1) + v2 * c * (2 * c - 1) + 4 * (v3 * a * b + v4 * b * c + v5 * c * a));
      let shade = 1;
      if (step) {
        const ga = v0 * (4 * a - 1) + 4 * (v3 * b + v5 * c), gb = v1 * (4 * b - 1) + 4 * (v3 * a + v4 * c), gc = v2 * (4 * c - 1) + 4 * (v4 * b + v5 * a);
        shade = lineShade(value, Math.hypot((gb - ga) * bdx + (gc - ga) * cdx, (gb - ga) * bdy + (gc - ga) * cdy));
      }
      dot(i, j, value, shade, sides ? Math.min(a * la, b * lb, c * lc) : 9);
    }
  }
  // Dots of a triangle with curved sides: shares by Newton's method.
  function bent(t, shift) {
    let a = Infinity, b = -Infinity, c = Infinity, d = -Infinity;
    for (let i = 0; i < 6; i++) { a = Math.min(a, P[2 * i]); b = Math.max(b, P[2 * i]); c = Math.min(c, P[2 * i + 1]); d = Math.max(d, P[2 * i + 1]); }
    const wide = b - a + d - c;
    for (let j = Math.max(0, Math.floor(c - 1)); j <= Math.min(H - 1, Math.ceil(d + 1)); j++) for (let i = Math.max(0, Math.floor(a - 1)); i <= Math.min(W - 1, Math.ceil(b + 1)); i++) {
      const place = sharesOf(film, t, (i + 0.5) / sx - shift, film.top - (j + 0.5) / sz), least = Math.min(...place);
      if (least < -1e-9) continue;
      const value = valueAt(film, field, [t, ...place]);
      dot(i, j, value, 1, options.mesh ? least * wide / 2 : 9);
    }
  }
  const lineShade = (value, slope) => {
    const level = Math.round(value / step) * step;
    if (level <= low + 1e-6 * step || level >= high - 1e-6 * step || !(slope > 1e-6 * step)) return 1;
    const away = Math.abs(value - level) / slope;
    return away < half + 0.5 ? 1 - 0.55 * Math.min(1, half + 0.5 - away) : 1;
  };
  function dot(i, j, value, shade, away) {
    let s = field.is_logarithmic ? (value > low ? Math.log(value / low) * scale : 0) : (value - low) * scale;
    s = s > 1 ? 1 : s > 0 ? s : 0;
    if (away < 0.6) shade *= 1 - 0.35 * (1 - away / 0.6);
    const k = 3 * ((s * 1023) | 0), o = 4 * (j * W + i), dark = table[k] + table[k + 1] + table[k + 2] < 300, light = dark ? 200 * (1 - shade) : 0;
    data[o] = table[k] * shade + light; data[o + 1] = table[k + 1] * shade + light; data[o + 2] = table[k + 2] * shade + light; data[o + 3] = 255;
  }
  for (let t = 0; t < film.cells; t++) {
    let left = Infinity, right = -Infinity;
    for (let i = 6 * t; i < 6 * t + 6; i++) { left = Math.min(left, x[i]); right = Math.max(right, x[i]); }
    for (let shift = left < 0 ? whole : right > whole ? -whole : 0, pass = shift ? 2 : 1; pass > 0; pass--) {
      const by = pass === 2 ? shift : 0;
      for (let i = 0; i < 6; i++) { P[2 * i] = (x[6 * t + i] + by) * sx; P[2 * i + 1] = (film.top - z[6 * t + i]) * sz; }
      const q = [0, 1, 2, 3, 4, 5].map((i) => (isConstant ? v[t] : v[triangles[6 * t + i]]));
      if (curved[t]) bent(t, by);
      else if (field.interpolation !== "linear") straight(P, q, options.mesh);
      else for (const [a, b, c] of PARTS) straight([P[2 * a], P[2 * a + 1], P[2 * b], P[2 * b + 1], P[2 * c], P[2 * c + 1]], [q[a], q[b], q[c], (q[a] + q[b]) / 2, (q[b] + q[c]) / 2, (q[c] + q[a]) / 2], options.mesh);
    }
  }
}

function mapOf(film, state) {
  const box = document.getElementById("map"), canvas = document.getElementById("field"), axes = document.getElementById("axes"), readout = document.getElementById("readout");
  const whole = 2 * Math.PI;
  let frame = null;
  const within = (value, low, high) => Math.min(high, Math.max(low, value));
  const at = (x, z) => [frame.left + (x / film.width) * frame.width, frame.top + ((film.top - z) / (film.top - film.bottom)) * frame.height];
  function draw() {
    const dots = Math.min(2, window.devicePixelRatio || 1), room = box.clientWidth, left = 52, right = room < 500 ? 66 : 84, top = 10, bottom = 44;
    let width = room - left - right, height = (width * (film.top - film.bottom)) / (film.width * film.radius);
    // Both directions to scale: a long bearing is drawn narrower.
    if (height > 460) { width *= 460 / height; height = 460; }
    width = Math.max(width, 40); height = Math.max(height, 24);
    frame = { left, top, width, height };
    Object.assign(canvas.style, { left: left + "px", top: top + "px", width: width + "px", height: height + "px" });
    box.style.height = height + top + bottom + "px";
    canvas.width = Math.round(width * dots); canvas.height = Math.round(height * dots);
    const picture = new ImageData(canvas.width, canvas.height);
    paintMap(film, state.field, { lines: document.getElementById("lines").checked, mesh: document.getElementById("mesh").checked }, picture, dots);
    canvas.getContext("2d").putImageData(picture, 0, 0);
    drawAxes(); drawCursor();
  }
  // A line, of a ring also where it crosses the cut.
  function lineOf({ kind, paths }) {
    let d = "";
    for (const path of paths) {
      const start = (((path[0] - film.origin) % whole) + whole) % whole;
      for (const shift of [-whole, 0, whole]) {
        let pen = "M";
        for (let k = 0; k + 3 < path.length; k += 2) {
          const a = start + path[k] - path[0] + shift, b = start + path[k + 2] - path[0] + shift;
          if (Math.max(a, b) < 0 || Math.min(a, b) > film.width) { pen = "M"; continue; }
          const [x0, y0] = at(within(a, 0, film.width), path[k + 1]), [x1, y1] = at(within(b, 0, film.width), path[k + 3]);
          d += (pen === "M" ? `M${x0.toFixed(1)} ${y0.toFixed(1)}` : "") + `L${x1.toFixed(1)} ${y1.toFixed(1)}`;
          pen = "L";
        }
      }
    }
    return kind === "rim" ? `<path class="rim" d="${d}"/>` : `<path class="halo" d="${d}"/><path class="${kind}" d="${d}"/>`;
  }
  function drawAxes() {
    const { left, top, width, height } = frame, field = state.field, out = film.lines.map(lineOf), foot = top + height;
    out.push(`<rect class="frame" x="${left}" y="${top}" width="${width.toFixed(1)}" height="${height.toFixed(1)}"/>`);
    const first = film.origin / DEGREE, last = first + film.width / DEGREE, by = [15, 30, 45, 60, 90, 120, 180].find((step) => ((last - first) / step) * 42 < width) || 360;
    for (let a = Math.ceil(first / by - 1e-9) * by; a <= last + 1e-6; a += by) { const [x] = at((a - first) * DEGREE, 0); out.push(svgLine(x, foot, x, foot + 5, "tick"), svgText(x, foot + 18, ((Math.round(a) % 360) + 360) % 360 + "\u00b0")); }
    out.push(svgText(left + width / 2, foot + 36, "angle on the liner"));
    for (const mm of roundNumbers(film.bottom * 1e3, film.top * 1e3, Math.max(1, Math.min(4, height / 28)))) { const [, y] = at(0, mm / 1e3); out.push(svgLine(left - 5, y, left, y, "tick"), svgText(left - 8, y + 4, written(mm), "te")); }
    out.push(upright(13, top + height / 2, '<tspan class="sy">z</tspan>, mm'));
    const bar = left + width + 14, parts = 48, tall = Math.max(height, 90);
    for (let k = 0; k < parts; k++) { const i = 3 * Math.round((1023 * k) / (parts - 1)), c = field.table; out.push(`<rect x="${bar.toFixed(1)}" y="${(top + tall - ((k + 1) * tall) / parts).toFixed(2)}" width="12" height="${(tall / parts + 0.6).toFixed(2)}" fill="rgb(${c[i]},${c[i + 1]},${c[i + 2]})"/>`); }
    out.push(`<rect class="frame" x="${bar.toFixed(1)}" y="${top}" width="12" height="${tall.toFixed(1)}"/>`);
    for (const value of marksOf(field, 5)) { const y = top + tall * (1 - shareOf(field, value)); out.push(svgLine(bar + 12, y, bar + 16, y, "tick"), svgText(bar + 19, y + 4, written(value / field.size, field.is_logarithmic ? 1 : 3), "ts")); }
    out.push(svgText(bar, Math.max(foot, top + tall) + 36, nameOf(field), "ts"), '<g id="cursor"></g>');
    if (tall > height) box.style.height = tall + top + 44 + "px";
    axes.innerHTML = out.join("");
  }
  function drawCursor() {
    const [x, z] = state.cursor, [cx, cy] = at(x, z), { left, top, width, height } = frame;
    document.getElementById("cursor").innerHTML = svgLine(cx, top, cx, top + height, "cursor") + svgLine(left, cy, left + width, cy, "cursor") + `<circle class="cursor" cx="${cx.toFixed(1)}" cy="${cy.toFixed(1)}" r="5"/>`;
    const place = film.locate(x, z), here = `${written(degreesOf(film, x), 4)}\u00b0, z = ${written(millimetres(z))} mm`;
    readout.textContent = `At ${here}: ` + (place ? film.fields.map((field) => `${field.label} ${written(valueAt(film, field, place) / field.size)}${field.unit ? "\u00a0" + field.unit : ""}`).join(", ") : "no film (hole, groove or gap)");
    const count = 360, around = [], along = [], xs = [], zs = [];
    for (let k = 0; k <= count; k++) {
      xs.push((film.width * k) / count); zs.push(film.bottom + ((film.top - film.bottom) * k) / count);
      around.push(valueAt(film, state.field, film.locate(xs[k], z))); along.push(valueAt(film, state.field, film.locate(x, zs[k])));
    }
    const first = film.origin / DEGREE, last = first + film.width / DEGREE, marks = [];
    for (let a = Math.ceil(first / 60) * 60; a <= last; a += 60) marks.push(a);
    curve("around", xs.map((v) => first + v / DEGREE), around, [first, last], `around, at z = ${written(millimetres(z))} mm`, marks, first + x / DEGREE, (a) => ((Math.round(a) % 360) + 360) % 360 + "\u00b0");
    curve("along", zs.map((v) => v * 1e3), along, [film.bottom * 1e3, film.top * 1e3], `along the axis, mm, at ${written(degreesOf(film, x))}\u00b0`, roundNumbers(film.bottom * 1e3, film.top * 1e3, 5), z * 1e3, (v) => written(v));
  }
  function curve(id, xs, ys, [low, high], title, marks, cursor, format) {
    const field = state.field, w = 520, h = 210, l = 62, r = 14, t = 12, b = 42, out = [];
    const X = (x) => l + ((x - low) / (high - low)) * (w - l - r), Y = (value) => h - b - Math.min(1, Math.max(0, shareOf(field, value))) * (h - t - b);
    for (const value of marksOf(field, 4)) out.push(svgLine(l, Y(value), w - r, Y(value), "grid"), svgText(l - 6, Y(value) + 4, written(value / field.size, field.is_logarithmic ? 1 : 3), "te"));
    for (const x of marks) out.push(svgText(X(x), h - b + 17, format(x)));
    let path = "", pen = "M";
    xs.forEach((x, k) => { if (ys[k] === null) pen = "M"; else { path += pen + X(x).toFixed(1) + " " + Y(ys[k]).toFixed(1); pen = "L"; } });
    out.push(`<rect class="frame" x="${l}" y="${t}" width="${w - l - r}" height="${h - t - b}"/><path class="curve" d="${path}"/>`, svgLine(X(cursor), t, X(cursor), h - b, "cursor"), svgText(w / 2, h - 6, title), upright(14, h / 2 - 10, nameOf(field)));
    document.getElementById(id).innerHTML = out.join("");
  }
  function move(x, z) {
    const isRing = film.is_ring;
    state.cursor = [isRing ? ((x % film.width) + film.width) % film.width : within(x, 0, film.width), within(z, film.bottom, film.top)];
    drawCursor();
  }
  function toward(event) {
    const r = canvas.getBoundingClientRect();
    move(within((event.clientX - r.left) / r.width, 0, 1 - 1e-9) * film.width, film.top - ((event.clientY - r.top) / r.height) * (film.top - film.bottom));
  }
  box.addEventListener("pointermove", (event) => { if (event.pointerType === "mouse" || event.buttons) toward(event); });
  box.addEventListener("pointerdown", toward);
  box.addEventListener("keydown", (event) => {
    const go = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key], by = event.shiftKey ? 10 : 1;
    if (!go) return;
    move(state.cursor[0] + go[0] * by * DEGREE, state.cursor[1] + (go[1] * by * (film.top - film.bottom)) / 100);
    event.preventDefault();
  });
  return { draw };
}
