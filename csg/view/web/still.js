// The picture at rest of many cells: made in pieces, one a frame, into a texture, and kept.
//
// Drawn at once it would hold up the page for as long as it takes, and again for every cell that is picked. In
// pieces the page answers between them; a new movement of the camera ends it at any time; and what is picked is
// drawn over the picture that is there.
import * as THREE from 'three';
import {material} from './shaders.js';

const PIECE = 40000;  // triangles, lines or points

export class Still {
  constructor(scene) {
    this.scene = scene;
    this.done = false;
    this.pieces = [];
    this.image = {value: null};
    this.screen = new THREE.Scene();
    const quad = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material('STILL', {depthTest: false, depthWrite: false}, {image: this.image}));
    quad.frustumCulled = false;
    this.screen.add(quad);
  }

  /** What is there or on its way shows no longer what is to be seen. */
  stop() {
    this.done = false;
    this.pieces = [];
  }

  begin() {
    const {scene} = this;
    if (this.pieces.length) return;
    this.ratio = scene.ratioOf(false);
    const width = Math.round(scene.width * this.ratio), height = Math.round(scene.height * this.ratio);
    if (!this.target || this.target.width !== width || this.target.height !== height) {
      this.target?.dispose();
      this.target = new THREE.WebGLRenderTarget(width, height, {samples: scene.software ? 0 : 4, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter});
    }
    scene.choose(true, Infinity);
    this.pieces = this.cutUp(scene);
    this.first = true;
    const mine = this.pieces;
    const step = () => this.pieces === mine && mine.length && this.step(step);
    requestAnimationFrame(step);
  }

  /** Parts of objects, each `{object, start, count}` in what it has indices of, in the order of drawing. */
  cutUp(scene) {
    const out = [], objects = scene.world.children.filter((o) => o.visible).sort((a, b) => a.renderOrder - b.renderOrder);
    for (const object of objects) {
      const {geometry} = object, size = geometry.index ? 3 : object.isLineSegments ? 2 : 1, piece = PIECE * size;
      const ranges = object === scene.skin ? scene.facing.map(({start, count}) => [3 * start, 3 * count])
        : [[0, (geometry.index ?? geometry.attributes.position).count]];
      for (const [begin, all] of ranges) {
        for (let start = 0; start < all; start += piece) out.push({object, start: begin + start, count: Math.min(piece, all - start)});
      }
    }
    return out;
  }

  step(again) {
    const {scene} = this, {renderer, world, over, root, camera} = scene, {object, start, count} = this.pieces.shift();
    const seen = world.children.map((o) => o.visible);
    for (const o of world.children) o.visible = o === object;
    over.visible = false;
    const {geometry} = object, groups = geometry.groups;
    if (object === scene.skin) geometry.groups = [{start, count, materialIndex: 0}];
    else geometry.setDrawRange(start, count);
    scene.prepare(this.ratio, this.target.width, this.target.height);
    renderer.autoClear = this.first;
    this.first = false;
    renderer.setRenderTarget(this.target);
    renderer.render(root, camera);
    // The piece is there when a pixel of it is: else all pieces would wait in one queue.
    renderer.readRenderTargetPixels(this.target, 0, 0, 1, 1, new Uint8Array(4));
    renderer.setRenderTarget(null);
    renderer.autoClear = true;
    geometry.groups = groups;
    if (object !== scene.skin) geometry.setDrawRange(0, Infinity);
    world.children.forEach((o, k) => (o.visible = seen[k]));
    over.visible = true;
    if (this.pieces.length) return requestAnimationFrame(again);
    this.done = true;
    this.show();
  }

  /** On the screen, with what is picked. */
  show() {
    const {scene} = this, {renderer, over, camera} = scene;
    scene.setRatio(this.ratio);
    scene.prepare(this.ratio, this.target.width, this.target.height);
    this.image.value = this.target.texture;
    renderer.render(this.screen, camera);
    renderer.autoClear = false;
    scene.world.visible = false;
    renderer.render(scene.root, camera);
    scene.world.visible = true;
    renderer.autoClear = true;
    over.visible = true;
    scene.shown = true;
    scene.changed(false);
  }
}
