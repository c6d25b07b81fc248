import { mkdirSync, readFileSync } from 'node:fs';
import { end, launch, newPage, openReport } from './browser.mjs';
import { closest } from './colours.mjs';
import { hotStops, ofObject, ofSegment, seriesColours } from './src/palette.js';

const [report, folder] = process.argv.slice(2);
const limitMs = Number(process.env.LIMIT_MS ?? 2000);
// Minimum CIE76 distance of colours; 2.3 is just noticeable side by side.
const leastDistance = 10;
const failures = [];
const themes = readFileSync(new URL('src/style.css', import.meta.url), 'utf8').split('prefers-color-scheme: dark');
const ofTheme = css => seriesColours.map(colour => colour.startsWith('--') ? css.match(new RegExp(`${colour}: (#[0-9a-f]{6})`))[1] : colour);
const palettes = {
  'segments and bounces': [1, 2, 3, 4].map(n => ofSegment(n).colour), objects: [1, 2, 3, 4, 5, 6, 7, 8].map(ofObject), 'hot spots': hotStops,
  'charts, light': ofTheme(themes[0]), 'charts, dark': ofTheme(themes[1])
};
for (const [of, colours] of Object.entries(palettes))
  for (const { vision, distance, pair } of closest(colours))
    if (distance < leastDistance) failures.push(`${pair}, of ${of}, look alike to ${vision}: ${distance.toFixed(1)} apart, must be ${leastDistance}`);
const browser = await launch();
try {
  for (const width of [1280, 400])
    for (const scheme of ['light', 'dark'])
      await look(width, scheme);
} finally {
  await browser.close();
}
end(failures);

async function look(width, scheme) {
  const at = `${width} px, ${scheme}`, fail = what => failures.push(`${at}: ${what}`);
  const page = await newPage(browser, width, fail);
  await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: scheme }]);
  const readyMs = await open(page);
  if (readyMs > limitMs) fail(`ready after ${readyMs} ms`);
  const facts = await page.evaluate(() => {
    const shades = canvas => {
      const copy = document.createElement('canvas');
      [copy.width, copy.height] = [200, 120];
      const context = copy.getContext('2d');
      context.drawImage(canvas, 0, 0, 200, 120);
      const pixels = new Uint32Array(context.getImageData(0, 0, 200, 120).data.buffer);
      return new Set(pixels).size;
    };
    const shown = [...document.querySelectorAll('canvas')].filter(canvas => canvas.offsetParent !== null);
    const { run, scene, echo } = JSON.parse(document.getElementById('data').textContent);
    const chosen = run.rows[scene?.pose ?? 0], varies = name => new Set(run.rows.map(row => row[name])).size > 1;
    return {
      expected: run.table === 'ppi' ? ['ppi'] : run.table === 'clutter' ? ['sigma0-vv', 'sigma0-hh', 'shapes'] : run.table === 'echo' ? ['profile', ...echo.image ? ['image'] : [], ...echo.doppler ? ['doppler', 'doppler-cut'] : [], ...['azimuth_deg', 'elevation_deg'].some(varies) ? ['waterfall'] : [], ...run.rows.length > 1 ? ['levels'] : [], ...scene ? ['view'] : []] : run.table === 'rcs' ? ['levels', ...varies('azimuth_deg') ? ['polar'] : [], ...run.rows.some(row => row.contributions) ? ['parts'] : [], ...scene ? ['view'] : []] : [...run.rows.length > 1 ? ['amplitude', 'other'] : [], ...chosen?.rays_received > 0 && run.settings.tolerance === undefined ? ['phase'] : [], ...scene ? ['view'] : [], ...scene?.picture ? ['picture'] : []],
      canvases: shown.map(canvas => ({ name: canvas.id || canvas.closest('.chart')?.id, shades: shades(canvas), label: canvas.getAttribute('aria-label') })),
      overflow: document.documentElement.scrollWidth - innerWidth,
      isOfRows: run.table !== undefined && run.rows.length > 1,
      unnamed: [...document.querySelectorAll('button, input, select')].filter(control => !control.labels?.length && !control.textContent.trim() && !control.getAttribute('aria-label')).length
    };
  });
  for (const name of facts.expected)
    if (!facts.canvases.some(canvas => canvas.name === name)) fail(`${name} is missing`);
  for (const { name, shades, label } of facts.canvases) {
    if (shades < 6) fail(`${name} is not drawn: ${shades} colours`);
    if (!label) fail(`${name} has no words for who cannot see it`);
  }
  if (facts.overflow > 0) fail(`the page is ${facts.overflow} px wider than the window`);
  if (facts.unnamed > 0) fail(`${facts.unnamed} controls have no name`);
  const has3D = facts.canvases.some(canvas => canvas.name === 'view');
  if (has3D) await turns(page, fail);
  if (facts.canvases.some(canvas => canvas.name === 'ppi')) await zooms(page, fail);
  if (facts.isOfRows) await chooses(page, fail);
  await prints(page, fail);
  console.log(`${at}: ready after ${readyMs} ms; ${facts.canvases.map(canvas => `${canvas.name} ${canvas.shades}`).join(', ')} colours`);
  if (folder) {
    mkdirSync(folder, { recursive: true });
    await page.evaluate(() => { document.activeElement?.blur(); scrollTo(0, 0); });
    await page.screenshot({ path: `${folder}/${width}-${scheme}.png`, fullPage: true });
    if (has3D) await (await page.$('#view')).screenshot({ path: `${folder}/${width}-${scheme}-view.png` });
  }
  await page.close();
}

