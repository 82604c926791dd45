// The parts of the mechanism: swept lines, marks, solids, springs and arrows, each a piece of a batch.

const THIN = {
  bar: 0.008, beam: 0.008, rope: 0.005, rim: 0.008, spoke: 0.0018, valve: 0.003, axle: 0.009, sketch: 0.005, spiral: 0.0025,
};
const MARKS = { joint: 0.011, fixed: 0.014, mass: 0.014 }; // sizes relative to the model
const THINNEST = 0.0012;
const GREY = new THREE.Color("#c3ccd4");
const ZERO = new THREE.Matrix4().makeScale(0, 0, 0); // hides a rigid piece

/** Lines of two vertices each as the twelve edges of a swept box with an outline of four corners. */
function edgesOf(points, outline, across) {
  const P = new Float32Array(48), N = new Float32Array(48), section = sectionOf(outline), o = outline.length;
  sweep(P, N, 0, [2], { ...section, columns: Float32Array.from(outline.flatMap(([y, z]) => [y, z, 0, 0])) }, points, across);
  const found = [], at = (i) => P.subarray(3 * i, 3 * i + 3);
  for (let j = 0; j < o; j++) found.push(at(j), at((j + 1) % o), at(o + j), at(o + ((j + 1) % o)), at(j), at(o + j));
  return Float32Array.from(found.flatMap((z) => [...z]));
}

/** One part: `update` moves it, `paint` colours it; its pieces lie in batches. */
class Part {
  constructor(spec, batches) {
    this.spec = spec;
    this.batches = batches;
    this.visible = true;
    this.vertices = spec.counts.reduce((a, b) => a + b, 0);
    this.track = new Track(spec.data, spec.rigid ? 7 : 3 * this.vertices, spec.modes);
    this.dress(LIGHT);
    this.values = Object.fromEntries(
      Object.entries(spec.values).map(([k, v]) => [k, v.modal ? new Modal(v.modal, v.count) : new Track(v.data, v.count)]),
    );
    this.local = spec.rigid ? floats(spec.local) : null;
    this.across = spec.across ? new Track(spec.across, 6) : null;
    this.shown = null; // the visibility that is drawn
    this.reserve();
  }

  /** Take its colour on another background. */
  dress(colours) {
    const { colour, style } = this.spec;
    this.colour = seen(colour || scene.colours[style], colours);
  }

  get batch() {
    const { style, rigid, opacity } = this.spec;
    if (style === "box") return this.batches.glass;
    return opacity === undefined ? (rigid ? this.batches.solid : this.batches.soft) : veil(this.batches, opacity, rigid);
  }

  /** Take room in the batch. */
  reserve() {
    const { spec } = this;
    let outline = spec.outline || round((THIN[spec.style] || 0.006) * scene.size);
    const widest = Math.max(...outline.map((p) => Math.hypot(...p))), least = THINNEST * scene.size;
    if (widest < least) outline = outline.map((p) => p.map((x) => (x * least) / widest));
    this.section = sectionOf(outline);
    if (spec.rigid) this.bone = this.batch.bone();
    this.size = sweptSize(spec.counts, this.section);
    this.at = this.batch.add(this.size, sweptIndex(spec.counts, this.section), this.bone);
    if (spec.style === "box") this.reserveEdges(outline);
  }

  /** The edges of a see-through box, as thin lines of the solid batch. */
  reserveEdges(outline) {
    const thin = sectionOf(round(THINNEST * scene.size)), counts = Array(12).fill(2);
    const bone = this.batches.solid.bone(), points = edgesOf(this.local, outline, this.across?.all);
    const at = this.batches.solid.add(sweptSize(counts, thin), sweptIndex(counts, thin), bone);
    this.edges = { thin, counts, bone, points, at };
  }

  /** Fill what never changes. */
  fill() {
    if (this.spec.rigid) this.lay(this.local, this.across?.all);
    if (this.edges) {
      const { solid } = this.batches, { thin, counts, points, at } = this.edges;
      sweep(solid.P, solid.N, at, counts, thin, points, null);
      solid.fill(at, sweptSize(counts, thin), this.colour);
    }
    this.paint(null);
  }

  lay(points, across) {
    sweep(this.batch.P, this.batch.N, this.at, this.spec.counts, this.section, points, across);
    this.batch.moved = true;
  }

  update(instant) {
    const changed = this.shown !== this.visible;
    if (!changed && !this.track.changes(instant) && !this.across?.changes(instant)) return;
    this.shown = this.visible;
    if (this.spec.rigid) {
      this.pose(this.visible ? poseMatrix(this.track.at(instant, true)) : ZERO);
    } else if (this.visible) {
      this.lay(this.track.at(instant), this.across?.at(instant));
    } else {
      this.batch.P.fill(0, 3 * this.at, 3 * (this.at + this.size));
      this.batch.moved = true;
    }
  }

  pose(matrix) {
    this.batch.bones[this.bone].matrixWorld.copy(matrix);
    if (this.edges) this.batches.solid.bones[this.edges.bone].matrixWorld.copy(matrix);
  }

  /** Colour by a value over its range, or by style. */
  paint(name, range, instant) {
    const values = name && this.values[name] ? this.values[name].at(instant) : null;
    const batch = this.batch, w = this.section.columns.length / 4, m = this.section.outline.length / 2;
    if (!values || values.length === 1) {
      const colour = values ? ramp(share(values[0], range)) : name && this.spec.style !== "solid" ? GREY : this.colour;
      batch.fill(this.at, this.size, colour);
      return;
    }
    let vertex = this.at;
    for (const n of this.spec.counts) {
      for (let i = 0; i < n; i++, vertex += w) batch.fill(vertex, w, ramp(share(valueAt(values, i / Math.max(n - 1, 1)), range)));
      batch.fill(vertex, m, ramp(share(values[0], range)));
      batch.fill(vertex + m, m, ramp(share(values[values.length - 1], range)));
      vertex += 2 * m;
    }
  }

  /** Vertices of its lines at an instant, relative to the root of the scene; those of rigid parts are turned and moved. */
  places(instant) {
    const now = this.track.at(instant, this.spec.rigid);
    if (!this.spec.rigid) return now;
    const M = poseMatrix(now), out = new Float32Array(this.local), v = new THREE.Vector3();
    for (let i = 0; i < out.length; i += 3) v.fromArray(out, i).applyMatrix4(M).toArray(out, i);
    return out;
  }

  /** Vertices of each of these lines. */
  get counts() {
    return this.spec.counts;
  }

  /** Half the thickness of what is drawn. */
  get radius() {
    return this.section.widest;
  }
}

/** A value between the equal steps along a line, x from 0 to 1. */
function valueAt(values, x) {
  const z = x * (values.length - 1), i = Math.min(Math.floor(z), Math.max(values.length - 2, 0));
  return values[i] + (z - i) * ((values[i + 1] ?? values[i]) - values[i]);
}

const posed = new THREE.Matrix4(), turned = new THREE.Quaternion(), moved = new THREE.Vector3(), unscaled = new THREE.Vector3(1, 1, 1);

/** Matrix of a place and a quaternion; the same object at every call. */
function poseMatrix(now) {
  return posed.compose(moved.set(now[0], now[1], now[2]), turned.set(now[4], now[5], now[6], now[3]), unscaled);
}
