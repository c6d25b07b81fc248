// The headless Chromium of the checks.
import puppeteer from 'puppeteer-core';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

export const launch = () => puppeteer.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox', '--enable-unsafe-swiftshader', '--use-angle=swiftshader', '--hide-scrollbars']
});

/** A page of which fail() hears every message, error and request. */
export async function newPage(browser, width, fail) {
  const page = await browser.newPage();
  page.on('console', message => { if (['error', 'warn'].includes(message.type())) fail(`console: ${message.text()}`); });
  page.on('pageerror', error => fail(`script: ${error.message}`));
  page.on('request', request => { if (!/^(file|data):/.test(request.url())) fail(`asks for ${request.url()}`); });
  await page.setViewport({ width, height: 900, deviceScaleFactor: 1 });
  return page;
}

/** Milliseconds until everything of a report is drawn. */
export async function openReport(page, report) {
  await page.goto(pathToFileURL(resolve(report)).href);
  await page.waitForFunction(() => document.documentElement.dataset.ready, { timeout: 30000 });
  return Number(await page.evaluate(() => document.documentElement.dataset.ready));
}

/** Tells the failures and ends the program. */
export function end(failures) {
  for (const failure of failures) console.error(`check: ${failure}`);
  console.log(failures.length === 0 ? 'passed' : `${failures.length} failed`);
  process.exit(failures.length === 0 ? 0 : 1);
}