// Milliseconds until everything is drawn: the best of a few, since the machine may be busy.
async function open(page) {
  let best = Infinity;
  for (let attempt = 0; attempt < 3 && best > limitMs; attempt++) best = Math.min(best, await openReport(page, report));
  return best;
}

// The view rotates by keys and mouse, and resets.
async function turns(page, fail) {
  const frame = () => page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(document.getElementById('view').toDataURL())))));
  const first = await frame();
  const visible = await page.evaluate(() => {
    const copy = document.createElement('canvas'), view = document.getElementById('view');
    [copy.width, copy.height] = [view.width, view.height];
    const context = copy.getContext('2d');
    context.drawImage(view, 0, 0);
    const pixels = context.getImageData(0, 0, copy.width, copy.height).data;
    let count = 0;
    // Surfaces and background are grey; rays and the radar's lines are coloured.
    for (let i = 0; i < pixels.length; i += 4) count += Math.max(pixels[i], pixels[i + 1], pixels[i + 2]) - Math.min(pixels[i], pixels[i + 1], pixels[i + 2]) > 90 ? 1 : 0;
    return count;
  });
  const coloured = await page.evaluate(() => {
    const { scene } = JSON.parse(document.getElementById('data').textContent);
    return scene.paths ? scene.paths.counts.length : scene.hot_spots.names.length;
  });
  if (coloured > 0 && visible < 200) fail(`no rays or hot spots can be seen in the 3-D view: ${visible} coloured pixels`);
  await page.focus('#view');
  await page.keyboard.press('ArrowLeft');
  if (await frame() === first) fail('the arrow keys do not turn the view');
  await page.keyboard.press('Home');
  await frame();
  if (await frame() !== first) fail('Home does not bring the view back');
  const box = await (await page.$('#view')).boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 60, box.y + box.height / 2 + 20, { steps: 3 });
  await page.mouse.up();
  if (await frame() === first) fail('the mouse does not turn the view');
  await page.keyboard.press('Home');
}

