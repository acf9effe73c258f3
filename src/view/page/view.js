// Shows the frames that the program draws and sends back what hands do. Messages: src/view/message.h.
'use strict';

const canvas = document.getElementById('picture');
const notice = document.getElementById('notice');
const paper = canvas.getContext('2d', { alpha: false });
const mostPixels = 2560 * 1600; // that a picture is asked for with
const mostSide = 2560; // most_side of src/view/studio.h
const leastRatio = 0.25, mostRatio = 8; // that src/view/message.cpp takes
const pixelsPerNotch = 100;

let socket = null;
let wait = 500; // ms until the next attempt
let wanted = [0, 0]; // pixels of the picture that this window last asked for
let shown = 0;       // number of the frame that is seen

history.replaceState(null, '', '/'); // the token has been used: it need not stand in the address

function send(...words) {
  if (socket && socket.readyState === WebSocket.OPEN) socket.send(words.join(' '));
}

function tellSize() {
  const width = window.innerWidth, height = window.innerHeight;
  if (document.hidden || width < 1 || height < 1) return send('size', 0, 0, 1);
  const ratio = Math.min(window.devicePixelRatio || 1, Math.sqrt(mostPixels / (width * height)), mostSide / Math.max(width, height));
  wanted = [Math.round(width * ratio), Math.round(height * ratio)];
  send('size', ...wanted, Math.min(Math.max(ratio, leastRatio), mostRatio).toFixed(3));
}

// All browsers share one picture, which has the size of the window that was last used: asked for again in hands' reach.
function takeOver() {
  if (canvas.width !== wanted[0] || canvas.height !== wanted[1]) tellSize();
}

// Who says that a frame was seen gets the next. A page that nobody sees says it once it is seen again: meanwhile nothing is drawn for it.
let unsaid = [];

function tellSeen(number) {
  unsaid.push(number);
  if (document.hidden) return;
  for (const each of unsaid) send('seen', each);
  unsaid = [];
}

async function show(message) {
  const head = new DataView(message);
  const number = head.getUint32(0, true), length = head.getUint32(4, true);
  const told = JSON.parse(new TextDecoder().decode(new Uint8Array(message, 8, length)));
  const picture = await createImageBitmap(new Blob([new Uint8Array(message, 8 + length)], { type: 'image/jpeg' }));
  if (number <= shown) return picture.close(); // pictures are unpacked side by side: an older one may come later
  shown = number;
  if (canvas.width !== picture.width || canvas.height !== picture.height) {
    canvas.width = picture.width;
    canvas.height = picture.height;
  }
  paper.drawImage(picture, 0, 0);
  picture.close();
  told.shown = number;
  window.tumble = told; // for tests and other tools
  document.title = told.title + ' - tumble';
  notice.textContent = told.trouble;
}

// Why there are no frames. A browser does not tell with which status a WebSocket was refused: the page's is asked for.
async function reasonOf(code, opened) {
  if (code === 1008 || code === 1009) return 'The program sent this page away: it said too much, or what is no message. It tries again.';
  let status = 0;
  try { status = (await fetch('/icon.svg', { cache: 'no-store' })).status; } catch { /* nobody is there */ }
  if (status === 200 && !opened) return 'As many browsers as may watch do so already: close one of them.';
  if (status === 403) return 'The program was started anew: open the newest link that it printed.';
  return 'The program does not answer. If it has ended, start it again and open its new link.';
}

function connect() {
  socket = new WebSocket('ws://' + location.host + '/frames');
  socket.binaryType = 'arraybuffer';
  let opened = false;
  socket.onopen = () => { opened = true; shown = 0; unsaid = []; wait = 500; notice.textContent = ''; tellSize(); };
  const own = socket;
  socket.onmessage = async (event) => {
    try { await show(event.data); } finally { if (own === socket) tellSeen(new DataView(event.data).getUint32(0, true)); }
  };
  socket.onclose = async (event) => {
    notice.textContent = await reasonOf(event.code, opened);
    setTimeout(connect, wait);
    wait = Math.min(2 * wait, 10000);
  };
}

// Pointers: the mouse and one finger press and drag; two fingers pinch. Of many moves a frame only the last is sent.
const fingers = new Map();
let lastMove = null;
let lastPlace = [0, 0];

// Which pointer holds each button that was told to be down. Whatever ends the holding, seen by this page or not, lets go.
const pressed = new Map();
const bits = [1, 4, 2 | 8 | 16]; // of PointerEvent.buttons

function press(event) {
  const button = Math.min(event.button, 2);
  pressed.set(button, event.pointerId);
  send('down', button, ...lastPlace);
}

function release(button) {
  if (!pressed.delete(button)) return;
  flushMove();
  send('up', button, ...lastPlace);
}

function releaseAll(pointer) {
  for (const [button, holder] of [...pressed]) if (pointer === undefined || holder === pointer) release(button);
}

