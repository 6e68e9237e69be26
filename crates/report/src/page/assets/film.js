"use strict";
// The film of the page: its numbers, unpacked, and its value at any point. Other parts of the script draw it.
const TURN = 2 ** 32, DEGREE = Math.PI / 180;

async function unpack({ count, data }) {
  const bytes = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  const planes = new Uint8Array(await new Response(stream).arrayBuffer()), words = new Uint32Array(count);
  for (let k = 0; k < count; k++) words[k] = planes[k] | (planes[count + k] << 8) | (planes[2 * count + k] << 16) | (planes[3 * count + k] << 24);
  return words;
}

function trianglesOf(codes) {
  let next = 0;
  return codes.map((code) => { const node = (next - code) >>> 0; next = Math.max(next, node + 1); return node; });
}

// What predicts each node, as the program has it: the vertex before, or the ends of its side.
function predictionOf(triangles, nodes) {
  const met = new Uint8Array(nodes), order = new Uint32Array(nodes), first = new Uint32Array(nodes), second = new Uint32Array(nodes);
  let count = 0;
  for (let t = 0; t < triangles.length; t += 6) for (let k = 0; k < 3; k++) { const n = triangles[t + k]; if (!met[n]) { met[n] = 1; order[count++] = n; } }
  const vertices = count;
  for (let t = 0; t < triangles.length; t += 6) for (let k = 0; k < 3; k++) {
    const n = triangles[t + 3 + k];
    if (!met[n]) { met[n] = 1; first[count] = triangles[t + k]; second[count] = triangles[t + (k + 1) % 3]; order[count++] = n; }
  }
  return { order, first, second, vertices, count };
}

function valuesOf(differences, { order, first, second, vertices, count }, nodes) {
  const values = new Uint32Array(nodes);
  let last = 0;
  for (let k = 0; k < count; k++) {
    const code = differences[k], difference = (code >>> 1) ^ -(code & 1);
    const predicted = k < vertices ? last : values[first[k]] + ((values[second[k]] - values[first[k]] | 0) >> 1);
    values[order[k]] = predicted + difference;
    if (k < vertices) last = values[order[k]];
  }
  return values;
}

function colourTable(hex) {
  const size = 1024, steps = hex.length / 6 - 1, table = new Uint8Array(3 * size);
  const part = (k, c) => parseInt(hex.substr(6 * k + 2 * c, 2), 16);
  for (let i = 0; i < size; i++) {
    const place = (i / (size - 1)) * steps, k = Math.min(steps - 1, place | 0);
    for (let c = 0; c < 3; c++) table[3 * i + c] = part(k, c) + (place - k) * (part(k + 1, c) - part(k, c));
  }
  return table;
}

// The parts of a triangle on which a linear field is linear, by their nodes.
const PARTS = [[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]];
const shapes = (a, b, c) => [a * (2 * a - 1), b * (2 * b - 1), c * (2 * c - 1), 4 * a * b, 4 * b * c, 4 * c * a];

async function readFilm(about) {
  const [codes, angles, heights, ...packed] = await Promise.all(
    [about.triangles, about.angle, about.height, ...about.fields.map((field) => field.values)].map(unpack));
  const triangles = trianglesOf(codes), nodes = about.nodes, prediction = predictionOf(triangles, nodes), cells = triangles.length / 6;
  const turns = valuesOf(angles, prediction, nodes), steps = valuesOf(heights, prediction, nodes);
  const [bottom, top] = about.axis, [from, to] = about.angles;
  // Nodes of each triangle: angle [rad] from the left end on, continuous within the triangle, and height [m].
  const x = new Float64Array(6 * cells), z = new Float64Array(6 * cells), curved = new Uint8Array(cells);
  const cut = Math.round((((from / (2 * Math.PI)) % 1) + 1) % 1 * TURN) >>> 0, whole = 2 * Math.PI, slack = 1e-7;
  for (let t = 0; t < cells; t++) {
    const own = turns[triangles[6 * t]], start = ((own - cut) >>> 0) / TURN * whole;
    let sum = 0;
    for (let i = 0; i < 6; i++) {
      const n = triangles[6 * t + i];
      x[6 * t + i] = start + ((turns[n] - own) | 0) / TURN * whole;
      z[6 * t + i] = bottom + (steps[n] / (TURN - 1)) * (top - bottom);
      sum += x[6 * t + i];
    }
    // A triangle just left of the cut, as rounding may have it, belongs to it.
    const shift = sum / 6 >= whole ? -whole : sum / 6 < 0 ? whole : 0;
    if (shift) for (let i = 0; i < 6; i++) x[6 * t + i] += shift;
    for (let k = 0; k < 3; k++) {
      const a = 6 * t + k, b = 6 * t + (k + 1) % 3, m = 6 * t + 3 + k;
      const off = Math.hypot((x[m] - (x[a] + x[b]) / 2) * about.radius, z[m] - (z[a] + z[b]) / 2);
      if (off > slack * Math.hypot((x[b] - x[a]) * about.radius, z[b] - z[a])) curved[t] = 1;
    }
  }
  const fields = about.fields.map((field, k) => {
    const [low, high] = field.range;
    const values = field.interpolation === "constant" ? new Float32Array(packed[k].buffer)
      : Float64Array.from(valuesOf(packed[k], prediction, nodes), (step) => low + (step / (2 ** 24 - 1)) * (high - low));
    return { ...field, values, table: colourTable(field.map) };
  });
  return { ...about, triangles, cells, x, z, curved, fields, width: to - from, origin: from, bottom, top, locate: locator(cells, x, z, curved, to - from, bottom, top) };
}

