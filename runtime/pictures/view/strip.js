// The plot strip: histories of chosen quantities below the picture, one row for each unit, with a cursor at the time.

const INKS = ["#0b5fa5", "#c8501e", "#2e8540", "#7b3f98", "#b8860b", "#c2255c"];
const ROWS = 4; // units at most

class Strip {
  constructor(go) {
    this.rows = scene.plots.rows.map((z) => ({ ...z, values: floats(z.values) }));
    this.rows.forEach((z) => (z.moving = z.values.length > 1));
    this.box = get("plots");
    this.canvas = get("strip");
    this.cursor = get("cursor");
    this.chosen = [];
    const seek = (e) => {
      const b = this.canvas.getBoundingClientRect(), x = (e.clientX - b.left - this.left) / (b.width - this.left - 8);
      go(start + Math.min(Math.max(x, 0), 1) * (end - start));
    };
    this.canvas.addEventListener("pointerdown", (e) => {
      this.canvas.setPointerCapture(e.pointerId);
      seek(e);
    });
    this.canvas.addEventListener("pointermove", (e) => e.buttons && seek(e));
    this.left = 58;
  }

  choose(names) {
    this.chosen = this.rows.filter((z) => names.includes(z.name));
    this.units = [...new Set(this.chosen.map((z) => z.unit))].slice(0, ROWS);
    this.chosen = this.chosen.filter((z) => this.units.includes(z.unit));
    this.box.hidden = !this.chosen.length;
    this.canvas.style.height = `${this.units.length > 1 ? 78 * this.units.length : 120}px`;
    this.canvas.setAttribute("aria-label", `Plot over time of ${this.chosen.map((z) => z.name).join(", ")}`);
    const list = get("key");
    list.replaceChildren(...this.chosen.map((z, i) => {
      const item = document.createElement("span");
      item.style.color = INKS[i % INKS.length];
      z.text = item;
      return item;
    }));
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
    const pen = canvas.getContext("2d"), each = (height - 18) / this.units.length;
    pen.scale(ratio, ratio);
    pen.font = "11px system-ui, sans-serif";
    this.x = (t) => this.left + ((t - start) / (end - start || 1)) * (width - this.left - 8);
    pen.fillStyle = "#4b545c";
    pen.textAlign = "center";
    for (const f of [0, 0.5, 1]) {
      pen.textAlign = ["left", "center", "right"][2 * f];
      pen.fillText(`${short(start + f * (end - start))} s`, this.x(start + f * (end - start)), height - 4);
    }
    this.units.forEach((unit, i) => this.panel(pen, unit, i * each, each, width));
  }

  panel(pen, unit, top, height, width) {
    const rows = this.chosen.filter((z) => z.unit === unit);
    let low = Infinity, high = -Infinity;
    for (const { values } of rows)
      for (const v of values) {
        low = Math.min(low, v);
        high = Math.max(high, v);
      }
    const flat = high - low <= 1e-12 * Math.max(Math.abs(low), Math.abs(high), 1e-300);
    if (flat) [low, high] = [low - (Math.abs(low) || 1) / 2, high + (Math.abs(high) || 1) / 2];
    const y = (v) => top + height - 6 - ((v - low) / (high - low)) * (height - 14);
    pen.strokeStyle = "#d0d7de";
    pen.strokeRect(this.left, top + 4, width - this.left - 8, height - 6);
    pen.fillStyle = "#4b545c";
    pen.textAlign = "right";
    pen.fillText(short(high), this.left - 4, top + 13);
    pen.fillText(short(low), this.left - 4, top + height - 4);
    pen.fillText(unit ? `[${unit}]` : "", this.left - 4, top + height / 2 + 4);
    pen.lineWidth = 1.5;
    for (const row of rows) {
      pen.strokeStyle = INKS[this.chosen.indexOf(row) % INKS.length];
      pen.beginPath();
      scene.times.forEach((t, k) => pen.lineTo(this.x(t), y(row.values[row.moving ? k : 0])));
      pen.stroke();
    }
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
