// Grid of viewers of equal size.

import { useEffect, useState } from "preact/hooks";

export interface Size {
  width: number;
  height: number;
}

export interface Grid {
  columns: number;
  rows: number;
}

/** Ratio of width and height of a viewer that shows most of a scene. */
const RATIO = 1.4;

/** Returns the grid of at most `count` cells, not smaller than `smallest`, in which the cells have the largest useful size. */
export function bestGrid(count: number, { width, height }: Size, smallest: Size): Grid {
  const most = {
    columns: Math.max(1, Math.floor(width / smallest.width)),
    rows: Math.max(1, Math.floor(height / smallest.height)),
  };
  const fitting = Math.max(1, Math.min(count, most.columns * most.rows));
  let best: Grid = { columns: Math.min(most.columns, fitting), rows: 1 };
  let largest = 0;
  for (let columns = 1; columns <= Math.min(most.columns, fitting); columns++) {
    const rows = Math.ceil(fitting / columns);
    if (rows > most.rows) continue;
    const usefulHeight = Math.min(height / rows, width / columns / RATIO);
    if (usefulHeight > largest) {
      largest = usefulHeight;
      best = { columns, rows };
    }
  }
  return best;
}

/** Returns the size of an element, px. */
export function useSize(element: { current: HTMLElement | null }): Size {
  const [size, setSize] = useState<Size>({ width: 0, height: 0 });
  useEffect(() => {
    if (!element.current) return;
    const observer = new ResizeObserver(([entry]) => {
      if (!entry) return;
      const { width, height } = entry.contentRect;
      setSize((before) => (before.width === width && before.height === height ? before : { width, height }));
    });
    observer.observe(element.current);
    return () => observer.disconnect();
  }, []);
  return size;
}