// Shares of a point in a triangle; where its sides are curved by Newton's method.
function sharesOf({ x, z, curved }, t, px, pz) {
  const o = 6 * t, bx = x[o + 1] - x[o], bz = z[o + 1] - z[o], cx = x[o + 2] - x[o], cz = z[o + 2] - z[o], det = bx * cz - bz * cx;
  let b = ((px - x[o]) * cz - (pz - z[o]) * cx) / det, c = (bx * (pz - z[o]) - bz * (px - x[o])) / det;
  for (let step = 0; curved[t] && step < 5; step++) {
    const a = 1 - b - c, n = shapes(a, b, c), db = [1 - 4 * a, 4 * b - 1, 0, 4 * (a - b), 4 * c, -4 * c], dc = [1 - 4 * a, 0, 4 * c - 1, -4 * b, 4 * b, 4 * (a - c)];
    let rx = px, rz = pz, xb = 0, xc = 0, zb = 0, zc = 0;
    for (let i = 0; i < 6; i++) { const X = x[o + i], Z = z[o + i]; rx -= n[i] * X; rz -= n[i] * Z; xb += db[i] * X; xc += dc[i] * X; zb += db[i] * Z; zc += dc[i] * Z; }
    const d = xb * zc - xc * zb; b += (rx * zc - rz * xc) / d; c += (xb * rz - zb * rx) / d;
  }
  return [1 - b - c, b, c];
}

// Finds the triangle of a point by bins of equal size.
function locator(cells, x, z, curved, width, bottom, top) {
  const across = 160, up = 40, whole = 2 * Math.PI, heads = new Map(), shape = { x, z, curved };
  const column = (v) => Math.min(across - 1, Math.max(0, Math.floor((v / width) * across)));
  const row = (v) => Math.min(up - 1, Math.max(0, Math.floor(((v - bottom) / (top - bottom)) * up)));
  const put = (t, shift) => {
    let a = Infinity, b = -Infinity, c = Infinity, d = -Infinity;
    for (let i = 6 * t; i < 6 * t + 6; i++) { a = Math.min(a, x[i] + shift); b = Math.max(b, x[i] + shift); c = Math.min(c, z[i]); d = Math.max(d, z[i]); }
    if (b < 0 || a > width) return;
    for (let i = column(a); i <= column(b); i++) for (let j = row(c); j <= row(d); j++) { const key = i * up + j; (heads.get(key) || heads.set(key, []).get(key)).push(t, shift); }
  };
  for (let t = 0; t < cells; t++) for (const shift of [-whole, 0, whole]) put(t, shift);
  return (px, pz) => {
    let best = null, most = -1e-6;
    const found = heads.get(column(px) * up + row(pz)) || [];
    for (let k = 0; k < found.length; k += 2) {
      const t = found[k], [a, b, c] = sharesOf(shape, t, px - found[k + 1], pz), least = Math.min(a, b, c);
      if (least > most) { most = least; best = [t, a, b, c]; }
    }
    return best;
  };
}

function quadraticAt({ triangles }, { values }, [t, a, b, c]) {
  const n = shapes(a, b, c);
  let sum = 0;
  for (let i = 0; i < 6; i++) sum += n[i] * values[triangles[6 * t + i]];
  return sum;
}

// The value that is drawn: a field that is linear on the parts of triangles by its part, a quadratic nowhere below the
// least value of the model.
function valueAt(film, field, place) {
  if (!place) return null;
  const [t, ...shares] = place;
  if (field.interpolation === "constant") return field.values[t];
  if (field.interpolation === "quadratic") return Math.max(quadraticAt(film, field, place), field.floor ?? -Infinity);
  const corner = shares.findIndex((share) => share >= 0.5), v = (k) => field.values[film.triangles[6 * t + k]], [a, b, c] = shares;
  if (corner < 0) return v(3) * (1 - 2 * c) + v(4) * (1 - 2 * a) + v(5) * (1 - 2 * b);
  const next = (corner + 1) % 3, last = (corner + 2) % 3;
  return v(corner) * (2 * shares[corner] - 1) + v(3 + corner) * 2 * shares[next] + v(3 + last) * 2 * shares[last];
}

// Round numbers within a range, about so many.
function roundNumbers(low, high, wanted) {
  const raw = (high - low) / wanted || 1, power = 10 ** Math.floor(Math.log10(raw)), list = [];
  const step = [1, 2, 2.5, 5, 10].find((s) => s * power >= raw * (1 - 1e-9)) * power;
  for (let k = Math.ceil(low / step - 1e-9); k <= high / step + 1e-9; k++) list.push(k * step);
  return list;
}
const POWERS = "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079";
function written(value, digits = 4) {
  if (value === 0) return "0";
  const isShort = Math.abs(value) >= 1e-4 && Math.abs(value) < 1e6, [mantissa, power] = isShort ? [String(+value.toPrecision(digits))] : value.toExponential(Math.min(2, digits - 1)).split("e");
  return mantissa.replace("-", "\u2212") + (power ? "\u00b710" + power.replace("+", "").replace("-", "\u207b").replace(/\d/g, (digit) => POWERS[digit]) : "");
}
const shareOf = ({ colours: [low, high], is_logarithmic }, value) => (is_logarithmic ? Math.log(Math.max(value, low) / low) / Math.log(high / low) : (value - low) / (high - low));
const marksOf = (field, wanted) => {
  const [low, high] = field.colours;
  if (!field.is_logarithmic) return roundNumbers(low / field.size, high / field.size, wanted).map((value) => value * field.size);
  const list = [];
  for (let k = Math.ceil(Math.log10(low)); k <= Math.log10(high); k++) list.push(10 ** k);
  return list;
};
const degreesOf = (film, x) => ((((x + film.origin) / DEGREE) % 360) + 360) % 360;
