// What of Vega a drawn picture needs; bundled into vega.js for report.html, and into draw_svg.mjs.
export {View} from 'vega-view';
export {parse} from 'vega-parser';
export {expressionInterpreter} from 'vega-interpreter';
export {prepare, resize, settle} from './picture.js';
import {transforms} from 'vega-dataflow';
import {extend} from 'vega-util';
import * as encodings from 'vega-encode';
import * as data from 'vega-transforms';
import * as views from 'vega-view-transforms';

extend(transforms, data, views, encodings);
