// Style sheets are imported for their effect: esbuild collects them in a file of their own.
declare module "*.css";