// The picture of a radar screen zooms by keys and wheel, moves, resets, and tells the level under the mouse.
async function zooms(page, fail) {
  const frame = () => page.evaluate(() => document.getElementById('ppi').toDataURL());
  await (await page.$('#ppi')).scrollIntoView();
  const first = await frame(), box = await (await page.$('#ppi')).boundingBox();
  await page.focus('#ppi');
  await page.keyboard.press('+');
  const near = await frame();
  if (near === first) fail('+ does not zoom the picture');
  await page.mouse.move(box.x + 0.6 * box.width, box.y + 0.4 * box.height);
  await page.mouse.wheel({ deltaY: -1 });
  await page.waitForFunction(before => document.getElementById('ppi').toDataURL() !== before, { timeout: 5000 }, near).catch(() => fail('the wheel does not zoom the picture with the focus'));
  await page.keyboard.press('Home');
  await page.keyboard.press('=');
  if (await frame() !== near) fail('= does not zoom the picture as + does');
  if (!/bearing .* dB over noise/.test(await page.evaluate(() => document.getElementById('ppi-readout').textContent))) fail('the picture tells no level under the mouse');
  await page.mouse.down();
  await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.5 * box.height, { steps: 3 });
  await page.mouse.up();
  if (await frame() === near) fail('the mouse does not move the picture');
  await page.keyboard.press('Home');
  if (await frame() !== first) fail('Home does not show the whole turn');
}

// On paper charts have the width of the page and light colours, and afterwards those of the window.
async function prints(page, fail) {
  const state = () => page.evaluate(() => ({
    back: getComputedStyle(document.body).backgroundColor, page: document.body.clientWidth,
    charts: [...document.querySelectorAll('.chart .uplot')].filter(chart => chart.offsetParent !== null).map(chart => [chart.clientWidth, chart.closest('.chart').clientWidth]),
    table: Math.floor(document.getElementById('table')?.getBoundingClientRect().width ?? 0)
  }));
  const send = name => page.evaluate(event => dispatchEvent(new Event(event)), name);
  const before = await state();
  await send('beforeprint');
  const paper = await state();
  if (paper.back !== 'rgb(255, 255, 255)') fail(`a printed page is ${paper.back}`);
  if (paper.charts.some(([chart, place]) => chart !== place) || paper.table > paper.page) fail(`charts or table are not as wide as a printed page: ${JSON.stringify(paper)}`);
  await send('afterprint');
  const after = await state();
  if (JSON.stringify(after) !== JSON.stringify(before)) fail(`printing leaves traces: ${JSON.stringify(before)}, then ${JSON.stringify(after)}`);
}

// Another row changes the charts, the table of contributions and the 3-D view; a click on the polar chart chooses one.
async function chooses(page, fail) {
  const state = () => page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done({
    row: document.getElementById('row').value, ...Object.fromEntries([...document.querySelectorAll('#polar, #view, #levels canvas, #parts canvas, #profile canvas, #waterfall, #doppler, #sigma0-vv canvas, #sigma0-hh canvas, #shapes canvas')].filter(canvas => canvas.offsetParent !== null).map(canvas => [canvas.id || canvas.closest('.chart').id, canvas.toDataURL()])),
    table: document.querySelector('#parts-table tbody')?.textContent
  })))));
  const first = await state();
  await page.focus('#row');
  for (let i = 0; i < 3; i++) await page.keyboard.press(Number(first.row) > 3 ? 'ArrowLeft' : 'ArrowRight');
  const second = await state();
  for (const what of Object.keys(first)) if (first[what] !== undefined && first[what] === second[what]) fail(`another row does not change ${what}`);
  const polar = await page.$('#polar');
  if (!polar) return;
  await polar.scrollIntoView();
  const box = await polar.boundingBox();
  let chosen = second.row;
  for (const [x, y] of [[0.5, 0.1], [0.9, 0.5], [0.5, 0.9], [0.1, 0.5]]) {
    await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
    chosen = (await state()).row === second.row ? chosen : null;
  }
  if (chosen !== null) fail('a click on the polar chart chooses no row');
}
