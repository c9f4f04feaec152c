-- Configuration of the tested editor: this plugin, no user configuration, and the server given by
-- the environment variable CALYX.

local plugin = vim.fn.fnamemodify(debug.getinfo(1, 'S').source:sub(2), ':p:h:h')
vim.opt.runtimepath:prepend(plugin)
vim.opt.swapfile = false
vim.opt.completeopt = { 'menuone', 'noselect' }
vim.cmd('filetype plugin indent on')
vim.cmd('syntax on')

-- State that the session checks.
_G.seen = { published = 0, messages = {} }

local publish = vim.lsp.handlers['textDocument/publishDiagnostics']
vim.lsp.handlers['textDocument/publishDiagnostics'] = function(...)
  seen.published = seen.published + 1
  return publish(...)
end
vim.lsp.handlers['window/showMessage'] = function(_, result)
  table.insert(seen.messages, result.message)
end

require('calyx').setup({
  cmd = { os.getenv('CALYX') or 'calyx', 'lsp' },
  on_exit = function(code, signal) vim.g.calyx_exit = code .. ' ' .. signal end,
})
