// Tables and figures that every report has.
import { byId, make, number, title } from './text.js';

/** @param {[string, string][]} facts */
export function showFacts(facts) {
  byId('facts').append(...facts.map(([what, value]) => {
    const fact = make('div');
    fact.append(make('dt', what), make('dd', value));
    return fact;
  }));
}

/** Rows without a value are left out. */
export function fillTable(id, rows) {
  byId(id).tBodies[0].append(...rows.filter(([, value]) => value !== undefined && value !== null).map(([what, value]) => {
    const row = make('tr');
    row.append(make('th', what, { scope: 'row' }), make('td', value));
    return row;
  }));
}

export function settingsTable(run, poses) {
  const settings = Object.entries(run.settings);
  const withUnit = value => typeof value === 'object' && value !== null ? `${number(value.value, 9)}${value.unit === '1' ? '' : ` ${value.unit}`}` : value;
  const isPlace = key => /_(x|y|z)$/.test(key);
  const places = [...new Set(settings.filter(([key]) => isPlace(key)).map(([key]) => key.slice(0, -2)))];
  byId('settings-note').hidden = poses.varying.length === 0;
  fillTable('settings', [
    ['Scene or mesh file', run.scene?.path], ['Target', run.scene?.target], ['Objects', number(run.scene?.objects)], ['Triangles', number(run.scene?.triangles)],
    ['Command', run.command?.join(' ')],
    ...settings.filter(([key]) => !isPlace(key)).map(([key, value]) => [title(key), withUnit(value)]),
    ...places.map(key => [title(key), `${['x', 'y', 'z'].map(axis => number(run.settings[`${key}_${axis}`]?.value, 7)).join(', ')}${run.settings[`${key}_x`]?.unit === 'm' ? ' m' : ''}`]),
    ['Device', run.device?.name], ['Interface', run.device?.graphics_api], ['Glint', run.versions?.glint], ['Unity', run.versions?.unity], ['Program', run.versions?.host], ['Operating system', run.versions?.operating_system]
  ]);
}
