// The liner in space, with a depth buffer of its own, so that it looks the same everywhere and needs no graphics card.
// Triangles are divided into small ones, on which a field is as it is, not linear; light is that of slopes averaged at
// the nodes, so that a coarse mesh does not show.
const SMALL = [0.06, 0.08], MOST_PARTS = 12;

function gridOf({ x, z, cells, origin, top, bottom }) {
  const cell = [], shares = [], list = [];
  for (let t = 0; t < cells; t++) {
    const o = 6 * t, extent = (v) => { const own = v.subarray(o, o + 6); return Math.max(...own) - Math.min(...own); };
    // An even number: fields that are linear on the parts of triangles bend at the middles of sides.
    const n = Math.min(MOST_PARTS, 2 * Math.ceil(Math.max(extent(x) / SMALL[0], extent(z) / (SMALL[1] * (top - bottom)), 1) / 2)), first = cell.length;
    const at = (i, j) => first + i * (n + 1) - (i * (i - 1)) / 2 + j;
    for (let i = 0; i <= n; i++) for (let j = 0; j <= n - i; j++) { cell.push(t); shares.push([1 - (i + j) / n, i / n, j / n]); }
    for (let i = 0; i < n; i++) for (let j = 0; j < n - i; j++) {
      list.push(at(i, j), at(i + 1, j), at(i, j + 1));
      if (i + j + 2 <= n) list.push(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  const place = (v) => Float64Array.from(cell, (t, k) => { const n = shapes(...shares[k]); let sum = 0; for (let i = 0; i < 6; i++) sum += n[i] * v[6 * t + i]; return sum; });
  const angles = place(x);
  return { cell, shares, list, heights: place(z), cosines: angles.map((v) => Math.cos(v + origin)), sines: angles.map((v) => Math.sin(v + origin)) };
}

// A field at the points of the grid as part of its colours, and its slopes there, by angle and by height.
function surfaceOf(film, field, grid) {
  const { triangles, x, z, cells } = film, [low, high] = field.colours, nodes = new Float64Array(3 * film.nodes), corners = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0.5, 0.5, 0], [0, 0.5, 0.5], [0.5, 0, 0.5]];
  for (let t = 0; t < cells; t++) corners.forEach(([a, b, c], k) => {
    const db = [1 - 4 * a, 4 * b - 1, 0, 4 * (a - b), 4 * c, -4 * c], dc = [1 - 4 * a, 0, 4 * c - 1, -4 * b, 4 * b, 4 * (a - c)];
    let xb = 0, xc = 0, zb = 0, zc = 0, vb = 0, vc = 0;
    for (let i = 0; i < 6; i++) { const o = 6 * t + i, v = field.values[triangles[o]]; xb += db[i] * x[o]; xc += dc[i] * x[o]; zb += db[i] * z[o]; zc += dc[i] * z[o]; vb += db[i] * v; vc += dc[i] * v; }
    const d = xb * zc - xc * zb, n = 3 * triangles[6 * t + k], sign = Math.sign(d);
    nodes[n] += sign * (vb * zc - vc * zb); nodes[n + 1] += sign * (xb * vc - xc * vb); nodes[n + 2] += Math.abs(d);
  });
  const points = grid.cell.length, shares = new Float32Array(points), around = new Float32Array(points), along = new Float32Array(points);
  for (let k = 0; k < points; k++) {
    const t = grid.cell[k], own = shapes(...grid.shares[k]), s = shareOf(field, valueAt(film, field, [t, ...grid.shares[k]]));
    shares[k] = Math.min(1, Math.max(0, s));
    // Where the colours end the surface is a cylinder.
    if (s > 0 && s < 1) for (let i = 0; i < 6; i++) {
      const n = 3 * triangles[6 * t + i], part = own[i] / (nodes[n + 2] * (high - low) || 1);
      around[k] += part * nodes[n]; along[k] += part * nodes[n + 1];
    }
  }
  return { field, shares, around, along };
}

function viewOf(film, state) {
  const view = document.getElementById("view");
  // First the peak faces the reader.
  let turn = -Math.PI / 2 - 0.35 - (state.cursor[0] + film.origin), tilt = 0.5;
  const grid = gridOf(film), { cell, cosines, sines, heights, list } = grid, points = cell.length;
  const places = new Float32Array(3 * points), lights = new Float32Array(points);
  let surface = null;

  function draw() {
    const field = state.field.interpolation === "constant" ? film.fields[0] : state.field, dots = Math.min(2, window.devicePixelRatio || 1);
    const N = Math.max(64, Math.round(Math.min(view.clientWidth * dots, 720))), isDiverging = field.colours[0] < 0;
    view.width = view.height = N;
    const picture = new ImageData(N, N), data = picture.data, depth = new Float32Array(N * N).fill(-1e9), R = film.radius, long = film.top - film.bottom;
    const scale = (0.34 * N) / Math.max(R, 0.62 * long), ct = Math.cos(turn), st = Math.sin(turn), cl = Math.cos(tilt), sl = Math.sin(tilt), middle = (film.top + film.bottom) / 2;
    const project = (a, b, c, out, k) => { const u = a * ct - b * st, w = a * st + b * ct; out[3 * k] = N / 2 + scale * u; out[3 * k + 1] = N / 2 - scale * ((c - middle) * cl + w * sl); out[3 * k + 2] = scale * (-w * cl + (c - middle) * sl); };
    if (!surface || surface.field !== field) surface = surfaceOf(film, field, grid);
    const { shares, around, along } = surface, rise = 0.32 * (isDiverging ? 2 : 1);
    for (let k = 0; k < points; k++) {
      const r = R * (1 + rise * (isDiverging ? shares[k] - 0.5 : shares[k]));
      project(r * cosines[k], r * sines[k], heights[k], places, k);
      // The normal of the surface, turned as its points are.
      const back = (R * rise * around[k]) / r, a = cosines[k] + back * sines[k], b = sines[k] - back * cosines[k], c = -R * rise * along[k];
      const u = a * ct - b * st, w = a * st + b * ct, up = -(c * cl + w * sl), near = -w * cl + c * sl;
      lights[k] = 0.62 + 0.38 * Math.min(1, Math.abs(0.35 * u - 0.5 * up + 0.8 * near) / Math.hypot(u, up, near));
    }
    const fill = (list, P, colour, lit) => {
      for (let t = 0; t < list.length; t += 3) {
        const a = list[t], b = list[t + 1], c = list[t + 2], Ax = P[3 * a], Ay = P[3 * a + 1], Az = P[3 * a + 2];
        const ux = P[3 * b] - Ax, uy = P[3 * b + 1] - Ay, uz = P[3 * b + 2] - Az, vx = P[3 * c] - Ax, vy = P[3 * c + 1] - Ay, vz = P[3 * c + 2] - Az, det = ux * vy - uy * vx;
        if (Math.abs(det) < 1e-9) continue;
        const la = lit ? lit[a] : 0, lb = lit ? lit[b] - la : 0, lc = lit ? lit[c] - la : 0;
        const nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, flat = 0.62 + 0.38 * Math.min(1, Math.abs(0.35 * nx - 0.5 * ny + 0.8 * det) / Math.hypot(nx, ny, det));
        const i0 = Math.max(0, Math.floor(Ax + Math.min(0, ux, vx))), i1 = Math.min(N - 1, Math.ceil(Ax + Math.max(0, ux, vx)));
        const j0 = Math.max(0, Math.floor(Ay + Math.min(0, uy, vy))), j1 = Math.min(N - 1, Math.ceil(Ay + Math.max(0, uy, vy)));
        for (let j = j0; j <= j1; j++) for (let i = i0; i <= i1; i++) {
          const px = i + 0.5 - Ax, py = j + 0.5 - Ay, B = (px * vy - py * vx) / det, C = (ux * py - uy * px) / det;
          if (B < -0.001 || C < -0.001 || B + C > 1.001) continue;
          const deep = Az + B * uz + C * vz, o = j * N + i;
          if (deep > depth[o]) { depth[o] = deep; colour(4 * o, a, b, c, B, C, lit ? la + B * lb + C * lc : flat); }
        }
      }
    };
    const table = field.table;
    fill(list, places, (o, a, b, c, B, C, light) => {
      const k = 3 * Math.min(1023, Math.max(0, 1023 * (shares[a] + B * (shares[b] - shares[a]) + C * (shares[c] - shares[a])) | 0));
      data[o] = table[k] * light; data[o + 1] = table[k + 1] * light; data[o + 2] = table[k + 2] * light; data[o + 3] = 255;
    }, lights);
    journal(project, fill, data, long, middle);
    view.getContext("2d").putImageData(picture, 0, 0);
  }
  // The journal, its gap exaggerated, with an arrow of its rotation on its near end.
  function journal(project, fill, data, long, middle) {
    const gap = 0.13 * film.radius, r = film.radius - gap - 0.04 * film.radius, half = 0.72 * long, sides = 144;
    const ex = film.eccentricity * gap * Math.cos(film.min_film_angle), ey = film.eccentricity * gap * Math.sin(film.min_film_angle), P = new Float32Array(3 * (2 * sides + 2)), list = [];
    for (let k = 0; k < sides; k++) {
      const a = (k * 2 * Math.PI) / sides, m = (k + 1) % sides;
      project(ex + r * Math.cos(a), ey + r * Math.sin(a), middle - half, P, 2 * k); project(ex + r * Math.cos(a), ey + r * Math.sin(a), middle + half, P, 2 * k + 1);
      list.push(2 * k, 2 * m, 2 * k + 1, 2 * m, 2 * m + 1, 2 * k + 1, 2 * k, 2 * m, 2 * sides, 2 * k + 1, 2 * m + 1, 2 * sides + 1);
    }
    project(ex, ey, middle - half, P, 2 * sides); project(ex, ey, middle + half, P, 2 * sides + 1);
    const paint = (grey) => (o, a, b, c, B, C, light) => { const v = grey * light; data[o] = v; data[o + 1] = v + 3; data[o + 2] = v + 7; data[o + 3] = 255; };
    fill(list, P, paint(208));
    if (!film.turns) return;
    const A = new Float32Array(3 * 60), arrow = [], steps = 24, way = film.turns, face = middle + half * 1.004;
    for (let k = 0; k <= steps; k++) for (const [side, radius] of [[0, 0.58], [1, 0.66]]) { const a = 0.4 + (way * 1.5 * k) / steps; project(ex + r * radius * Math.cos(a), ey + r * radius * Math.sin(a), face, A, 2 * k + side); }
    for (let k = 0; k < steps; k++) arrow.push(2 * k, 2 * k + 1, 2 * k + 2, 2 * k + 1, 2 * k + 3, 2 * k + 2);
    const end = 0.4 + way * 1.5, tip = end + way * 0.28;
    [[0.5, end], [0.74, end], [0.62, tip]].forEach(([radius, a], k) => project(ex + r * radius * Math.cos(a), ey + r * radius * Math.sin(a), face, A, 56 + k));
    arrow.push(56, 57, 58);
    fill(arrow, A, paint(70));
  }
  let isAsked = false;
  const later = () => { if (!isAsked) { isAsked = true; requestAnimationFrame(() => { isAsked = false; draw(); }); } };
  const rotate = (by, up) => { turn += by; tilt = Math.max(-1.5, Math.min(1.5, tilt + up)); later(); };
  view.addEventListener("pointerdown", (event) => view.setPointerCapture(event.pointerId));
  view.addEventListener("pointermove", (event) => { if (event.buttons) rotate(event.movementX * 0.01, event.movementY * 0.01); });
  view.addEventListener("keydown", (event) => {
    const go = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[event.key];
    if (go) { rotate(...go); event.preventDefault(); }
  });
  return { draw, later };
}
