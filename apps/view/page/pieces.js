// Parts that are not swept lines: marks, solids, springs, dampers and arrows.

/** A ready geometry as a piece of the solid batch. */
class Piece extends Part {
  get batch() {
    return this.batches.solid;
  }

  /** Take room for geometries; each has its own bone. */
  take(...geometries) {
    this.taken = geometries.map((geometry) => {
      const size = geometry.attributes.position.count, bone = this.batch.bone();
      const index = geometry.index ? geometry.index.array : Array.from({ length: size }, (_, i) => i);
      return { geometry, size, bone, at: this.batch.add(size, index, bone) };
    });
  }

  fill() {
    for (const { geometry, at } of this.taken) {
      this.batch.P.set(geometry.attributes.position.array, 3 * at);
      this.batch.N.set(geometry.attributes.normal.array, 3 * at);
      geometry.dispose();
    }
    this.paint(null);
  }

  paint(name, range, instant) {
    const values = name && this.values[name] ? this.values[name].at(instant) : null;
    const colour = values ? ramp(share(values[0], range)) : this.colour;
    for (const { at, size } of this.taken) this.batch.fill(at, size, colour);
  }

  update(instant) {
    if (this.shown === this.visible && !this.track.changes(instant)) return;
    this.shown = this.visible;
    this.place(instant);
    if (!this.visible) this.taken.forEach(({ bone }) => this.matrix(bone).copy(ZERO));
  }

  matrix(bone) {
    return this.batch.bones[bone].matrixWorld;
  }

  get radius() {
    return 0.01 * scene.size;
  }
}

/** A point, a fixed point or a mass centre. */
class Mark extends Piece {
  reserve() {
    const { style } = this.spec, r = MARKS[style] * scene.size;
    this.take(style === "fixed" ? new THREE.BoxGeometry(1.7 * r, 1.7 * r, 1.7 * r) : new THREE.SphereGeometry(r, 14, 10));
  }

  place(instant) {
    const now = this.track.at(instant);
    this.matrix(this.taken[0].bone).makeTranslation(now[0], now[1], now[2]);
  }
}

/** A surface of triangles that a body carries. */
class Solid extends Piece {
  reserve() {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(floats(this.spec.surface), 3));
    geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(bytes(this.spec.triangles).buffer), 1));
    const flat = geometry.toNonIndexed(); // every triangle has its own normal
    flat.computeVertexNormals();
    flat.computeBoundingBox();
    this.bounds = flat.boundingBox.clone();
    this.take(flat);
  }

  place(instant) {
    this.matrix(this.taken[0].bone).copy(poseMatrix(this.track.at(instant, true)));
  }
}

const X = new THREE.Vector3(1, 0, 0), from = new THREE.Vector3(), to = new THREE.Vector3(), way = new THREE.Quaternion();

/** The direction from the first to the second of two places as a rotation of the x axis; returns their distance. */
function between(now) {
  from.set(now[0], now[1], now[2]);
  to.set(now[3], now[4], now[5]).sub(from);
  const length = to.length();
  way.setFromUnitVectors(X, length ? to.divideScalar(length) : X);
  return length;
}

