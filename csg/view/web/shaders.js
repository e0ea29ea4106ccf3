// What is drawn with: faces, edges as ribbons of pixels (lines of WebGL have one width), points as disks and rings,
// or lines where there are many. Each can draw the number of its cell instead of its color: where labels may stand
// is read off such a picture.
import * as THREE from 'three';

/** What all materials share; set once for all. */
export const shared = {
  explode: {value: 0},
  plane: {value: new THREE.Vector4(0, 0, 0, 1)},
  size: {value: new THREE.Vector2(1, 1)},
  ratio: {value: 1},
  dash: {value: 0.02},
  ids: {value: 0},  // 1: numbers of cells, 2: of the regions behind faces
  paper: {value: new THREE.Color()},
  edge: {value: 1.3},
  points: {value: 6},
};

const COMMON = `
  uniform float explode, ratio, ids, dash, edge, points;
  uniform vec4 plane;
  uniform vec2 size;
  uniform vec3 paper;
`;
const CLIP = 'if (side(world) < 0.0) discard;';
// Nearer to the eye by a share of the distance, at the same place of the picture: edges lie before faces, points
// before edges, whatever the camera's range of depth is.
const LIFTED = `uniform float lift;
    vec4 lifted(vec3 p) { return projectionMatrix * vec4((modelViewMatrix * vec4(p, 1.0)).xyz * (1.0 - lift), 1.0); }`;
const SIDE = 'float side(vec3 p) { return dot(p, plane.xyz) + plane.w; }';

const FACE = {
  vertexShader: `${COMMON}
    attribute vec4 tint; attribute vec4 ident; attribute vec4 owner; attribute vec3 shift;
    varying vec3 hue; varying vec4 number; varying vec3 outward; varying vec3 world; varying float style;
    void main() {
      world = position + shift * explode;
      hue = tint.rgb; style = floor(tint.a * 255.0 + 0.5);
      number = ids > 1.5 ? owner : ident;
      outward = normalMatrix * normal;
      gl_Position = projectionMatrix * modelViewMatrix * vec4(world, 1.0);
    }`,
  fragmentShader: `${COMMON} uniform float opacity; uniform float solid;
    varying vec3 hue; varying vec4 number; varying vec3 outward; varying vec3 world; varying float style;
    ${SIDE}
    void main() {
      if (style < 2.5) { ${CLIP} }
      // What is missing is hatched: one sees between the lines.
      if (style > 0.5 && style < 1.5 && solid < 0.5) {
        if (mod(gl_FragCoord.x + gl_FragCoord.y, 9.0 * ratio) > 2.0 * ratio) discard;
      }
      if (ids > 0.5) { gl_FragColor = number; return; }
      // Cut faces are hatched, this way or that by the region.
      if (style > 2.5) {
        float way = mod(floor(number.r * 255.0 + 0.5), 2.0) * 2.0 - 1.0;
        float line = mod(gl_FragCoord.x + way * gl_FragCoord.y, 10.0 * ratio) < 1.2 * ratio ? 0.72 : 1.0;
        gl_FragColor = vec4(hue * line, 1.0);
        return;
      }
      vec3 n = normalize(outward) * (gl_FrontFacing ? 1.0 : -1.0);
      float light = 0.62 + 0.30 * max(0.0, n.z) + 0.12 * n.y - 0.05 * n.x;
      // A sheet has a fine weave, so that nobody takes it for the skin of a solid.
      if (style > 1.5 && style < 2.5 && mod(gl_FragCoord.x - gl_FragCoord.y, 6.0 * ratio) < 1.2 * ratio) light *= 0.86;
      gl_FragColor = vec4(min(hue * light * 1.06, 1.0), opacity);
    }`,
};