// The event tells what its pointer holds: of two buttons only the last that is let go has a pointerup of its own.
function follow(event) {
  lastPlace = place(event);
  for (const [button, holder] of [...pressed]) if (holder === event.pointerId && !(event.buttons & bits[button])) release(button);
}

// The picture stands in the middle of the window, as large as fits (object-fit in view.css).
function frameOnPage() {
  const box = canvas.getBoundingClientRect();
  const scale = Math.min(box.width / canvas.width, box.height / canvas.height); // pixels of the page per pixel of the picture
  return { scale, left: box.left + (box.width - canvas.width * scale) / 2, top: box.top + (box.height - canvas.height * scale) / 2 };
}

function toPicture(x, y) {
  const { scale, left, top } = frameOnPage();
  return [((x - left) / scale).toFixed(1), ((y - top) / scale).toFixed(1)];
}

function place(event) { return toPicture(event.clientX, event.clientY); }

function flushMove() {
  if (lastMove) send('move', ...lastMove);
  lastMove = null;
}

function spread() {
  const [a, b] = [...fingers.values()];
  return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, gap: Math.max(Math.hypot(a.x - b.x, a.y - b.y), 1) };
}

canvas.addEventListener('pointerdown', (event) => {
  event.preventDefault();
  canvas.focus();
  canvas.setPointerCapture(event.pointerId);
  follow(event);
  if (event.pointerType === 'touch') {
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (fingers.size === 2) releaseAll();
    if (fingers.size > 1) return;
  }
  flushMove();
  send('move', ...lastPlace);
  press(event);
});

canvas.addEventListener('pointermove', (event) => {
  if (event.pointerType === 'touch' && fingers.has(event.pointerId) && fingers.size === 2) {
    const before = spread();
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const now = spread();
    const factor = Math.min(Math.max(now.gap / before.gap, 0.1), 10);
    const ways = [now.x - before.x, now.y - before.y].map((way) => (way / frameOnPage().scale).toFixed(2));
    send('pinch', ...toPicture(now.x, now.y), ...ways, factor.toFixed(5));
    return;
  }
  if (fingers.size > 1) return;
  if (!lastMove) requestAnimationFrame(flushMove);
  lastMove = place(event);
  follow(event);
  const another = event.pointerType === 'mouse' && event.button >= 0 && event.buttons & bits[Math.min(event.button, 2)];
  if (another && pressed.size) { flushMove(); press(event); } // beside one that is held
});

canvas.addEventListener('pointerup', (event) => {
  const pinching = fingers.size > 1;
  fingers.delete(event.pointerId);
  if (pinching) return;
  follow(event);
  takeOver(); // not before: the place of the press was meant in the picture that was seen
});
for (const kind of ['pointercancel', 'lostpointercapture']) // the browser takes the pointer away; the event has no place
  canvas.addEventListener(kind, (event) => {
    fingers.delete(event.pointerId);
    releaseAll(event.pointerId);
  });
canvas.addEventListener('pointerenter', (event) => {
  if (event.pointerType === 'mouse') follow(event);
  if (event.pointerType === 'mouse' && !event.buttons) takeOver();
});

canvas.addEventListener('wheel', (event) => {
  event.preventDefault();
  const pixels = event.deltaY * (event.deltaMode === 1 ? 33 : event.deltaMode === 2 ? 400 : 1);
  send('wheel', ...place(event), Math.min(Math.max(-pixels / pixelsPerNotch, -20), 20).toFixed(3));
}, { passive: false });

canvas.addEventListener('contextmenu', (event) => event.preventDefault());

// Keys that are held: a window that loses the keyboard hears no more of them, and perhaps no more of buttons.
const held = new Set();

function letGo() {
  for (const code of held) send('key', code, 0, 0, 0);
  held.clear();
  releaseAll();
  fingers.clear();
}

for (const [kind, down] of [['keydown', 1], ['keyup', 0]])
  canvas.addEventListener(kind, (event) => {
    if (event.altKey || event.metaKey || event.code === 'Tab' || event.code.startsWith('F')) return;
    if (event.ctrlKey && !['KeyA', 'KeyC', 'KeyV', 'KeyX'].includes(event.code) && !event.code.startsWith('Control')) return;
    event.preventDefault();
    if (/^[A-Za-z0-9]{1,24}$/.test(event.code)) {
      if (down) held.add(event.code); else held.delete(event.code);
      send('key', event.code, down, event.shiftKey ? 1 : 0, event.ctrlKey ? 1 : 0);
    }
    if (down && event.key.length === 1 && !event.ctrlKey) send('text', event.key);
  });

document.getElementById('panel').addEventListener('click', () => { send('panel'); canvas.focus(); });
window.addEventListener('resize', tellSize);
window.addEventListener('focus', takeOver);
window.addEventListener('blur', letGo);
document.addEventListener('visibilitychange', () => {
  if (document.hidden) letGo();
  tellSize();
  for (const each of unsaid.splice(0)) tellSeen(each);
});
canvas.focus();
connect();
