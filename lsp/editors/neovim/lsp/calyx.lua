-- For Neovim 0.11 and later without `setup`: `vim.lsp.enable('calyx')` reads this file.

return {
  cmd = { 'calyx', 'lsp' },
  filetypes = { 'calyx' },
  root_markers = { '.git' },
}
