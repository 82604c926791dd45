// What lies under the mechanism: roads and a floor with a grid and shadows; and the tracks of points.

/** Lines of a grid, each of short pieces: software that draws without a graphics card omits lines that reach behind the eye. */
function gridOf(half, step, colour) {
  const places = [];
  for (let i = -half; i <= half; i++)
    for (let j = -half; j < half; j++) places.push(i, j, 0, i, j + 1, 0, j, i, 0, j + 1, i, 0);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(places.map((place) => place * step), 3));
  return new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color: colour }));
}

/** A grid on a road or floor: round steps fixed to the ground, wherever one looks. */
class Road {
  constructor(spec) {
    this.T = new THREE.Matrix4().makeBasis(...spec.axes.map((row) => new THREE.Vector3(...row)));
    this.back = this.T.clone().transpose();
    this.height = spec.height;
    this.object = new THREE.Group();
    this.object.matrixAutoUpdate = false;
    this.step = 0;
  }

  /** Take other colours at the next picture. */
  dress(colours) {
    this.colours = colours;
    this.step = 0;
  }

  update(target, span) {
    const power = 10 ** Math.floor(Math.log10(span / 4)), half = 20;
    const step = power * [1, 2, 5].findLast((multiple) => power * multiple <= span / 4);
    if (step !== this.step) {
      this.step = step;
      this.object.children.forEach((child) => child.geometry.dispose());
      this.object.clear();
      const grid = gridOf(half, step, this.colours.grid);
      const sheet = new THREE.PlaneGeometry(2 * half * step, 2 * half * step);
      const offset = { side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
      const plane = new THREE.Mesh(sheet, new THREE.MeshBasicMaterial({ color: this.colours.sheet, ...offset }));
      const shade = new THREE.Mesh(sheet, new THREE.ShadowMaterial({ opacity: 0.28, side: THREE.DoubleSide }));
      shade.receiveShadow = true;
      this.object.add(plane, grid, shade);
    }
    const local = target.clone().applyMatrix4(this.back);
    const place = new THREE.Vector3(Math.round(local.x / step) * step, Math.round(local.y / step) * step, this.height);
    this.object.matrix.copy(this.T).setPosition(place.applyMatrix4(this.T));
  }
}

/** Write how long a round length is in the picture, at the distance of what the eye looks at. */
function tellScale(span, aspect) {
  const metre = (canvas.clientHeight * Math.min(1, aspect)) / span; // pixels
  const wanted = 110 / metre, power = 10 ** Math.floor(Math.log10(wanted));
  const length = power * [1, 2, 5].findLast((multiple) => power * multiple <= wanted);
  get("length").textContent = `${short(length)} m`;
  get("bar").style.width = `${length * metre}px`;
}

/** The past tracks of points, all in one line object: segments in the order of the frames. */
class Traces {
  constructor() {
    this.geometry = new THREE.BufferGeometry();
    this.line = new THREE.LineSegments(this.geometry, new THREE.LineBasicMaterial({ vertexColors: true }));
    this.line.frustumCulled = false;
    this.parts = [];
  }

  choose(parts, colours) {
    this.parts = parts;
    const frames = scene.times.length, n = parts.length;
    const P = new Float32Array(6 * n * frames), C = new Float32Array(6 * n * frames);
    parts.forEach(({ track }, i) => {
      const { r, g, b } = new THREE.Color(colours[i % colours.length]);
      const at = (k) => track.all.subarray(track.moving ? 3 * k : 0, track.moving ? 3 * k + 3 : 3);
      for (let k = 0; k < frames; k++) {
        P.set(at(k), 6 * (k * n + i));
        P.set(at(Math.min(k + 1, frames - 1)), 6 * (k * n + i) + 3);
        C.set([r, g, b, r, g, b], 6 * (k * n + i));
      }
    });
    this.geometry.dispose();
    this.geometry.setAttribute("position", new THREE.BufferAttribute(P, 3));
    this.geometry.setAttribute("color", new THREE.BufferAttribute(C, 3));
    this.line.visible = n > 0;
    this.last = -1;
  }

  update(instant) {
    const n = this.parts.length, k = instant.frame, P = this.geometry.attributes.position;
    if (!n) return;
    if (this.last >= 0 && this.last !== k) this.lay(this.last, (part) => part.track.all.subarray(3 * this.last + 3, 3 * this.last + 6));
    this.last = k < scene.times.length - 1 ? k : -1;
    if (this.last >= 0) this.lay(k, (part) => part.track.at(instant)); // the segment that is being drawn
    P.needsUpdate = true;
    this.geometry.setDrawRange(0, 2 * n * (this.last >= 0 ? k + 1 : k));
  }

  lay(k, end) {
    const n = this.parts.length;
    this.parts.forEach((part, i) => {
      if (part.track.moving) this.geometry.attributes.position.array.set(end(part), 6 * (k * n + i) + 3);
    });
  }
}

/** Light from above that casts shadows around the target. */
function placeSun(sun, target, span) {
  sun.position.set(0.35, -0.5, 1.2).multiplyScalar(1.5 * span).add(target);
  sun.target.position.copy(target);
  sun.target.updateMatrixWorld();
  const camera = sun.shadow.camera, half = 1.1 * span;
  if (camera.right === half) return;
  [camera.left, camera.right, camera.bottom, camera.top, camera.near, camera.far] = [-half, half, -half, half, 0.1 * span, 6 * span];
  sun.shadow.normalBias = 0.004 * span;
  camera.updateProjectionMatrix();
}
