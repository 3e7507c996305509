/** Colours of the theme for canvases, read from the style sheet. */

/** What canvases draw with. */
export interface Ink {
  surface: string;
  text: string;
  muted: string;
  line: string;
  strong: string;
  accent: string;
  accentWeak: string;
  warn: string;
  warnWeak: string;
  bad: string;
  good: string;
  goodWeak: string;
  /** Of lines that are told apart, in their order. */
  series: string[];
  font: string;
}

/** Colours of lines in the theme. */
const SERIES = 8;

/** The colours in force at an element. */
export function inkOf(element: Element): Ink {
  const style = getComputedStyle(element);
  const token = (name: string) => style.getPropertyValue(`--${name}`).trim();
  return {
    surface: token('surface'),
    text: token('text'),
    muted: token('muted'),
    line: token('line'),
    strong: token('strong'),
    accent: token('accent'),
    accentWeak: token('accent-weak'),
    warn: token('warn'),
    warnWeak: token('warn-weak'),
    bad: token('bad'),
    good: token('good'),
    goodWeak: token('good-weak'),
    series: Array.from({ length: SERIES }, (_, index) => token(`series-${index + 1}`)),
    font: `11px ${style.fontFamily}`,
  };
}