/** A coil between two places, drawn of unit length and stretched. */
class Coil extends Piece {
  reserve() {
    const turns = 8, steps = 97, r = 0.022 * scene.size, points = [0, 0, 0];
    for (let i = 0; i < steps; i++) {
      const x = i / (steps - 1), a = 2 * Math.PI * turns * x;
      points.push(0.1 + 0.8 * x, r * Math.cos(a), r * Math.sin(a));
    }
    points.push(1, 0, 0);
    const counts = [steps + 2], wire = sectionOf(round(0.0035 * scene.size).filter((_, i) => i % 2 === 0));
    const geometry = new THREE.BufferGeometry(), size = sweptSize(counts, wire);
    const P = new Float32Array(3 * size), N = new Float32Array(3 * size);
    // at about the length that it has, so that its wire is round there
    const now = this.track.at({ frame: 0, fraction: 0, mode: -1 });
    this.length = Math.max(Math.hypot(now[3] - now[0], now[4] - now[1], now[5] - now[2]), 1e-3 * scene.size);
    sweep(P, N, 0, counts, wire, Float32Array.from(points.map((x, i) => (i % 3 ? x : x * this.length))), null);
    geometry.setAttribute("position", new THREE.BufferAttribute(P, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(N, 3));
    geometry.setIndex(sweptIndex(counts, wire));
    this.take(geometry);
  }

  place(instant) {
    const length = between(this.track.at(instant));
    this.matrix(this.taken[0].bone).compose(from, way, moved.set(Math.max(length / this.length, 1e-6), 1, 1));
  }

  get radius() {
    return 0.025 * scene.size;
  }
}

/** A dashpot: a cylinder on the first place, a rod on the second. */
class Damper extends Piece {
  reserve() {
    const now = this.track.at({ frame: 0, fraction: 0, mode: -1 }), L = between(now) || 0.1 * scene.size;
    const pipe = (r, l, x) => new THREE.CylinderGeometry(r * scene.size, r * scene.size, l * L, 14).rotateZ(Math.PI / 2).translate(x * L, 0, 0);
    this.take(pipe(0.012, 0.45, 0.325), pipe(0.004, 0.2, 0.05), pipe(0.005, 0.65, -0.325));
  }

  place(instant) {
    between(this.track.at(instant));
    const now = this.track.now;
    for (const i of [0, 1]) this.matrix(this.taken[i].bone).compose(from, way, unscaled);
    this.matrix(this.taken[2].bone).compose(moved.set(now[3], now[4], now[5]), way, unscaled);
  }
}

/** A force as an arrow that points away from its place. */
class Arrow extends Piece {
  reserve() {
    this.force = new Track(this.spec.force, 3);
    const shaft = new THREE.CylinderGeometry(0.02, 0.02, 0.8, 12).rotateZ(-Math.PI / 2).translate(0.4, 0, 0);
    const head = new THREE.ConeGeometry(0.06, 0.2, 16).rotateZ(-Math.PI / 2).translate(0.9, 0, 0);
    this.take(shaft, head);
  }

  /** Largest force of all frames. */
  get largest() {
    let found = 0;
    const all = this.force.all;
    for (let i = 0; i < all.length; i += 3) found = Math.max(found, Math.hypot(all[i], all[i + 1], all[i + 2]));
    return found;
  }

  update(instant) {
    const now = this.track.at(instant), f = this.force.at(instant), size = Math.hypot(f[0], f[1], f[2]);
    const length = (Arrow.reach * scene.size * size) / (Arrow.unit || 1);
    from.set(now[0], now[1], now[2]);
    if (size > 0) way.setFromUnitVectors(X, to.set(f[0] / size, f[1] / size, f[2] / size));
    const seen = this.visible && length > 1e-6 * scene.size;
    for (const { bone } of this.taken)
      if (seen) this.matrix(bone).compose(from, way, moved.set(length, length, length));
      else this.matrix(bone).copy(ZERO);
  }

  paint() {
    for (const { at, size } of this.taken) this.batch.fill(at, size, this.colour);
  }

  get counts() {
    return [2];
  }

  /** Both ends of the arrow. */
  places(instant) {
    const a = this.track.at(instant), f = this.force.at(instant), scale = (Arrow.reach * scene.size) / (Arrow.unit || 1);
    return Float32Array.of(a[0], a[1], a[2], a[0] + scale * f[0], a[1] + scale * f[1], a[2] + scale * f[2]);
  }
}
Arrow.reach = 0.35; // of the largest force, relative to the model; changed by a slider

const KINDS = { force: Arrow, load: Arrow, spring: Coil, damper: Damper, solid: Solid, ground: Solid, joint: Mark, fixed: Mark, mass: Mark };

/** All parts of the scene, and the meshes that draw them. */
function makeParts() {
  const batches = makeBatches();
  const parts = scene.shapes.map((spec) => new (KINDS[spec.style] || Part)(spec, batches));
  const all = Object.values(batches);
  all.forEach((batch) => batch.allocate());
  parts.forEach((part) => part.fill());
  Arrow.unit = Math.max(0, ...parts.filter((part) => part instanceof Arrow).map((arrow) => arrow.largest));
  return { parts, batches: all, meshes: all.map((batch) => batch.finish()).filter(Boolean) };
}
