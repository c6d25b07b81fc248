// Bundles src into one HTML file with a placeholder for the data.
import { build } from 'esbuild';
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';

const product = '../../Packages/com.glint.radar';
const sha256 = content => createHash('sha256').update(content).digest('hex');
const read = path => readFileSync(path, 'utf8');

const { outputFiles } = await build({ entryPoints: ['src/main.js'], bundle: true, minify: true, write: false, outdir: 'out', format: 'iife', target: 'es2022', legalComments: 'none', charset: 'utf8' });
const output = end => outputFiles.find(file => file.path.endsWith(end)).text.trim();
const libraries = Object.keys(JSON.parse(read('package.json')).dependencies).sort();
const notices = libraries.map(name => {
  const { version, license } = JSON.parse(read(`node_modules/${name}/package.json`));
  return { name, version, license, text: read(`node_modules/${name}/LICENSE`).trim() };
});
const plain = `Glint: MIT\n\n${read('../../LICENSE').trim()}\n\n${notices.map(({ name, version, license, text }) => `${name} ${version}: ${license}\n\n${text}`).join('\n\n')}`;
const escaped = text => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');

// Functions, so that "$" in the inserted text has no special meaning.
const page = read('src/index.html').replace('@STYLE@', () => output('.css') + read('src/style.css').replaceAll(/\n\s*/g, '\n'))
  .replace('@LICENCES@', () => escaped(plain)).replace('@SCRIPT@', () => output('.js')).trim() + '\n';
const sources = ['build', 'build.mjs', 'package.json', 'package-lock.json', ...readdirSync('src').map(name => `src/${name}`)].sort();
const list = sources.map(path => `${sha256(readFileSync(path))}  ${path}\n`).join('');
mkdirSync(`${product}/Editor/Report`, { recursive: true });
// The first line is the document type; the second names the sources and the bundled packages.
writeFileSync(`${product}/Editor/Report/Template.txt`, `<!DOCTYPE html>\n<!-- sources ${sha256(list)} page ${sha256(page)} -->\n${page}`);
const noticesPath = `${product}/Third Party Notices.md`;
// Sections of what is not of the report stay.
const others = read(noticesPath).split(/^(?=## )/m).slice(1).filter(section => !libraries.some(name => section.startsWith(`## ${name} `)));
const own = notices.map(({ name, version, license, text }) => `## ${name} ${version}, ${license}\n\n${text}\n`);
writeFileSync(noticesPath, `# Third party notices\n\nThe template of the HTML report (\`Editor/Report/Template.txt\`) contains these libraries; every report carries their licences too.\n\n${
  [...own, ...others].map(section => `${section.trim()}\n`).join('\n')}`);
console.log(`Template.txt: ${page.length} characters, of which ${output('.js').length} script`);
