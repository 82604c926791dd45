// What lies under the pointer: the nearest part in the picture, its name and its values.

const NEAR = 9; // pixels
const WORDS = {
  joint: "point", fixed: "fixed point", mass: "mass centre", box: "body", rim: "wheel", spoke: "part of", valve: "spoke of",
  force: "force of", load: "load on", sketch: "outline on", solid: "solid on", ground: "surface of the", slide: "slider", spiral: "torsional spring",
};

/** Distance in pixels from p to the segment ab, and where along it the nearest place is; [x, y] each. */
function toSegment(p, a, b) {
  const dx = b[0] - a[0], dy = b[1] - a[1], l = dx * dx + dy * dy;
  const s = l ? Math.min(Math.max(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / l, 0), 1) : 0;
  return [Math.hypot(p[0] - a[0] - s * dx, p[1] - a[1] - s * dy), s];
}

class Hover {
  constructor(canvas, parts, orbit, root, instant) {
    Object.assign(this, { canvas, parts, orbit, root, instant, tip: get("tip") });
    const look = (e) => {
      if (e.pointerType === "mouse" && e.buttons) this.hide();
      else this.show(e);
    };
    canvas.addEventListener("pointermove", look);
    canvas.addEventListener("pointerdown", (e) => e.pointerType !== "mouse" && this.show(e));
    canvas.addEventListener("pointerleave", (e) => e.pointerType === "mouse" && this.hide());
  }

  hide() {
    this.tip.hidden = true;
  }

  show(e) {
    const box = this.canvas.getBoundingClientRect(), p = [e.clientX - box.left, e.clientY - box.top];
    const found = this.find(p, box);
    if (!found) return this.hide();
    this.tip.textContent = this.describe(found);
    this.tip.hidden = false;
    const width = this.tip.offsetWidth;
    this.tip.style.left = `${Math.min(p[0] + 14, box.width - width - 4)}px`;
    this.tip.style.top = `${p[1] > box.height - 90 ? p[1] - 14 - this.tip.offsetHeight : p[1] + 14}px`;
  }

  /** The nearest part within reach; marks before lines, lines before solids. */
  find(p, box) {
    const now = this.instant(), M = new THREE.Matrix4().multiplyMatrices(this.orbit.camera.projectionMatrix, this.orbit.camera.matrixWorldInverse);
    M.multiply(this.root.matrixWorld);
    const v = new THREE.Vector4(), pixels = (points, i) => {
      v.set(points[i], points[i + 1], points[i + 2], 1).applyMatrix4(M);
      return [(v.x / v.w / 2 + 0.5) * box.width, (0.5 - v.y / v.w / 2) * box.height, v.w];
    };
    const scale = box.height / 2 / Math.tan((FIELD * Math.PI) / 360);
    let best = null, least = NEAR;
    for (const part of this.parts) {
      if (!part.visible || part.bounds || part.spec.style === "box") continue;
      const points = part.places(now), before = !(part instanceof Mark) ? 0 : part.spec.style === "mass" ? 4 : 5;
      let k = 0;
      for (const n of part.counts)
        for (let i = 0; i < n; i++, k++) {
          if (i === 0 && n > 1) continue;
          const b = pixels(points, 3 * k), a = n > 1 ? pixels(points, 3 * k - 3) : b, [d, s] = toSegment(p, a, b);
          const far = d - (part.radius * scale) / Math.max(b[2], 1e-9) - before;
          if (b[2] > 0 && far < least) [best, least] = [{ part, now, x: n > 1 ? (i - 1 + s) / (n - 1) : 0 }, far];
        }
    }
    return best || this.solid(p, box, now);
  }

  /** The solid or body whose bounds the line of sight meets first. */
  solid(p, box, now) {
    const ray = new THREE.Raycaster(), inverse = this.root.matrixWorld.clone().invert(), at = new THREE.Vector3();
    ray.setFromCamera(new THREE.Vector2((2 * p[0]) / box.width - 1, 1 - (2 * p[1]) / box.height), this.orbit.camera);
    const sight = ray.ray.clone().applyMatrix4(inverse);
    let best = null, least = Infinity;
    for (const part of this.parts) {
      if (!part.visible || !part.bounds) continue;
      const local = sight.clone().applyMatrix4(poseMatrix(part.track.at(now, true)).clone().invert());
      const far = local.intersectBox(part.bounds, at) ? at.distanceTo(local.origin) : Infinity;
      if (far < least) [best, least] = [{ part, now, x: 0 }, far];
    }
    return best;
  }

  describe({ part, now, x }) {
    const { spec } = part, lines = [`${WORDS[spec.style] || spec.style} ${spec.name}`];
    if (part instanceof Mark) {
      const z = [...part.track.at(now)].map((c) => short(Math.abs(c) < 1e-7 * scene.size ? 0 : c));
      lines.push(`at ${z.join(", ")} m`);
    }
    if (part.force) lines.push(`${short(Math.hypot(...part.force.at(now)))} N`);
    for (const [name, track] of Object.entries(part.values))
      lines.push(`${name} ${level(name, valueAt(track.at(now), x))}${unitOf(name)}`);
    return lines.join("\n");
  }
}
