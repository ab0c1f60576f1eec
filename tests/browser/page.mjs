// A page of Chromium without a network, that remembers what went wrong on it.

import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import puppeteer from 'puppeteer-core';

export async function withChromium(executablePath, use) {
  const userDataDir = mkdtempSync(join(tmpdir(), 'ffstudy-browser-'));
  const browser = await puppeteer.launch({
    executablePath, userDataDir, protocolTimeout: 300_000,
    args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
           '--disable-component-update', '--disable-sync', '--force-color-profile=srgb'],
  });
  try {
    return await use(browser);
  } finally {
    await browser.close();
    rmSync(userDataDir, {recursive: true, force: true, maxRetries: 10});
  }
}

/** Opens a file. Every error, message, refused or attempted request becomes a line of `problems`. */
export async function open(browser, file, {width, height = 900, dark = false}) {
  const page = await browser.newPage();
  const url = pathToFileURL(file).href;
  const problems = [];
  page.on('console', message => problems.push(`console: ${message.text()}`));
  page.on('pageerror', error => problems.push(`error: ${error.message ?? error}`));
  page.on('request', request => {
    const to = request.url().split('#')[0];
    if (to !== url && !to.startsWith('blob:')) problems.push(`request: ${to.slice(0, 100)}`);
  });
  await page.setOfflineMode(true);
  await page.setViewport({width, height});
  await page.emulateMediaFeatures([{name: 'prefers-color-scheme', value: dark ? 'dark' : 'light'}]);
  await page.goto(url, {waitUntil: 'load'});
  return {page, problems};
}

/** Opens all parts of a page that can be closed, but for the data of pictures, and groups of pictures beyond the first 30. */
export async function unfold(page) {
  await page.evaluate(() => {
    let pictures = document.querySelectorAll('figure.picture').length
                   - document.querySelectorAll('details:not([open]) figure.picture').length;
    for (const details of document.querySelectorAll('details:not(.data, [open])')) {
      pictures += details.querySelectorAll('figure.picture').length;
      if (pictures <= 30) details.open = true;
    }
  });
}

/** Scrolls every picture that is not closed into view until it is drawn; the ids of those that never are. */
export async function drawAll(page) {
  const ids = await page.$$eval('figure.picture', figures => figures
    .filter(figure => !figure.closest('details:not([open])')).map(figure => figure.id));
  const missing = [];
  for (const id of ids) {
    await page.evaluate(id => document.getElementById(id).scrollIntoView({block: 'center'}), id);
    await page.waitForFunction(id => document.getElementById(id).dataset.drawn === 'true', {timeout: 20_000}, id)
      .catch(() => missing.push(id));
  }
  await page.evaluate(() => window.scrollTo(0, 0));
  return missing;
}
