-- Configuration that `vim.lsp.enable('calyx')` reads, for Neovim 0.11 and later without `setup`.

return {
  cmd = { 'calyx', 'lsp' },
  filetypes = { 'calyx' },
  root_markers = { '.git' },
}
