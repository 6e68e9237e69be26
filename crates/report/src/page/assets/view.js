// The liner in space, with a depth buffer of its own, so that it looks the same everywhere and needs no graphics card.
function viewOf(film, state) {
  const view = document.getElementById("view"), { triangles, x, z, cells } = film;
  // First the peak faces the reader.
  let turn = -Math.PI / 2 - 0.35 - (state.cursor[0] + film.origin), tilt = 0.5;
  const parts = new Uint32Array(12 * cells);
  for (let t = 0, k = 0; t < cells; t++) for (const part of PARTS) for (const i of part) parts[k++] = 6 * t + i;
  const cosines = Float64Array.from(x, (v) => Math.cos(v + film.origin)), sines = Float64Array.from(x, (v) => Math.sin(v + film.origin));
  const places = new Float32Array(18 * cells), shares = new Float32Array(6 * cells);

  function draw() {
    const field = state.field.interpolation === "constant" ? film.fields[0] : state.field, dots = Math.min(2, window.devicePixelRatio || 1);
    const N = Math.max(64, Math.round(Math.min(view.clientWidth * dots, 720))), isDiverging = field.colours[0] < 0;
    view.width = view.height = N;
    const picture = new ImageData(N, N), data = picture.data, depth = new Float32Array(N * N).fill(-1e9), R = film.radius, long = film.top - film.bottom;
    const scale = (0.34 * N) / Math.max(R, 0.62 * long), ct = Math.cos(turn), st = Math.sin(turn), cl = Math.cos(tilt), sl = Math.sin(tilt), middle = (film.top + film.bottom) / 2;
    const project = (a, b, c, out, k) => { const u = a * ct - b * st, w = a * st + b * ct; out[3 * k] = N / 2 + scale * u; out[3 * k + 1] = N / 2 - scale * ((c - middle) * cl + w * sl); out[3 * k + 2] = scale * (-w * cl + (c - middle) * sl); };
    for (let k = 0; k < 6 * cells; k++) {
      const s = Math.min(1, Math.max(0, shareOf(field, field.values[triangles[k]]))), r = R * (1 + 0.32 * (isDiverging ? 2 * s - 1 : s));
      shares[k] = s; project(r * cosines[k], r * sines[k], z[k], places, k);
    }
    const fill = (list, P, colour) => {
      for (let t = 0; t < list.length; t += 3) {
        const a = list[t], b = list[t + 1], c = list[t + 2], Ax = P[3 * a], Ay = P[3 * a + 1], Az = P[3 * a + 2];
        const ux = P[3 * b] - Ax, uy = P[3 * b + 1] - Ay, uz = P[3 * b + 2] - Az, vx = P[3 * c] - Ax, vy = P[3 * c + 1] - Ay, vz = P[3 * c + 2] - Az, det = ux * vy - uy * vx;
        if (Math.abs(det) < 1e-9) continue;
        const nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, light = 0.62 + 0.38 * Math.min(1, Math.abs(0.35 * nx - 0.5 * ny + 0.8 * det) / Math.hypot(nx, ny, det));
        const i0 = Math.max(0, Math.floor(Ax + Math.min(0, ux, vx))), i1 = Math.min(N - 1, Math.ceil(Ax + Math.max(0, ux, vx)));
        const j0 = Math.max(0, Math.floor(Ay + Math.min(0, uy, vy))), j1 = Math.min(N - 1, Math.ceil(Ay + Math.max(0, uy, vy)));
        for (let j = j0; j <= j1; j++) for (let i = i0; i <= i1; i++) {
          const px = i + 0.5 - Ax, py = j + 0.5 - Ay, B = (px * vy - py * vx) / det, C = (ux * py - uy * px) / det;
          if (B < -0.001 || C < -0.001 || B + C > 1.001) continue;
          const deep = Az + B * uz + C * vz, o = j * N + i;
          if (deep > depth[o]) { depth[o] = deep; colour(4 * o, a, b, c, B, C, light); }
        }
      }
    };
    const table = field.table;
    fill(parts, places, (o, a, b, c, B, C, light) => {
      const k = 3 * ((1023 * (shares[a] + B * (shares[b] - shares[a]) + C * (shares[c] - shares[a]))) | 0);
      data[o] = table[k] * light; data[o + 1] = table[k + 1] * light; data[o + 2] = table[k + 2] * light; data[o + 3] = 255;
    });
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
