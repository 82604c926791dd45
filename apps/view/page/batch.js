// Many parts in one draw call: rigid pieces moved by bones, deforming ones laid anew at every frame.

/** Pieces of surface with one material; made into one mesh by `finish`. */
class Batch {
  constructor(material, rigid) {
    this.material = material;
    this.rigid = rigid;
    this.size = 0;
    this.pieces = [];
    this.index = [];
    this.bones = [];
  }

  /** Add a piece of `size` vertices with its triangles; returns where it begins. */
  add(size, index, bone = 0) {
    const at = this.size;
    for (const i of index) this.index.push(at + i);
    this.size += size;
    this.pieces.push({ at, size, bone });
    return at;
  }

  bone() {
    const bone = new THREE.Bone();
    bone.matrixAutoUpdate = bone.matrixWorldAutoUpdate = false;
    this.bones.push(bone);
    return this.bones.length - 1;
  }

  /** The arrays of positions, normals and colours; their pieces are filled by the parts. */
  allocate() {
    this.geometry = new THREE.BufferGeometry();
    for (const name of ["position", "normal", "color"]) {
      const attribute = new THREE.BufferAttribute(new Float32Array(3 * this.size), 3);
      if (name !== "normal" && !this.rigid) attribute.setUsage(THREE.DynamicDrawUsage);
      this.geometry.setAttribute(name, attribute);
    }
    this.geometry.setIndex(this.index);
    this.index = null;
    this.P = this.geometry.attributes.position.array;
    this.N = this.geometry.attributes.normal.array;
    this.C = this.geometry.attributes.color.array;
  }

  finish() {
    if (!this.size) return null;
    const mesh = this.rigid ? this.skinned() : new THREE.Mesh(this.geometry, this.material);
    mesh.frustumCulled = false; // its bounds change with every frame
    mesh.castShadow = mesh.receiveShadow = !this.material.transparent;
    return mesh;
  }

  /** A mesh whose bones are the poses of its pieces. */
  skinned() {
    const which = new Uint16Array(4 * this.size), weight = new Float32Array(4 * this.size);
    for (const { at, size, bone } of this.pieces)
      for (let i = at; i < at + size; i++) {
        which[4 * i] = bone;
        weight[4 * i] = 1;
      }
    this.geometry.setAttribute("skinIndex", new THREE.BufferAttribute(which, 4));
    this.geometry.setAttribute("skinWeight", new THREE.BufferAttribute(weight, 4));
    const mesh = new THREE.SkinnedMesh(this.geometry, this.material);
    mesh.bindMode = THREE.DetachedBindMode; // poses are relative to the scene's root, as the mesh is
    mesh.bind(new THREE.Skeleton(this.bones, this.bones.map(() => new THREE.Matrix4())), new THREE.Matrix4());
    return mesh;
  }

  /** Colour `count` vertices from `at`. */
  fill(at, count, colour) {
    const C = this.C;
    for (let i = 3 * at; i < 3 * (at + count); i += 3) {
      C[i] = colour.r;
      C[i + 1] = colour.g;
      C[i + 2] = colour.b;
    }
    this.painted = true;
  }

  /** Tell the graphics card what has changed. */
  upload() {
    const attributes = this.geometry?.attributes;
    if (!attributes) return;
    if (this.moved) attributes.position.needsUpdate = attributes.normal.needsUpdate = true;
    if (this.painted) attributes.color.needsUpdate = true;
    this.moved = this.painted = false;
  }
}

/** A material that takes its colour from the vertices. */
function lambert(options) {
  return new THREE.MeshLambertMaterial({ vertexColors: true, side: THREE.DoubleSide, ...options });
}

/** The batch of what is see-through by a given amount; made when it is first asked for. */
function veil(batches, opacity, rigid) {
  const name = `veil ${opacity} ${rigid}`;
  return (batches[name] ??= new Batch(lambert({ transparent: true, opacity, depthWrite: false }), rigid));
}

/** The batches of the page. */
function makeBatches() {
  const glass = { transparent: true, opacity: 0.22, depthWrite: false };
  return { solid: new Batch(lambert(), true), glass: new Batch(lambert(glass), true), soft: new Batch(lambert(), false) };
}
