// Fit: the nearest place of the eye from which all that is visible lies in the picture, over the whole motion.

const SAMPLES = 16; // frames of a motion that are looked at
const MARGIN = 1.06;
const UNMOVED = new Set(["fixed", "guide"]); // left behind by what is followed

/** Instants over the whole motion, or over a period of the mode that is shown. */
function samples(now) {
  const n = scene.times.length, count = scene.modes.length ? 4 : Math.min(SAMPLES, n);
  return Array.from({ length: count }, (_, i) =>
    scene.modes.length ? { ...now, phase: (i * Math.PI) / 2 } : { frame: Math.round((i * (n - 1)) / Math.max(count - 1, 1)), fraction: 0, mode: -1 },
  );
}

/** Vertices of a part that tell how far it reaches. */
function outermost(part, instant) {
  if (!part.bounds) return part.places(instant);
  const M = poseMatrix(part.track.at(instant, true)), { min, max } = part.bounds, found = [], v = new THREE.Vector3();
  for (const x of [min.x, max.x])
    for (const y of [min.y, max.y])
      for (const z of [min.z, max.z]) found.push(...v.set(x, y, z).applyMatrix4(M));
  return found;
}

/**
 * The place of the eye for its present direction: how far to shift its target sideways and up from what it follows, and
 * the span at that distance. With the eye at distance d, a point (x, y, z) in its axes is seen if |x| <= t (d - z).
 */
function fitted(parts, orbit, root, followed, now, aspect) {
  const t = Math.tan((FIELD * Math.PI) / 360), tx = t * aspect, m = orbit.camera.matrixWorld.elements;
  const q = root.quaternion.clone().invert(), axis = (i) => new THREE.Vector3(m[i], m[i + 1], m[i + 2]).applyQuaternion(q);
  const [r, u, f] = [axis(0), axis(4), axis(8)], most = [-Infinity, -Infinity, -Infinity, -Infinity];
  const base = new THREE.Vector3(...scene.camera.centre), v = new THREE.Vector3();
  for (const instant of samples(now)) {
    if (followed) base.fromArray(followed.track.at(instant));
    for (const part of parts) {
      if (!part.visible || part instanceof Arrow || part.spec.style === "ground") continue;
      if (followed && UNMOVED.has(part.spec.style)) continue;
      const points = outermost(part, instant), extra = part.radius;
      for (let i = 0; i < points.length; i += 3) {
        v.set(points[i], points[i + 1], points[i + 2]).sub(base);
        const x = v.dot(r), y = v.dot(u), z = v.dot(f) + extra;
        most[0] = Math.max(most[0], z + (x + extra) / tx);
        most[1] = Math.max(most[1], z - (x - extra) / tx);
        most[2] = Math.max(most[2], z + (y + extra) / t);
        most[3] = Math.max(most[3], z - (y - extra) / t);
      }
    }
  }
  if (!most.every(Number.isFinite)) return null;
  const d = MARGIN * Math.max(most[0] + most[1], most[2] + most[3]) / 2;
  return { right: (tx * (most[0] - most[1])) / 2, up: (t * (most[2] - most[3])) / 2, span: 2 * t * d * Math.min(1, aspect) };
}
