// Colours of values: the ramp, robust scales, and the legend.

const RAMP = ["#440154", "#3b528b", "#21918c", "#5ec962", "#fde725"].map((c) => new THREE.Color(c));
const LEVELS = Array.from({ length: 256 }, (_, k) => {
  const z = (4 * k) / 255, i = Math.min(Math.floor(z), 3);
  return new THREE.Color().copy(RAMP[i]).lerp(RAMP[i + 1], z - i);
});

/** Colour of a value between 0 and 1. */
function ramp(x) {
  return LEVELS[x > 0 ? (x < 1 ? Math.round(255 * x) : 255) : 0];
}

/** Where a value lies in a range; 0 if the range has no width. */
function share(value, range) {
  return range[1] > range[0] ? (value - range[0]) / (range[1] - range[0]) : 0;
}

/** The values of all parts: of the whole run, or of one instant. */
function gather(parts, name, instant) {
  const found = [];
  for (const part of parts) {
    const track = part.values[name];
    if (track) for (const x of instant ? track.at(instant) : track.all) found.push(x);
  }
  return Float32Array.from(found);
}

/**
 * The range of a scale: "robust" leaves out the outermost percent at either end of the whole run, "run" nothing,
 * "frame" is that of the picture. A range that is only noise has no width: everything gets one colour.
 */
function rangeOf(parts, name, kind, instant) {
  const modal = scene.modes.length > 0; // values change with the amplitude
  const values = gather(parts, name, kind === "frame" || modal ? instant : null).sort();
  if (!values.length) return [0, 0];
  const cut = kind === "robust" ? 0.01 : 0, last = values.length - 1;
  let range = [values[Math.floor(cut * last)], values[Math.ceil((1 - cut) * last)]];
  if (parts.some((part) => part.values[name] instanceof Modal)) range[0] = 0; // amplitudes
  const floor = Math.max(scene.floors[name] || 0, 1e-6 * Math.max(Math.abs(range[0]), Math.abs(range[1])));
  if (range[1] - range[0] <= floor) range = [range[0], range[0]];
  return range;
}

/** A number as text, zero if it is noise. */
function level(name, x) {
  return short(Math.abs(x) <= (scene.floors[name] || 0) ? 0 : x);
}

/** Unit of a value as text, with the space before it. */
function unitOf(name) {
  const unit = scene.units[name];
  return !unit || unit === "-" ? "" : ` ${unit}`;
}

/** Write the legend of a scale. */
function showLegend(name, range) {
  get("legend").hidden = !name;
  if (!name) return;
  const middle = (range[0] + range[1]) / 2, flat = range[0] === range[1];
  get("what").textContent = `${name}${unitOf(name) ? ` [${unitOf(name).trim()}]` : ""}`;
  get("low").textContent = level(name, range[0]);
  get("half").textContent = flat ? "" : level(name, middle);
  get("high").textContent = flat ? "everywhere" : level(name, range[1]);
}
