// The page: plays the scene, and joins the controls to it.

const get = (id) => document.getElementById(id);
const start = scene.times[0], end = scene.times[scene.times.length - 1];
const wished = new URLSearchParams(location.hash.slice(1)); // #t=1.5 opens at that time, at rest
const canvas = get("picture");
const state = { t: start, phase: 0, playing: false, dirty: true, last: 0 };

// -- what there is to see ---------------------------------------------------------------------

const renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
const world = new THREE.Scene(), root = new THREE.Group();
world.background = new THREE.Color("#f6f8fa");
root.quaternion.setFromRotationMatrix(
  new THREE.Matrix4().makeBasis(...scene.axes.map((row) => new THREE.Vector3(...row))).transpose(),
);
root.updateMatrixWorld();
const sun = new THREE.DirectionalLight("#ffffff", 2.2);
world.add(root, sun, new THREE.HemisphereLight("#ffffff", "#9aa3ab", 1.6));
const parts = makeParts(), roads = scene.roads.map((z) => new Road(z));
root.add(...parts.map((z) => z.object), ...roads.map((z) => z.object));
const triad = new THREE.AxesHelper(0.2 * scene.size);
root.add(triad);
const points = new Map(parts.filter((z) => z instanceof Mark).map((z) => [z.spec.name, z]));
const orbit = new Orbit(canvas, () => (state.dirty = true));
let traces = [];

/** Smallest and largest of a value over all parts and frames. */
function range(name) {
  let low = Infinity, high = -Infinity;
  for (const part of parts)
    for (const x of part.values[name]?.all ?? []) {
      low = Math.min(low, x);
      high = Math.max(high, x);
    }
  return [low, high];
}

// -- one picture ------------------------------------------------------------------------------

function instant() {
  const mode = scene.modes.length ? +get("mode").value : -1;
  return { ...locate(state.t), mode, phase: state.phase, amplitude: +get("amplitude").value * scene.size };
}

function show() {
  const now = instant(), name = get("colour").value, limits = name ? range(name) : null;
  for (const part of parts) {
    part.update(now);
    if (name) part.paint(name, limits, now);
  }
  traces.forEach((z) => z.update(now));
  const followed = points.get(get("follow").value);
  orbit.base.fromArray(followed ? followed.track.at(now) : scene.camera.centre).applyQuaternion(root.quaternion);
  const width = canvas.clientWidth || 1, height = canvas.clientHeight || 1;
  if (renderer.shown !== `${width} ${height}`) {
    renderer.shown = `${width} ${height}`;
    renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    renderer.setSize(width, height, false);
  }
  orbit.place(width / height);
  sun.position.copy(orbit.camera.position).add(new THREE.Vector3(0, 0, orbit.span));
  sun.target.position.copy(orbit.target);
  sun.target.updateMatrixWorld();
  const target = orbit.target.applyQuaternion(root.quaternion.clone().invert());
  roads.forEach((z) => z.update(target, orbit.span));
  renderer.render(world, orbit.camera);
  tell(now);
}

function tell(now) {
  const modal = now.mode >= 0, text = modal ? scene.modes[now.mode].text : `${state.t.toFixed(scene.digits)} s`;
  get("time").textContent = text;
  canvas.dataset.frame = now.frame;
  const scrub = get("scrub");
  scrub.value = modal ? (state.phase / (2 * Math.PI)) % 1 : (state.t - start) / (end - start || 1);
  scrub.setAttribute("aria-valuetext", text);
}

function tick(time) {
  const dt = Math.min((time - state.last) / 1000, 0.1) * +get("speed").value;
  state.last = time;
  if (state.playing) {
    if (scene.modes.length) state.phase = (state.phase + Math.PI * dt) % (2 * Math.PI);
    else state.t = state.t + dt > end ? start : state.t + dt;
  }
  if (state.playing || state.dirty) {
    state.dirty = false;
    show();
  }
  requestAnimationFrame(tick);
}

// -- controls ---------------------------------------------------------------------------------

function play(on) {
  state.playing = on;
  get("play").textContent = on ? "Pause" : "Play";
}

/** Pause, and go to a time. */
function go(t) {
  play(false);
  state.t = Math.min(Math.max(t, start), end);
  state.dirty = true;
}

function step(by) {
  const now = locate(state.t), k = by < 0 ? now.frame + (now.fraction > 0 ? 0 : by) : now.frame + by;
  if (scene.modes.length) {
    play(false);
    state.phase = (state.phase + (by * Math.PI) / 12 + 2 * Math.PI) % (2 * Math.PI);
    state.dirty = true;
  } else {
    go(scene.times[Math.min(Math.max(k, 0), scene.times.length - 1)]);
  }
}

function options(id, pairs, chosen = []) {
  for (const [value, text] of pairs) {
    const option = new Option(text, value, false, chosen.includes(value));
    get(id).add(option);
  }
  get(id).addEventListener("change", () => (state.dirty = true));
}

