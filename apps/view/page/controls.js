// The controls beside the picture: selections, lists of boxes to tick, views.

// What is shown, by styles; and what is shown only when it is asked for.
const ASIDE = { "inertia boxes": ["box"], "points of lines": ["joint"] };
const KINDS_SHOWN = {
  bodies: ["box"], "mass centres": ["mass"], points: ["joint", "fixed"], hinges: ["hinge", "spiral"], springs: ["spring", "damper"],
  guides: ["guide", "slide"], forces: ["force"], loads: ["load"], outlines: ["sketch"], solids: ["solid"],
};

function options(id, pairs, chosen = []) {
  for (const [value, text] of pairs) {
    const option = new Option(text, value, false, chosen.includes(value));
    get(id).add(option);
  }
  get(id).addEventListener("change", () => (state.dirty = true));
}

function checkbox(text, on, act, where = "show") {
  const label = document.createElement("label"), box = document.createElement("input");
  box.type = "checkbox";
  box.checked = on;
  box.addEventListener("change", () => {
    act(box.checked);
    state.dirty = true;
  });
  label.append(box, text);
  get(where).append(label);
  act(on);
  return box;
}

/** A list of names to tick; long ones can be searched. `changed` gets the names that are ticked, in their order. */
function checklist(where, names, chosen, changed) {
  const ticked = new Set(chosen), tell = () => changed(names.filter((name) => ticked.has(name))), ready = { now: false };
  get(where).closest("details").hidden = !names.length;
  if (names.length > 8) {
    const search = document.createElement("input");
    search.type = "search";
    search.placeholder = "Search";
    search.setAttribute("aria-label", "search names");
    search.addEventListener("input", () => {
      for (const label of get(where).querySelectorAll("label")) label.hidden = !label.textContent.toLowerCase().includes(search.value.toLowerCase());
    });
    get(where).before(search);
  }
  for (const name of names)
    checkbox(name, ticked.has(name), (on) => {
      ticked[on ? "add" : "delete"](name);
      if (ready.now) tell();
    }, where);
  ready.now = true;
  tell();
}

function recolour() {
  state.ranged = "";
  const name = get("colour").value;
  get("scales").hidden = !name || scene.modes.length > 0;
  if (!name) {
    showLegend("", null);
    parts.forEach((part) => part.paint(null));
  }
  state.dirty = true;
}

function prepareArrows() {
  const any = Arrow.unit > 0, original = Arrow.reach;
  get("arrows").hidden = get("arrowsize").parentElement.hidden = !any;
  const tellScale = () => (get("arrows").textContent = `longest arrow ${short(Arrow.unit)} N; ${short(Arrow.unit / (Arrow.reach * scene.size))} N per metre`);
  get("arrowsize").addEventListener("input", () => {
    Arrow.reach = original * 10 ** +get("arrowsize").value;
    tellScale();
    state.dirty = true;
  });
  tellScale();
}

function prepareViews() {
  const { azimuth, elevation, span, fit } = scene.camera;
  get("fit").onclick = () => orbit.fit(azimuth, elevation);
  get("front").onclick = () => orbit.look(0, 0);
  get("side").onclick = () => orbit.look(-90, 0);
  get("top").onclick = () => orbit.look(-90, 90);
  orbit.look(azimuth, elevation, span);
  if (fit) orbit.fit(azimuth, elevation);
}

function prepareControls() {
  get("title").textContent = scene.title;
  get("caption").textContent = scene.caption;
  canvas.setAttribute("aria-label", `Picture of ${scene.title || "the mechanism"}; arrow keys turn it, plus and minus zoom`);
  const modal = scene.modes.length > 0, names = [...points.keys()].sort((a, b) => (b === MECHANISM) - (a === MECHANISM));
  options("follow", [["", "nothing"], ...names.map((name) => [name, name])], [scene.camera.follow]);
  const traced = names.filter((name) => name !== MECHANISM);
  checklist("trace", modal ? [] : traced, scene.trails, (chosen) => {
    traces.choose(chosen.map((name) => points.get(name)), ["#2e8540", "#c8501e", "#0b5fa5", "#7b3f98", "#b8860b"]);
  });
  checklist("quantities", end > start ? strip.rows.map((row) => row.name) : [], scene.plots.shown, (chosen) => strip.choose(chosen));
  const values = [...new Set(parts.flatMap((part) => Object.keys(part.values)))];
  options("colour", [["", "kind of part"], ...values.map((name) => [name, name])], [scene.colour]);
  options("mode", scene.modes.map((mode, i) => [String(i), mode.name]));
  const speeds = [...new Set([0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, scene.speed])];
  options("speed", speeds.sort((a, b) => a - b).map((speed) => [String(speed), `${speed} ×`]), [String(scene.speed)]);
  get("modes").hidden = get("size").hidden = !modal;
  get("follow").parentElement.hidden = modal;
  get("colour").parentElement.hidden = !values.length;
  get("colour").addEventListener("change", recolour);
  get("scale").addEventListener("change", () => {
    state.scale = get("scale").value;
    recolour();
  });
  get("amplitude").addEventListener("input", () => (state.dirty = true));
  const visible = (styles) => (on) => parts.forEach((part) => styles.includes(part.spec.style) && (part.visible = on));
  for (const [kinds, aside] of [[KINDS_SHOWN, false], [ASIDE, true]])
    for (const [text, styles] of Object.entries(kinds)) {
      const some = parts.filter((part) => styles.includes(part.spec.style) && Boolean(part.spec.aside) === aside);
      if (some.length) checkbox(text, !aside, (on) => some.forEach((part) => (part.visible = on)));
    }
  if (roads.length || parts.some((part) => part.spec.style === "ground"))
    checkbox("road", true, (on) => {
      roads.forEach((road) => (road.object.visible = on));
      visible(["ground"])(on);
    });
  if (floor) checkbox("floor", true, (on) => (floor.object.visible = on));
  checkbox("axes", false, (on) => (triad.visible = on));
  recolour();
  prepareArrows();
  prepareViews();
  get("panel").open = innerWidth > 800;
}
