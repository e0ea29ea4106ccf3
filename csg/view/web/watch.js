// In a page that `cnrg view --watch` wrote: looks every second whether the file has become another page.
//
// A page opened from a file may read no file, not even itself. It may show itself in a frame, though, and a page in a
// frame may say who it is: the new one tells its stamp and stops before it has read its data.
const stamp = document.documentElement.dataset.stamp;
if (stamp && window.parent !== window && location.hash === '#cnrg-stamp') {
  window.parent.postMessage({cnrg: stamp}, '*');
  window.stop();
} else if (stamp) {
  let asked = -Infinity;  // when a frame that has not answered was made: a slow machine takes longer than a second
  addEventListener('message', (message) => {
    const told = message.data?.cnrg;
    asked = -Infinity;
    if (typeof told === 'string' && told !== stamp) location.reload();
  });
  addEventListener('load', () => {
    setInterval(() => {
      if (performance.now() < asked + 20000) return;
      asked = performance.now();
      document.getElementById('cnrg-next')?.remove();
      const frame = document.createElement('iframe');
      frame.id = 'cnrg-next';
      frame.hidden = true;
      frame.title = 'the next page';
      frame.src = `${location.href.replace(/[?#].*$/, '')}?${Date.now()}#cnrg-stamp`;
      document.body.append(frame);
    }, 1000);
  });
}
