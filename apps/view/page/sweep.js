// A section swept along a polyline: the surface of beams, ropes, rims, pins, sheaves and boxes.

const CORNERS = 8;

/** Outline of a thin round line. */
function round(radius) {
  return Array.from({ length: CORNERS }, (_, i) => {
    const a = (2 * Math.PI * i) / CORNERS;
    return [radius * Math.cos(a), radius * Math.sin(a)];
  });
}

/** Whether an outline is a circle or close to it, to be shaded smoothly. */
function isRound(outline) {
  const r = outline.map((p) => Math.hypot(...p));
  return outline.length > 7 && Math.max(...r) < 1.2 * Math.min(...r);
}

/**
 * The columns of an outline: y, z and the normal of each. A round outline shares them between its sides; of a polygon
 * every side has its own two. `pairs` are the columns between which a side lies, `caps` the triangles of an end.
 */
function sectionOf(outline) {
  const m = outline.length, smooth = isRound(outline), columns = [], pairs = [];
  const area = outline.reduce((s, p, i) => s + p[0] * outline[(i + 1) % m][1] - p[1] * outline[(i + 1) % m][0], 0);
  outline.forEach(([y, z], i) => {
    const [y2, z2] = outline[(i + 1) % m], r = Math.hypot(y, z) || 1;
    if (smooth) {
      columns.push([y, z, y / r, z / r]);
      pairs.push([i, (i + 1) % m]);
    } else {
      const l = (Math.hypot(y2 - y, z2 - z) || 1) * Math.sign(area), n = [(z2 - z) / l, (y - y2) / l];
      columns.push([y, z, ...n], [y2, z2, ...n]);
      pairs.push([2 * i, 2 * i + 1]);
    }
  });
  const caps = THREE.ShapeUtils.triangulateShape(outline.map((p) => new THREE.Vector2(...p)), []);
  const widest = Math.max(...outline.map((p) => Math.hypot(...p)));
  return { outline: Float32Array.from(outline.flat()), columns: Float32Array.from(columns.flat()), pairs, caps, smooth, widest };
}

/** How many vertices polylines with `counts` vertices each need, swept with a section. */
function sweptSize(counts, section) {
  const w = section.columns.length / 4, m = section.outline.length / 2;
  return counts.reduce((s, n) => s + n * w + 2 * m, 0);
}

/** Triangles of swept polylines: all sides, then two caps a line. */
function sweptIndex(counts, section) {
  const w = section.columns.length / 4, m = section.outline.length / 2, index = [];
  let first = 0;
  for (const n of counts) {
    for (let i = 0; i + 1 < n; i++)
      for (const [a, b] of section.pairs) {
        const p = first + i * w + a, q = first + i * w + b;
        index.push(p, q, p + w, q, q + w, p + w);
      }
    const start = first + n * w, end = start + m;
    for (const [a, b, c] of section.caps) index.push(start + a, start + c, start + b, end + a, end + b, end + c);
    first = end + m;
  }
  return index;
}

const along = new Float64Array(3), side = new Float64Array(3), third = new Float64Array(3);

/** Unit tangent at the vertex between a and b; kept as it was where they coincide. */
function tangent(points, a, b) {
  const x = points[3 * b] - points[3 * a], y = points[3 * b + 1] - points[3 * a + 1], z = points[3 * b + 2] - points[3 * a + 2];
  const n = Math.sqrt(x * x + y * y + z * z);
  if (n > 1e-12) {
    along[0] = x / n;
    along[1] = y / n;
    along[2] = z / n;
  }
}

/** Make `side` normal to `along` and of unit length, some normal if it has none, and `third` the normal to both. */
function square() {
  let s = side[0] * along[0] + side[1] * along[1] + side[2] * along[2], n = 0;
  for (let k = 0; k < 3; k++) n += (side[k] -= s * along[k]) ** 2;
  if (n < 1e-18) {
    const [x, y, z] = [Math.abs(along[0]), Math.abs(along[1]), Math.abs(along[2])];
    side.fill(0);
    side[x <= y && x <= z ? 0 : y <= z ? 1 : 2] = 1;
    s = side[0] * along[0] + side[1] * along[1] + side[2] * along[2];
    n = 0;
    for (let k = 0; k < 3; k++) n += (side[k] -= s * along[k]) ** 2;
  }
  n = Math.sqrt(n);
  for (let k = 0; k < 3; k++) side[k] /= n;
  third[0] = along[1] * side[2] - along[2] * side[1];
  third[1] = along[2] * side[0] - along[0] * side[2];
  third[2] = along[0] * side[1] - along[1] * side[0];
}

/** One end: the outline, with the tangent as normal. */
function putCap(P, N, vertex, section, points, c, sign) {
  const o = section.outline;
  for (let j = 0; j < o.length; j += 2, vertex++)
    for (let k = 0; k < 3; k++) {
      P[3 * vertex + k] = points[3 * c + k] + o[j] * side[k] + o[j + 1] * third[k];
      N[3 * vertex + k] = sign * along[k];
    }
}

/**
 * Lay the surface along the vertices `points` into positions P and normals N, from vertex `at`; `across` holds the
 * directions of the section's y axis at both ends of each line.
 */
function sweep(P, N, at, counts, section, points, across) {
  const C = section.columns, w = C.length / 4, m = section.outline.length / 2;
  let vertex = at, first = 0;
  for (const n of counts) {
    const a = 3 * first, z = 3 * (first + n - 1);
    const closed = n > 3 && Math.abs(points[a] - points[z]) + Math.abs(points[a + 1] - points[z + 1]) + Math.abs(points[a + 2] - points[z + 2]) < 1e-7;
    const caps = vertex + n * w;
    side.fill(0);
    along.set([1, 0, 0]);
    for (let i = 0; i < n; i++) {
      const before = i > 0 ? i - 1 : closed ? n - 2 : 0, after = i + 1 < n ? i + 1 : closed ? 1 : n - 1;
      tangent(points, first + before, first + after);
      if (across) {
        const f = n > 1 ? i / (n - 1) : 0;
        for (let k = 0; k < 3; k++) side[k] = across[k] + f * (across[3 + k] - across[k]);
      }
      square();
      const c = 3 * (first + i), x = points[c], y = points[c + 1], q = points[c + 2];
      const [u0, u1, u2] = side, [w0, w1, w2] = third;
      for (let j = 0, v = 3 * vertex; j < w; j++, v += 3) {
        const cy = C[4 * j], cz = C[4 * j + 1], ny = C[4 * j + 2], nz = C[4 * j + 3];
        P[v] = x + cy * u0 + cz * w0;
        P[v + 1] = y + cy * u1 + cz * w1;
        P[v + 2] = q + cy * u2 + cz * w2;
        N[v] = ny * u0 + nz * w0;
        N[v + 1] = ny * u1 + nz * w1;
        N[v + 2] = ny * u2 + nz * w2;
      }
      vertex += w;
      if (i === 0) putCap(P, N, caps, section, points, first, -1);
      if (i === n - 1) putCap(P, N, caps + m, section, points, first + i, 1);
    }
    vertex = caps + 2 * m;
    first += n;
  }
}
