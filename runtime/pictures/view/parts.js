// The parts of the mechanism as three.js objects: swept lines, marks, arrows of forces, traces, and the road.

const THIN = { bar: 0.008, beam: 0.008, rope: 0.005, rim: 0.008, spoke: 0.0018, valve: 0.003, axle: 0.009, sketch: 0.005 };
const MARKS = { joint: 0.011, fixed: 0.014, mass: 0.014 }; // sizes relative to the model
const THINNEST = 0.0012;
const ARROW = 0.35; // length of the largest force, relative to the model
const RAMP = ["#440154", "#3b528b", "#21918c", "#5ec962", "#fde725"].map((c) => new THREE.Color(c));

/** Colour of a value between 0 and 1. */
function ramp(x, out) {
  const z = 4 * Math.min(Math.max(x, 0), 1), i = Math.min(Math.floor(z), 3);
  return out.copy(RAMP[i]).lerp(RAMP[i + 1], z - i);
}

/** One part; `object` is in the scene, `update` moves it. */
class Part {
  constructor(spec) {
    this.spec = spec;
    this.vertices = spec.counts.reduce((a, b) => a + b, 0);
    this.track = new Track(spec.data, spec.rigid ? 7 : 3 * this.vertices, spec.modes);
    this.colour = new THREE.Color(scene.colours[spec.style]);
    this.object = new THREE.Group();
    this.object.name = spec.name;
    this.values = Object.fromEntries(Object.entries(spec.values).map(([k, v]) => [k, new Track(v.data, v.count)]));
    this.build();
  }

  build() {
    const { spec } = this;
    let outline = spec.outline || round((THIN[spec.style] || 0.006) * scene.size);
    const widest = Math.max(...outline.map((p) => Math.hypot(...p))), least = THINNEST * scene.size;
    if (widest < least) outline = outline.map((p) => p.map((x) => (x * least) / widest));
    this.outline = outline;
    this.across = spec.across ? new Track(spec.across, 6) : null;
    this.geometry = sweepGeometry(spec.counts, outline);
    const seeThrough = spec.style === "box";
    const material = new THREE.MeshLambertMaterial({
      vertexColors: true, flatShading: !isRound(outline), side: THREE.DoubleSide,
      transparent: seeThrough, opacity: seeThrough ? 0.22 : 1, depthWrite: !seeThrough,
    });
    this.mesh = new THREE.Mesh(this.geometry, material);
    this.mesh.frustumCulled = false; // its bounds change with every frame
    this.object.add(this.mesh);
    this.paint(null);
    if (spec.rigid) this.lay(floats(spec.local), 0);
    if (seeThrough) {
      const edges = new THREE.EdgesGeometry(this.geometry, 20);
      this.object.add(new THREE.LineSegments(edges, new THREE.LineBasicMaterial({ color: this.colour })));
    }
  }

  lay(points, instant) {
    const across = this.across && (this.spec.rigid ? this.across.all : this.across.at(instant));
    sweep(this.geometry, this.spec.counts, this.outline, points, across);
  }

  update(instant) {
    const now = this.track.at(instant, this.spec.rigid);
    if (this.spec.rigid) {
      this.object.position.set(now[0], now[1], now[2]);
      this.object.quaternion.set(now[4], now[5], now[6], now[3]);
    } else {
      this.lay(now, instant);
    }
  }

  /** Colour by a value over its range, or by style. */
  paint(name, range, instant) {
    const colours = this.geometry.attributes.color, m = this.outline.length, c = new THREE.Color();
    const values = name && this.values[name] ? this.values[name].at(instant) : null;
    let vertex = 0;
    const at = (s) => {
      if (!values) return name ? c.set("#c3ccd4") : c.copy(this.colour);
      const z = s * (values.length - 1), i = Math.min(Math.floor(z), Math.max(values.length - 2, 0));
      const value = values[i] + (z - i) * ((values[i + 1] ?? values[i]) - values[i]);
      return ramp((value - range[0]) / (range[1] - range[0] || 1), c);
    };
    const fill = (s) => {
      at(s);
      for (let j = 0; j < m; j++) c.toArray(colours.array, 3 * vertex++);
    };
    for (const n of this.spec.counts) {
      for (let i = 0; i < n; i++) fill(i / Math.max(n - 1, 1));
      fill(0);
      fill(1);
    }
    colours.needsUpdate = true;
  }
}

