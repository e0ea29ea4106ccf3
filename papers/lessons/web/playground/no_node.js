// What the module of emscripten asks Node.js for: in a browser there is nothing to require.
export const createRequire = () => null;
