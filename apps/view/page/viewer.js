// The page: plays the scene.

const get = (id) => document.getElementById(id);
const start = scene.times[0], end = scene.times[scene.times.length - 1];
const wished = new URLSearchParams(location.hash.slice(1)); // #t=1.5 opens at that time, at rest
const canvas = get("picture");
const MECHANISM = "the mechanism"; // as it is called where something is followed
const state = { t: start, phase: 0, playing: false, dirty: true, last: 0, scale: "robust" };

// -- what there is to see ---------------------------------------------------------------------

const renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
const world = new THREE.Scene(), root = new THREE.Group();
root.quaternion.setFromRotationMatrix(
  new THREE.Matrix4().makeBasis(...scene.axes.map((row) => new THREE.Vector3(...row))).transpose(),
);
root.updateMatrixWorld();
const sun = new THREE.DirectionalLight("#ffffff", 1.7), lamp = new THREE.DirectionalLight("#ffffff", 0.7);
world.add(root, sun, lamp, new THREE.HemisphereLight("#ffffff", "#9aa3ab", 1.5));
const { parts, batches, meshes } = makeParts();
const roads = scene.roads.map((road) => new Road(road)), floor = scene.floor ? new Road(scene.floor) : null;
const grounds = floor ? [...roads, floor] : roads;
renderer.shadowMap.enabled = sun.castShadow = grounds.length > 0 || parts.some((part) => part.spec.style === "ground");
sun.shadow.mapSize.set(1024, 1024);
const triad = new THREE.AxesHelper(0.2 * scene.size), traces = new Traces();
root.add(...meshes, ...grounds.map((ground) => ground.object), triad, traces.line);
const marks = parts.filter((part) => part instanceof Mark).sort((a, b) => Boolean(a.spec.aside) - Boolean(b.spec.aside));
const points = new Map(marks.map((mark) => [mark.spec.name, mark]));
points.set(MECHANISM, { track: new Track(scene.camera.path, 3) }); // its middle
const orbit = new Orbit(canvas, () => (state.dirty = true));
const strip = new Strip((t) => go(t));
const hover = new Hover(canvas, parts, orbit, root, () => instant());

// -- one picture ------------------------------------------------------------------------------

function instant() {
  const mode = scene.modes.length ? +get("mode").value : -1;
  return { ...locate(state.t), mode, phase: state.phase, amplitude: +get("amplitude").value * scene.size };
}

/** Colour all parts; constant scales are found once. */
function paint(now) {
  const name = get("colour").value, kind = state.scale, constant = kind !== "frame" && !scene.modes.length;
  if (!name) return;
  const key = `${name} ${kind}`;
  if (!constant || state.ranged !== key) {
    state.range = rangeOf(parts, name, kind, scene.modes.length ? { ...now, phase: 0 } : now);
    state.ranged = key;
    showLegend(name, state.range);
  }
  for (const part of parts) part.paint(name, state.range, now);
}

function resize() {
  const width = canvas.clientWidth || 1, height = canvas.clientHeight || 1;
  if (renderer.shown !== `${width} ${height}`) {
    renderer.shown = `${width} ${height}`;
    renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    renderer.setSize(width, height, false);
    if (orbit.fits) orbit.due = true;
  }
  return width / height;
}

/** Aim the eye; if Fit is due, from where all that is visible is seen. */
function aim(now, aspect) {
  const followed = points.get(get("follow").value);
  orbit.base.fromArray(followed ? followed.track.at(now) : scene.camera.centre).applyQuaternion(root.quaternion);
  orbit.place(aspect);
  if (!orbit.due) return;
  orbit.due = false;
  const found = fitted(parts, orbit, root, followed, now, aspect);
  if (found) orbit.take(found, aspect);
}

function show() {
  const begun = performance.now(), now = instant();
  for (const part of parts) part.update(now);
  paint(now);
  batches.forEach((batch) => batch.upload());
  traces.update(now);
  const aspect = resize();
  aim(now, aspect);
  placeSun(sun, orbit.target, orbit.span);
  lamp.position.copy(orbit.camera.position).sub(orbit.target);
  const target = orbit.target.applyQuaternion(root.quaternion.clone().invert());
  grounds.forEach((ground) => ground.update(target, orbit.span));
  tellScale(orbit.span, aspect);
  renderer.render(world, orbit.camera);
  tell(now);
  strip.update(now, state.t);
  canvas.dataset.calls = renderer.info.render.calls; // of the graphics card, in this picture
  canvas.dataset.script = (performance.now() - begun).toFixed(2); // milliseconds
}

function tell(now) {
  const modal = now.mode >= 0, text = modal ? scene.modes[now.mode].text : `${state.t.toFixed(scene.digits)} ${scene.clock.unit}`.trim();
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

// -- time -------------------------------------------------------------------------------------

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

const dark = matchMedia("(prefers-color-scheme: dark)");

/** Give the picture and the plot the colours of the page. */
const dress = () => {
  const colours = dark.matches ? DARK : LIGHT;
  world.background = new THREE.Color(colours.background);
  grounds.forEach((ground) => ground.dress(colours));
  strip.dress(colours);
  parts.forEach((part) => part.dress(colours));
};
dress();
prepareControls();
dark.addEventListener("change", () => {
  dress();
  recolour();
});
prepareTime();
new ResizeObserver(() => (state.dirty = true)).observe(canvas);
canvas.addEventListener("webglcontextrestored", () => (state.dirty = true));
requestAnimationFrame((time) => {
  state.last = time;
  tick(time);
});