function checkbox(text, on, act) {
  const label = document.createElement("label"), box = document.createElement("input");
  box.type = "checkbox";
  box.checked = on;
  box.addEventListener("change", () => {
    act(box.checked);
    state.dirty = true;
  });
  label.append(box, text);
  get("show").append(label);
  act(on);
}

function retrace() {
  const colours = ["#2e8540", "#c8501e", "#0b5fa5", "#7b3f98", "#b8860b"];
  root.remove(...traces.map((z) => z.line));
  const chosen = [...get("trace").selectedOptions].map((z) => points.get(z.value));
  traces = chosen.map((part, i) => new Trace(part, colours[i % colours.length]));
  if (traces.length) root.add(...traces.map((z) => z.line));
}

function recolour() {
  const name = get("colour").value;
  get("legend").hidden = !name;
  if (name) {
    const unit = scene.units[name] === "-" ? "" : ` ${scene.units[name] || ""}`, [low, high] = range(name);
    get("low").textContent = `${name} ${short(low)}`;
    get("high").textContent = short(high) + unit;
  } else {
    parts.forEach((z) => z.paint(null));
  }
}

function prepareControls() {
  get("title").textContent = scene.title;
  get("caption").textContent = scene.caption;
  canvas.setAttribute("aria-label", `Picture of ${scene.title || "the mechanism"}; arrow keys turn it, plus and minus zoom`);
  const names = [...points.keys()].map((z) => [z, z]);
  options("follow", [["", "nothing"], ...names], [scene.camera.follow]);
  options("trace", names, scene.trails);
  const values = [...new Set(parts.flatMap((z) => Object.keys(z.values)))];
  options("colour", [["", "kind of part"], ...values.map((z) => [z, z])]);
  options("mode", scene.modes.map((z, i) => [String(i), z.name]));
  const speeds = [...new Set([0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, scene.speed])];
  options("speed", speeds.sort((a, b) => a - b).map((z) => [String(z), `${z} ×`]), [String(scene.speed)]);
  get("modes").hidden = get("size").hidden = !scene.modes.length;
  get("trace").parentElement.hidden = get("follow").parentElement.hidden = Boolean(scene.modes.length);
  get("colour").parentElement.hidden = !values.length;
  get("trace").addEventListener("change", retrace);
  get("colour").addEventListener("change", recolour);
  get("amplitude").addEventListener("input", () => (state.dirty = true));
  const visible = (styles) => (on) => parts.forEach((z) => styles.includes(z.spec.style) && (z.object.visible = on));
  const kinds = { bodies: ["box"], "mass centres": ["mass"], points: ["joint", "fixed"], hinges: ["hinge"], forces: ["force"], outlines: ["sketch"] };
  for (const [text, styles] of Object.entries(kinds))
    if (parts.some((z) => styles.includes(z.spec.style))) checkbox(text, true, visible(styles));
  if (roads.length) checkbox("road", true, (on) => roads.forEach((z) => (z.object.visible = on)));
  checkbox("axes x y z", false, (on) => (triad.visible = on));
  const { azimuth, elevation, span } = scene.camera;
  get("fit").onclick = () => orbit.look(azimuth, elevation, span);
  get("front").onclick = () => orbit.look(0, 0);
  get("side").onclick = () => orbit.look(-90, 0);
  get("top").onclick = () => orbit.look(-90, 90);
  orbit.look(azimuth, elevation, span);
  get("panel").open = innerWidth > 800;
}

function prepareTime() {
  get("play").onclick = () => play(!state.playing);
  get("scrub").addEventListener("input", () => {
    const x = +get("scrub").value;
    if (scene.modes.length) {
      play(false);
      state.phase = 2 * Math.PI * x;
      state.dirty = true;
    } else {
      go(start + x * (end - start));
    }
  });
  const keys = {
    " ": () => play(!state.playing), ArrowLeft: () => step(-1), ArrowRight: () => step(1),
    Home: () => go(start), End: () => go(end),
  };
  addEventListener("keydown", (e) => {
    const own = /^(INPUT|SELECT|BUTTON|SUMMARY)$/.test(e.target.tagName); // these have keys of their own
    if (own || !keys[e.key] || e.ctrlKey || e.metaKey || e.altKey) return;
    e.preventDefault();
    keys[e.key]();
  });
  const moving = scene.modes.length || end > start;
  get("play").disabled = get("scrub").disabled = !moving;
  if (wished.has("t")) go(+wished.get("t"));
  else play(Boolean(moving) && !matchMedia("(prefers-reduced-motion: reduce)").matches);
}

prepareControls();
prepareTime();
retrace();
new ResizeObserver(() => (state.dirty = true)).observe(canvas);
canvas.addEventListener("webglcontextrestored", () => (state.dirty = true));
requestAnimationFrame((time) => {
  state.last = time;
  tick(time);
});
