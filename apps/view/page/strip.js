// The plot strip: histories of chosen quantities below the picture, one row for each unit, with a cursor at the time.
// It looks like the figures: colours, grid, axes on two sides, and quantity with unit at each axis.

const ROWS = 4; // units at most
const BELOW = 18, ABOVE = 15, RIGHT = 8; // room for the times, for a row's label, beside the axes [pixels]

/** Round values between two limits, about so many, each with its text. */
function ticks(low, high, count) {
  const raw = (high - low) / count, power = 10 ** Math.floor(Math.log10(raw)), step = power * [1, 2, 5, 10].find((multiple) => multiple * power >= 0.999 * raw);
  const largest = Math.max(Math.abs(low), Math.abs(high)), place = Math.floor(Math.log10(step) + 1e-9);
  const written = (v) => {
    if (largest < 1e5 && step > 0.9e-3) return v.toFixed(Math.max(0, -place));
    return v === 0 ? "0" : v.toExponential(Math.max(0, Math.floor(Math.log10(Math.abs(v)) + 1e-9) - place));
  };
  const found = [];
  for (let k = Math.ceil(low / step - 1e-6); k <= high / step + 1e-6; k++) found.push([k * step, written(k * step).replaceAll("-", "−")]);
  return found;
}

class Strip {
  constructor(go) {
    this.rows = scene.plots.rows.map((z) => ({ ...z, values: floats(z.values) }));
    this.rows.forEach((row) => (row.moving = row.values.length > 1));
    this.box = get("plots");
    this.canvas = get("strip");
    this.cursor = get("cursor");
    this.chosen = [];
    const seek = (e) => {
      const b = this.canvas.getBoundingClientRect(), x = (e.clientX - b.left - this.left) / (b.width - this.left - RIGHT);
      go(start + Math.min(Math.max(x, 0), 1) * (end - start));
    };
    this.canvas.addEventListener("pointerdown", (e) => {
      this.canvas.setPointerCapture(e.pointerId);
      seek(e);
    });
    this.canvas.addEventListener("pointermove", (e) => e.buttons && seek(e));
    this.left = 58;
  }

  /** Take other colours. */
  dress(colours) {
    this.colours = colours;
    this.colour();
    this.draw();
  }

  /** Colour the lines, and their marks in the key. */
  colour() {
    this.chosen.forEach((row, i) => {
      row.colour = `#${seen(scene.plots.colours[i % scene.plots.colours.length], this.colours).getHexString()}`;
      row.line.style.background = row.colour;
    });
  }

  choose(names) {
    this.chosen = this.rows.filter((row) => names.includes(row.name));
    this.units = [...new Set(this.chosen.map((row) => row.unit))].slice(0, ROWS);
    this.chosen = this.chosen.filter((row) => this.units.includes(row.unit));
    this.box.hidden = !this.chosen.length;
    this.canvas.style.height = `${BELOW + (this.units.length > 1 ? 84 * this.units.length : 120)}px`;
    this.canvas.setAttribute("aria-label", `Plot over ${scene.clock.name} of ${this.chosen.map((row) => row.name).join(", ")}`);
    const list = get("key");
    list.replaceChildren(...this.chosen.map((row) => {
      const item = document.createElement("span");
      row.line = document.createElement("i");
      row.text = document.createElement("span");
      item.append(row.line, row.text);
      return item;
    }));
    this.colour();
    this.draw();
  }

  value(row, instant) {
    if (!row.moving) return row.values[0];
    const a = row.values[instant.frame], b = row.values[Math.min(instant.frame + 1, row.values.length - 1)];
    return a + instant.fraction * (b - a);
  }

  draw() {
    const { canvas } = this, ratio = Math.min(devicePixelRatio, 2), width = canvas.clientWidth, height = canvas.clientHeight;
    if (!this.chosen.length || !width) return;
    canvas.width = ratio * width;
    canvas.height = ratio * height;
    const pen = canvas.getContext("2d"), each = (height - BELOW) / this.units.length;
    pen.scale(ratio, ratio);
    pen.font = "11px system-ui, sans-serif";
    pen.fillStyle = this.colours.text;
    this.x = (t) => this.left + ((t - start) / (end - start || 1)) * (width - this.left - RIGHT);
    const { unit } = scene.clock, name = unit ? `${scene.clock.name} [${unit}]` : scene.clock.name, room = width - RIGHT - pen.measureText(name).width - 8;
    const times = end > start ? ticks(start, end, Math.max(2, width / 75)) : [];
    for (const [t, text] of times) {
      pen.textAlign = t - start < 1e-6 * (end - start) ? "left" : "center";
      if (this.x(t) + pen.measureText(text).width / 2 < room) pen.fillText(text, this.x(t), height - 4);
    }
    pen.textAlign = "right";
    pen.fillText(name, width - RIGHT, height - 4);
    this.units.forEach((unit, i) => this.panel(pen, unit, i * each, each, width, times));
  }

  /** The range of the values of one row of the strip, with a margin. */
  limits(rows) {
    let low = Infinity, high = -Infinity;
    for (const { values } of rows)
      for (const v of values) {
        low = Math.min(low, v);
        high = Math.max(high, v);
      }
    const flat = high - low <= 1e-12 * Math.max(Math.abs(low), Math.abs(high), 1e-300);
    const margin = flat ? (Math.abs(low) || 1) / 2 : 0.05 * (high - low);
    return [low - margin, high + margin];
  }

  panel(pen, unit, top, height, width, times) {
    const rows = this.chosen.filter((row) => row.unit === unit), [low, high] = this.limits(rows);
    const upper = top + ABOVE, lower = top + height - 3, right = width - RIGHT;
    const y = (v) => lower - ((v - low) / (high - low)) * (lower - upper);
    const line = (colour, thick, places) => {
      pen.strokeStyle = colour;
      pen.lineWidth = thick;
      pen.beginPath();
      for (const [px, py] of places) pen.lineTo(px, py);
      pen.stroke();
    };
    pen.textAlign = "left";
    pen.fillText(rows.length > 1 ? rows[0].shared : rows[0].label, this.left, top + 10);
    for (const [t] of times) line(this.colours.lines, 0.8, [[this.x(t), upper], [this.x(t), lower]]);
    pen.textAlign = "right";
    for (const [v, text] of ticks(low, high, (lower - upper) / 17)) {
      line(this.colours.lines, 0.8, [[this.left, y(v)], [right, y(v)]]);
      pen.fillText(text, this.left - 4, Math.max(y(v) + 4, top + 10));
    }
    line(this.colours.text, 0.8, [[this.left, upper], [this.left, lower], [right, lower]]);
    for (const row of rows)
      line(row.colour, 1.6, Array.from(scene.times, (t, k) => [this.x(t), y(row.values[row.moving ? k : 0])]));
  }

  update(instant, t) {
    if (!this.chosen.length) return;
    if (this.canvas.clientWidth !== this.shown) {
      this.shown = this.canvas.clientWidth;
      this.draw();
    }
    this.cursor.style.transform = `translateX(${this.x ? this.x(t) : 0}px)`;
    for (const row of this.chosen) row.text.textContent = `${row.name} ${short(this.value(row, instant))}${row.unit ? ` ${row.unit}` : ""}`;
  }
}