const EDGE = {
  vertexShader: `${COMMON}
    attribute vec3 a; attribute vec3 b; attribute vec3 shift; attribute vec4 tint; attribute vec4 ident; attribute vec3 look;
    varying vec3 hue; varying vec4 number; varying vec3 world; varying float along; varying float dashed;
    ${LIFTED}
    void main() {
      vec3 p = a + shift * explode, q = b + shift * explode;
      vec4 A = lifted(p), B = lifted(q);
      float least = 0.001;
      if (A.w < least && B.w > least) A = mix(A, B, (least - A.w) / (B.w - A.w));
      if (B.w < least && A.w > least) B = mix(B, A, (least - B.w) / (A.w - B.w));
      vec2 run = (B.xy / B.w - A.xy / A.w) * size;
      float far = length(run);
      run = far > 0.0 ? run / far : vec2(1.0, 0.0);
      float width = (ids > 0.5 ? max(look.x * edge, 5.0) : look.x * edge) * ratio;
      vec4 at = position.x < 0.5 ? A : B;
      vec2 out_ = vec2(-run.y, run.x) * position.y + run * (position.x - 0.5) * min(1.0, far);
      at.xy += out_ * width / size * at.w;
      world = position.x < 0.5 ? p : q;
      along = look.z + position.x * length(q - p);
      dashed = look.y; hue = tint.rgb; number = ident;
      gl_Position = at;
    }`,
  fragmentShader: `${COMMON}
    uniform float opacity, hidden;
    varying vec3 hue; varying vec4 number; varying vec3 world; varying float along; varying float dashed;
    ${SIDE}
    void main() {
      ${CLIP}
      if (ids > 0.5) { gl_FragColor = number; return; }
      if (dashed + hidden > 0.5 && fract(along / dash) > 0.55) discard;
      gl_FragColor = vec4(hue, opacity);
    }`,
};

const POINT = {
  vertexShader: `${COMMON}
    attribute vec3 shift; attribute vec4 tint; attribute vec4 ident; attribute vec2 look;
    varying vec3 hue; varying vec4 number; varying vec3 world; varying float hollow;
    ${LIFTED}
    void main() {
      world = position + shift * explode;
      gl_Position = lifted(world);
      gl_PointSize = (ids > 0.5 ? max(look.x * points, 9.0) : look.x * points) * ratio;
      hollow = look.y; hue = tint.rgb; number = ident;
    }`,
  fragmentShader: `${COMMON}
    uniform float opacity;
    varying vec3 hue; varying vec4 number; varying vec3 world; varying float hollow;
    ${SIDE}
    void main() {
      ${CLIP}
      float r = length(gl_PointCoord - 0.5) * 2.0;
      if (r > 1.0) discard;
      if (ids > 0.5) { gl_FragColor = number; return; }
      bool inner = hollow > 1.5 ? (r > 0.5 && r < 0.74) : (hollow > 0.5 && r < 0.6);
      gl_FragColor = vec4(inner ? paper : hue, opacity);
    }`,
};

const LINE = {
  vertexShader: `${COMMON}
    attribute vec3 shift; attribute vec4 tint; attribute vec4 ident;
    varying vec3 hue; varying vec4 number; varying vec3 world;
    ${LIFTED}
    void main() {
      world = position + shift * explode;
      gl_Position = lifted(world);
      hue = tint.rgb; number = ident;
    }`,
  fragmentShader: `${COMMON}
    varying vec3 hue; varying vec4 number; varying vec3 world;
    ${SIDE}
    void main() {
      ${CLIP}
      gl_FragColor = ids > 0.5 ? number : vec4(hue, 1.0);
    }`,
};

/** A picture made before, over all of the canvas. */
const STILL = {
  vertexShader: 'void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }',
  fragmentShader: 'uniform sampler2D image; void main() { gl_FragColor = texelFetch(image, ivec2(gl_FragCoord.xy), 0); }',
};

export function material(kind, options = {}, uniforms = {}) {
  const source = {FACE, EDGE, LINE, POINT, STILL}[kind];
  return new THREE.ShaderMaterial({
    vertexShader: source.vertexShader,
    fragmentShader: source.fragmentShader,
    uniforms: {
      explode: shared.explode, plane: shared.plane, size: shared.size, ratio: shared.ratio, dash: shared.dash, ids: shared.ids,
      paper: shared.paper, edge: shared.edge, points: shared.points, opacity: {value: 1}, solid: {value: 0}, hidden: {value: 0}, lift: {value: 0}, ...uniforms,
    },
    ...options,
  });
}