/** A point, a fixed point or a mass centre. */
class Mark extends Part {
  build() {
    const { style } = this.spec, r = MARKS[style] * scene.size;
    const shape = style === "fixed" ? new THREE.BoxGeometry(1.7 * r, 1.7 * r, 1.7 * r) : new THREE.SphereGeometry(r, 16, 12);
    this.object.add(new THREE.Mesh(shape, new THREE.MeshLambertMaterial({ color: this.colour })));
  }

  update(instant) {
    this.object.position.fromArray(this.track.at(instant));
  }

  paint() {}
}

/** A force as an arrow that points away from its place. */
class Arrow extends Part {
  build() {
    this.force = new Track(this.spec.force, 3);
    const material = new THREE.MeshLambertMaterial({ color: this.colour });
    const shaft = new THREE.CylinderGeometry(0.02, 0.02, 0.8, 12).translate(0, 0.4, 0);
    const head = new THREE.ConeGeometry(0.06, 0.2, 16).translate(0, 0.9, 0);
    this.object.add(new THREE.Mesh(shaft, material), new THREE.Mesh(head, material));
  }

  /** Largest force of all frames. */
  get largest() {
    let found = 0;
    for (let i = 0; i < this.force.all.length; i += 3) found = Math.max(found, Math.hypot(...this.force.all.subarray(i, i + 3)));
    return found;
  }

  update(instant) {
    const force = new THREE.Vector3(...this.force.at(instant)), size = force.length();
    this.object.position.fromArray(this.track.at(instant));
    const length = (ARROW * scene.size * size) / (Arrow.unit || 1);
    this.object.children.forEach((z) => (z.visible = length > 1e-6 * scene.size));
    this.object.scale.setScalar(Math.max(length, 1e-9));
    if (size > 0) this.object.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), force.divideScalar(size));
  }

  paint() {}
}

/** All parts of the scene. */
function makeParts() {
  const parts = scene.shapes.map((spec) => new (spec.style === "force" ? Arrow : MARKS[spec.style] ? Mark : Part)(spec));
  Arrow.unit = Math.max(0, ...parts.filter((z) => z instanceof Arrow).map((z) => z.largest));
  return parts;
}

/** The past track of a point. */
class Trace {
  constructor(part, colour) {
    const n = scene.times.length;
    this.part = part;
    this.geometry = new THREE.BufferGeometry();
    this.geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(3 * (n + 1)), 3));
    this.line = new THREE.Line(this.geometry, new THREE.LineBasicMaterial({ color: colour }));
    this.line.frustumCulled = false;
  }

  update(instant) {
    const { track } = this.part, P = this.geometry.attributes.position, k = instant.frame;
    if (track.moving) P.array.set(track.all.subarray(0, 3 * (k + 1)));
    P.array.set(track.at(instant), track.moving ? 3 * (k + 1) : 0);
    P.needsUpdate = true;
    this.geometry.setDrawRange(0, track.moving ? k + 2 : 1);
  }
}

/** A grid on a road: round steps fixed to the ground, wherever one looks. */
class Road {
  constructor(spec) {
    this.T = new THREE.Matrix4().makeBasis(...spec.axes.map((row) => new THREE.Vector3(...row)));
    this.height = spec.height;
    this.object = new THREE.Group();
    this.object.matrixAutoUpdate = false;
    this.step = 0;
  }

  update(target, span) {
    const power = 10 ** Math.floor(Math.log10(span / 4)), half = 20;
    const step = power * [1, 2, 5].findLast((z) => power * z <= span / 4);
    if (step !== this.step) {
      this.step = step;
      this.object.clear();
      const grid = new THREE.GridHelper(2 * half * step, 2 * half, "#c3ccd4", "#c3ccd4").rotateX(Math.PI / 2);
      const plane = new THREE.Mesh(
        new THREE.PlaneGeometry(2 * half * step, 2 * half * step),
        new THREE.MeshBasicMaterial({ color: "#e9edf0", side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }),
      );
      this.object.add(grid, plane);
    }
    const local = target.clone().applyMatrix4(this.T.clone().transpose());
    const place = new THREE.Vector3(Math.round(local.x / step) * step, Math.round(local.y / step) * step, this.height);
    this.object.matrix.copy(this.T).setPosition(place.applyMatrix4(this.T));
  }
}
