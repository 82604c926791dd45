// The scene's packed numbers, and what they are at any time: between two frames, or in a mode of vibration.

const scene = JSON.parse(document.getElementById("scene").textContent);

/** Bytes from base64. */
function bytes(text) {
  return Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
}

const inflated = new Blob([bytes(scene.numbers)]).stream().pipeThrough(new DecompressionStream("deflate"));
const block = new Uint8Array(await new Response(inflated).arrayBuffer()); // all numbers of the page
scene.numbers = null;
const known = new Map(); // arrays by where they begin

/** Float32 numbers of the page, coded as coding.py says. */
function floats(place) {
  if (!known.has(place.at)) known.set(place.at, place.steps ? summed(place) : plain(place));
  return known.get(place.at);
}

function plain({ at, rows, width }) {
  return new Float32Array(block.slice(at, at + 4 * rows * width).buffer);
}

/** Numbers from their second differences over the rows, and over every third column. */
function summed({ at, rows, width, steps, along, bytes }) {
  const count = rows * width, found = new Float32Array(count), now = new Float64Array(count);
  for (let i = 0; i < count; i++) {
    let x = 0;
    for (let k = bytes - 1; k >= 0; k--) x = 256 * x + block[at + k * count + i];
    now[i] = x % 2 ? -(x + 1) / 2 : x / 2;
  }
  for (let c = 0; c < count; c += rows) sums(now, c, 1, rows);
  if (along) for (let c = 0; c < 3; c++) for (let r = 0; r < rows; r++) sums(now, c * rows + r, 3 * rows, width / 3);
  for (let c = 0; c < width; c++)
    for (let r = 0; r < rows; r++) found[r * width + c] = now[c * rows + r] * steps[c % steps.length];
  return found;
}

/** Twice the sums of `count` numbers from `first`, every `step`. */
function sums(numbers, first, step, count) {
  let rate = 0, value = 0;
  for (let i = 0, k = first; i < count; i++, k += step) numbers[k] = value += rate += numbers[k];
}

/** Numbers over the frames, `width` of them in each; a single frame if they never change. */
class Track {
  constructor(text, width, modes) {
    this.all = floats(text);
    this.width = width;
    this.moving = this.all.length > width;
    this.modes = modes ? floats(modes) : null; // real and imaginary parts of each mode, unit amplitude
    this.now = new Float32Array(width);
  }

  /** Whether the numbers differ from those at the last call. */
  changes(instant) {
    if (this.modes) return true;
    const key = this.moving ? instant.frame + instant.fraction : 0;
    const changed = key !== this.key;
    this.key = key;
    return changed;
  }

  /** Numbers at an instant; poses have their quaternion in places 3 to 6. */
  at(instant, pose = false) {
    const { all, width, now } = this, a = this.moving ? instant.frame * width : 0;
    if (this.moving && instant.fraction > 0) {
      const b = a + width, f = instant.fraction;
      let sign = 1;
      if (pose) {
        let dot = 0;
        for (let i = 3; i < 7; i++) dot += all[a + i] * all[b + i];
        sign = dot < 0 ? -1 : 1;
      }
      for (let i = 0; i < width; i++) now[i] = (1 - f) * all[a + i] + f * (pose && i > 2 ? sign : 1) * all[b + i];
    } else {
      for (let i = 0; i < width; i++) now[i] = all[a + i];
    }
    if (this.modes && instant.mode >= 0) {
      const re = 2 * width * instant.mode, im = re + width;
      const c = instant.amplitude * Math.cos(instant.phase), s = instant.amplitude * Math.sin(instant.phase);
      for (let i = 0; i < width; i++) now[i] += c * this.modes[re + i] - s * this.modes[im + i];
    }
    if (pose) {
      const n = Math.hypot(now[3], now[4], now[5], now[6]);
      for (let i = 3; i < 7; i++) now[i] /= n;
    }
    return now;
  }
}

/** Amplitudes of values in the modes, `width` in each: those at unit amplitude times the one that is shown. */
class Modal {
  constructor(text, width) {
    this.all = floats(text);
    this.now = new Float32Array(width);
  }

  at(instant) {
    const a = this.now.length * instant.mode;
    for (let i = 0; i < this.now.length; i++) this.now[i] = instant.amplitude * this.all[a + i];
    return this.now;
  }
}

/** Frame and fraction of a time. */
function locate(t) {
  const times = scene.times;
  let low = 0, high = times.length - 1;
  if (high < 1 || t <= times[0]) return { frame: 0, fraction: 0 };
  if (t >= times[high]) return { frame: high, fraction: 0 };
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle;
    else high = middle;
  }
  return { frame: low, fraction: (t - times[low]) / (times[high] - times[low]) };
}

/** A number as text, short. */
function short(x) {
  return x !== 0 && (Math.abs(x) < 1e-3 || Math.abs(x) >= 1e5) ? x.toExponential(2) : String(+x.toPrecision(3));
}
