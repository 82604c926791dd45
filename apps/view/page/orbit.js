// The eye: turns about a target by mouse, touch and keys.

const FIELD = 35; // of view, in degrees

class Orbit {
  constructor(canvas, changed) {
    this.camera = new THREE.PerspectiveCamera(FIELD, 1, 0.01, 100);
    this.camera.up.set(0, 0, 1);
    this.base = new THREE.Vector3(); // what is followed, or the middle of the model
    this.shift = new THREE.Vector3(); // moved by the user
    this.pointers = new Map();
    this.changed = changed;
    canvas.addEventListener("pointerdown", (e) => {
      canvas.setPointerCapture(e.pointerId);
      this.pointers.set(e.pointerId, e);
    });
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, (e) => this.pointers.delete(e.pointerId));
    canvas.addEventListener("pointermove", (e) => this.drag(e, canvas));
    canvas.addEventListener("contextmenu", (e) => e.preventDefault());
    canvas.addEventListener("wheel", (e) => {
      e.preventDefault();
      this.zoom(Math.exp(Math.sign(e.deltaY) * Math.min(Math.abs(e.deltaY), 100) * 0.0015));
    }, { passive: false });
    canvas.addEventListener("keydown", (e) => this.key(e));
  }

  look(azimuth, elevation, span) {
    this.azimuth = (azimuth * Math.PI) / 180;
    this.elevation = (elevation * Math.PI) / 180;
    if (span) {
      this.fits = false;
      this.span = span;
      this.shift.set(0, 0, 0);
    }
    this.changed();
  }

  /** Look from a direction, and at the next picture from where all is seen; also when the window changes. */
  fit(azimuth, elevation) {
    this.look(azimuth, elevation);
    this.fits = this.due = true;
  }

  /** Take the place that Fit has found. */
  take({ right, up, span }, aspect) {
    const m = this.camera.matrixWorld.elements;
    this.span = span;
    this.shift.set(0, 0, 0);
    this.shift.addScaledVector(new THREE.Vector3(m[0], m[1], m[2]), right);
    this.shift.addScaledVector(new THREE.Vector3(m[4], m[5], m[6]), up);
    this.place(aspect);
  }

  turn(right, up) {
    this.azimuth -= right;
    this.elevation = Math.min(Math.max(this.elevation + up, -1.57), 1.57);
    this.changed();
  }

  zoom(factor) {
    this.fits = false;
    this.span *= factor;
    this.changed();
  }

  /** Move the target by parts of the picture's height. */
  move(right, up) {
    this.fits = false;
    const m = this.camera.matrixWorld.elements;
    this.shift.addScaledVector(new THREE.Vector3(m[0], m[1], m[2]), -right * this.span);
    this.shift.addScaledVector(new THREE.Vector3(m[4], m[5], m[6]), up * this.span);
    this.changed();
  }

  drag(e, canvas) {
    const last = this.pointers.get(e.pointerId), h = canvas.clientHeight;
    if (!last) return;
    const dx = (e.clientX - last.clientX) / h, dy = (e.clientY - last.clientY) / h;
    if (this.pointers.size === 2) {
      const other = [...this.pointers.values()].find((pointer) => pointer.pointerId !== e.pointerId);
      const gap = (pointer) => Math.hypot(pointer.clientX - other.clientX, pointer.clientY - other.clientY) || 1;
      this.zoom(gap(last) / gap(e));
      this.move(dx / 2, dy / 2);
    } else if (e.shiftKey || e.buttons > 1) {
      this.move(dx, dy);
    } else {
      this.turn(4 * dx, 4 * dy);
    }
    this.pointers.set(e.pointerId, e);
  }

  key(e) {
    const acts = {
      ArrowLeft: () => this.turn(-0.1, 0), ArrowRight: () => this.turn(0.1, 0),
      ArrowUp: () => this.turn(0, -0.1), ArrowDown: () => this.turn(0, 0.1),
      "+": () => this.zoom(0.9), "=": () => this.zoom(0.9), "-": () => this.zoom(1 / 0.9),
    };
    if (!acts[e.key] || e.ctrlKey || e.metaKey || e.altKey) return;
    e.preventDefault();
    e.stopPropagation();
    acts[e.key]();
  }

  get target() {
    return this.base.clone().add(this.shift);
  }

  /** Place the camera so that the span fits both ways. */
  place(aspect) {
    const { camera, azimuth: a, elevation: b, target } = this;
    const d = this.span / 2 / Math.tan((FIELD * Math.PI) / 360) / Math.min(1, aspect);
    camera.aspect = aspect;
    camera.near = d / 100;
    camera.far = d * 30;
    // straight from above or below, `up` would be the direction of the eye
    const steep = Math.abs(b) > 1.56;
    camera.up.set(steep ? -Math.sign(b) * Math.cos(a) : 0, steep ? -Math.sign(b) * Math.sin(a) : 0, steep ? 0 : 1);
    camera.position.set(Math.cos(b) * Math.cos(a), Math.cos(b) * Math.sin(a), Math.sin(b)).multiplyScalar(d).add(target);
    camera.lookAt(target);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }
}
