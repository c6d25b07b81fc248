import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { end, launch, newPage, openReport } from './browser.mjs';

const page = readFileSync(process.argv[2], 'utf8'), opening = '<script type="application/json" id="data">';
const start = page.indexOf(opening) + opening.length, stop = page.indexOf('</script>', start);
const data = JSON.parse(page.slice(start, stop)), [first] = data.run.rows;
const folder = mkdtempSync(join(tmpdir(), 'glint-report-')), failures = [];

const range = (count, rowOf) => Array.from({ length: count }, (_, i) => ({ ...first, contributions: undefined, ...rowOf(i) }));
const levels = dbsm => Object.fromEntries(['vv', 'hv', 'vh', 'hh'].filter(name => `${name}_dbsm` in first).map(name => [`${name}_dbsm`, dbsm]));
const waves = i => levels(10 * Math.sin(i / 7));

const browser = await launch();
try {
  await look('one row', range(1, () => ({ azimuth_deg: 30, ...waves(1) })), async page => ({ 'is not drawn': await coloured(page) > 10 }));
  await look('rows twice', range(20, i => ({ azimuth_deg: i >> 1, ...waves(i >> 1) })), async page => ({ 'cannot be chosen': (await framesOfRows(page, 20)).size === 10 }));
  await look('a track', range(21, i => ({ azimuth_deg: 10 - i + i * i / 1000, elevation_deg: 60 - (i - 10) ** 2 / 50, ...waves(i) })), async page => ({
    'has lists': await page.$('#others select') === null, 'misses rows': (await framesOfRows(page, 21)).size === 21
  }));
  await look('an incomplete grid', range(5, i => ({ azimuth_deg: 10 * (i % 3), elevation_deg: i < 3 ? 0 : 10, ...waves(i) })), async page => ({ 'shows another row than the list': await choosesMissing(page) }));
  await look('values that stand alone', range(200, i => ({ azimuth_deg: i, ...levels(i % 20 === 0 ? 0 : null) })), async page => ({ 'are not drawn': await coloured(page) > 100 }));
  await look('no echo', range(3, i => ({ azimuth_deg: i, ...levels(null) })), async page => ({
    'has a level': await page.evaluate(() => /no echo/.test(document.getElementById('facts').textContent) && !/Infinity|NaN/.test(document.querySelector('main').innerText))
  }));
  await look('150,000 rows', range(150000, i => ({ azimuth_deg: 360 * i / 150000, ...levels(i === 140000 ? 50 : 0) })), async page => ({ 'are not sorted': await highestOnTop(page) === '140001' }));
} finally {
  await browser.close();
  rmSync(folder, { recursive: true });
}
end(failures);

// The report with other rows and without a scene. @param {(page) => object} check What is wrong unless it is true.
async function look(name, rows, check) {
  const file = join(folder, 'report.html'), fail = what => failures.push(`${name}: ${what}`);
  const json = JSON.stringify({ ...data, run: { ...data.run, rows }, scene: null, no_scene: 'None.' }).replaceAll('<', '\\u003c');
  writeFileSync(file, page.slice(0, start) + json + page.slice(stop));
  const opened = await newPage(browser, 1280, fail);
  try {
    console.log(`${name}: ready after ${await openReport(opened, file)} ms`);
    for (const [what, isRight] of Object.entries(await check(opened))) if (!isRight) fail(what);
  } catch (problem) {
    fail(problem.message);
  }
  await opened.close();
}

// Pixels of the curves: all else within the axes is grey.
function coloured(page) {
  return page.evaluate(() => {
    const { offsetLeft: left, offsetTop: top, clientWidth: width, clientHeight: height } = document.querySelector('#levels .u-over');
    const { data } = document.querySelector('#levels canvas').getContext('2d').getImageData(left, top, width, height);
    let count = 0;
    for (let i = 0; i < data.length; i += 4) count += Math.max(data[i], data[i + 1], data[i + 2]) - Math.min(data[i], data[i + 1], data[i + 2]) > 60 ? 1 : 0;
    return count;
  });
}

// The pictures of the chart with each row chosen.
function framesOfRows(page, count) {
  return page.evaluate(async rows => {
    const slider = document.getElementById('row'), frames = [];
    for (let row = 0; row < rows; row++) {
      slider.value = row;
      slider.dispatchEvent(new Event('input'));
      await new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)));
      frames.push(document.querySelector('#levels canvas').toDataURL());
    }
    return frames;
  }, count).then(frames => new Set(frames));
}

// From the azimuth that only the first elevation has to the other elevation.
function choosesMissing(page) {
  return page.evaluate(() => {
    const slider = document.getElementById('row'), list = document.querySelector('#others select');
    slider.value = 2;
    slider.dispatchEvent(new Event('input'));
    list.value = '10';
    list.dispatchEvent(new Event('change'));
    return list.value === '10' && document.getElementById('row-text').textContent.startsWith('elevation 10 deg, azimuth 10 deg');
  });
}

async function highestOnTop(page) {
  const heading = await page.evaluateHandle(() => [...document.querySelectorAll('#table thead button')].find(button => /dBsm$/.test(button.textContent)));
  for (let i = 0; i < 2; i++) await heading.click();
  return page.evaluate(() => document.querySelector('#table tbody button').textContent);
}
