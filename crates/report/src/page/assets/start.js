// Reads the film or the sweep, draws it, and says when it is drawn.
(async () => {
  const root = document.documentElement, text = document.getElementById("data"), cases = document.getElementById("cases");
  if (cases && typeof DecompressionStream !== "undefined") {
    const sweep = await readSweep(JSON.parse(cases.textContent));
    root.dataset.live = "yes";
    sweepOf(sweep);
    root.dataset.ready = "yes";
    return;
  }
  if (!text || typeof DecompressionStream === "undefined") { root.dataset.ready = "static"; return; }
  const film = await readFilm(JSON.parse(text.textContent)), byName = (name) => film.fields.find((field) => field.name === name);
  // The cursor starts at the peak.
  const first = film.fields[0];
  let most = 0;
  for (let k = 1; k < film.triangles.length; k++) if (first.values[film.triangles[k]] > first.values[film.triangles[most]]) most = k;
  const whole = 2 * Math.PI, x = film.x[most] < 0 ? film.x[most] + whole : film.x[most] > whole ? film.x[most] - whole : film.x[most];
  const state = { field: first, cursor: [Math.min(film.width, Math.max(0, x)), film.z[most]] };
  root.dataset.live = "yes";
  const map = mapOf(film, state), view = viewOf(film, state);
  for (const input of document.querySelectorAll("input[name=field]")) {
    input.addEventListener("change", () => { state.field = byName(input.value); map.draw(); view.later(); });
    if (input.checked) state.field = byName(input.value);
  }
  for (const id of ["lines", "mesh"]) document.getElementById(id).addEventListener("change", map.draw);
  // Values in SI by field, as film.vtu has them; null where there is no film.
  window.oilwedge = {
    at(degrees, millimetres) {
      const angle = (((degrees * DEGREE - film.origin) % whole) + whole) % whole;
      const place = film.locate(angle, millimetres / 1e3) || film.locate(angle - whole, millimetres / 1e3);
      if (!place) return null;
      const value = (field) => (field.interpolation === "constant" ? field.values[place[0]] : quadraticAt(film, field, place));
      return Object.fromEntries(film.fields.map((field) => [field.name, value(field)]));
    },
  };
  let seen = 0;
  new ResizeObserver(() => { const now = document.getElementById("map").clientWidth; if (now !== seen) { seen = now; map.draw(); view.later(); } }).observe(document.getElementById("map"));
  map.draw(); seen = document.getElementById("map").clientWidth; view.draw();
  root.dataset.ready = "yes";
})();
