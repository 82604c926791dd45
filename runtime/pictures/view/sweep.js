// A section swept along a polyline: the surface of beams, ropes, rims, pins, sheaves and boxes.

const CORNERS = 10;

/** Outline of a thin round line. */
function round(radius) {
  return Array.from({ length: CORNERS }, (_, i) => {
    const a = (2 * Math.PI * i) / CORNERS;
    return [radius * Math.cos(a), radius * Math.sin(a)];
  });
}

/** Whether an outline is a circle, to be shaded smoothly. */
function isRound(outline) {
  const r = outline.map((p) => Math.hypot(...p));
  return outline.length > 7 && Math.max(...r) - Math.min(...r) < 1e-6 * r[0];
}

/** Buffers for polylines with `counts` vertices each: all sides, then two caps a line. */
function sweepGeometry(counts, outline) {
  const m = outline.length, index = [];
  const caps = THREE.ShapeUtils.triangulateShape(outline.map((p) => new THREE.Vector2(...p)), []);
  let first = 0;
  for (const n of counts) {
    for (let i = 0; i + 1 < n; i++) {
      for (let j = 0; j < m; j++) {
        const a = first + i * m + j, b = first + i * m + ((j + 1) % m);
        index.push(a, b, a + m, b, b + m, a + m);
      }
    }
    const start = first + n * m, end = start + m;
    for (const [a, b, c] of caps) index.push(start + a, start + c, start + b, end + a, end + b, end + c);
    first = end + m;
  }
  const geometry = new THREE.BufferGeometry();
  for (const name of ["position", "normal", "color"])
    geometry.setAttribute(name, new THREE.BufferAttribute(new Float32Array(3 * first), 3));
  geometry.setIndex(index);
  return geometry;
}

/** Unit vector from vertex a to vertex b of a flat array into `out`; kept as it was where they coincide. */
function direction(points, a, b, out) {
  const d = [0, 1, 2].map((k) => points[3 * b + k] - points[3 * a + k]), n = Math.hypot(...d);
  if (n > 1e-12) for (let k = 0; k < 3; k++) out[k] = d[k] / n;
  return out;
}

/** The part of u normal to the unit vector t, as a unit vector; some normal of t if there is none. */
function normalTo(u, t) {
  const s = u[0] * t[0] + u[1] * t[1] + u[2] * t[2];
  const w = [u[0] - s * t[0], u[1] - s * t[1], u[2] - s * t[2]], n = Math.hypot(...w);
  if (n > 1e-9) return w.map((x) => x / n);
  const k = t.map(Math.abs).indexOf(Math.min(...t.map(Math.abs)));
  return normalTo([k === 0, k === 1, k === 2].map(Number), t);
}

function cross(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

/**
 * Lay the surface along the vertices `points`; `across` holds the directions of the section's y axis at both ends.
 */
function sweep(geometry, counts, outline, points, across) {
  const position = geometry.attributes.position, normal = geometry.attributes.normal, m = outline.length;
  const P = position.array, N = normal.array;
  let vertex = 0, first = 0;
  const put = (c, t, u, sideways) => {
    const w = cross(t, u);
    for (const [y, z] of outline) {
      const r = Math.hypot(y, z) || 1;
      for (let k = 0; k < 3; k++) {
        P[3 * vertex + k] = points[3 * c + k] + y * u[k] + z * w[k];
        N[3 * vertex + k] = sideways ? (y * u[k] + z * w[k]) / r : 0;
      }
      vertex++;
    }
  };
  const cap = (c, t, u, sign) => {
    const start = 3 * vertex;
    put(c, t, u, false);
    for (let i = 0; i < 3 * m; i++) N[start + i] = sign * t[i % 3];
  };
  for (const n of counts) {
    const closed = n > 3 && [0, 1, 2].every((k) => Math.abs(points[3 * first + k] - points[3 * (first + n - 1) + k]) < 1e-7);
    const ends = [];
    let t = [1, 0, 0], u = [0, 0, 0];
    for (let i = 0; i < n; i++) {
      const a = first + (i > 0 ? i - 1 : closed ? n - 2 : 0), b = first + (i + 1 < n ? i + 1 : closed ? 1 : n - 1);
      direction(points, a, b, t);
      if (across) u = [0, 1, 2].map((k) => across[k] + (i / Math.max(n - 1, 1)) * (across[3 + k] - across[k]));
      u = normalTo(u, t);
      put(first + i, t, u, true);
      if (i === 0 || i === n - 1) ends.push([first + i, [...t], u]);
    }
    cap(...ends[0], -1);
    cap(...ends[1], 1);
    first += n;
  }
  position.needsUpdate = normal.needsUpdate = true;
}
