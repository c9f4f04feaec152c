-- Calyx in Neovim 0.7 and later: `require('calyx').setup()`.

local client = require('calyx.client')
local commands = require('calyx.commands')

local M = {}

--- Options of `setup` with their defaults. Options of `vim.lsp.start_client` are accepted too.
M.defaults = {
  cmd = { 'calyx', 'lsp' },
  -- The default mappings of Neovim 0.11, in older versions too, and `gd`.
  mappings = true,
  -- Types, dimensions and names of parameters as inlay hints (Neovim 0.10 and later).
  inlay_hints = true,
  -- The code lenses Run and Plan above a model.
  code_lens = true,
}

-- Default highlight groups of semantic tokens; a colour scheme may override them.
local HIGHLIGHTS = {
  ['@lsp.type.unit.calyx'] = 'Special',
  ['@lsp.type.label.calyx'] = 'Label',
  ['@lsp.mod.param.calyx'] = 'Constant',
  ['@lsp.mod.output.calyx'] = 'Constant',
}

local function map(buffer)
  local function key(mode, keys, action, what)
    if vim.fn.maparg(keys, mode) == '' then
      vim.keymap.set(mode, keys, action, { buffer = buffer, desc = what })
    end
  end
  local lsp = vim.lsp.buf
  key('n', 'K', lsp.hover, 'What stands here')
  key('n', 'gd', lsp.definition, 'Go to the definition')
  key('n', 'grn', function() lsp.rename() end, 'Rename')
  key('n', 'gra', function() lsp.code_action() end, 'Fix')
  key('n', 'grr', function() lsp.references() end, 'References')
  key('n', 'gO', function() lsp.document_symbol() end, 'Outline')
  key('i', '<C-s>', function() lsp.signature_help() end, 'Parameters of the call')
end

local function show_lenses(buffer)
  local group = vim.api.nvim_create_augroup('calyx.lens.' .. buffer, { clear = true })
  vim.api.nvim_create_autocmd({ 'BufEnter', 'InsertLeave', 'BufWritePost' }, {
    group = group,
    buffer = buffer,
    callback = function()
      if client.clients(buffer)[1] then
        vim.lsp.codelens.refresh(vim.fn.has('nvim-0.10') == 1 and { bufnr = buffer } or nil)
      end
    end,
  })
end

--- Configures a buffer when the server attaches to it.
function M.attached(options, server, buffer)
  vim.bo[buffer].omnifunc = 'v:lua.vim.lsp.omnifunc'
  vim.bo[buffer].tagfunc = 'v:lua.vim.lsp.tagfunc'
  vim.bo[buffer].formatexpr = 'v:lua.vim.lsp.formatexpr()'
  if options.mappings then
    map(buffer)
  end
  if options.inlay_hints and vim.lsp.inlay_hint and vim.lsp.inlay_hint.enable then
    vim.lsp.inlay_hint.enable(true, { bufnr = buffer })
  end
  -- Neovim 0.7 has another name for this table and has handled it already.
  local capabilities = server.server_capabilities or {}
  if options.code_lens and capabilities.codeLensProvider then
    show_lenses(buffer)
  end
end

--- Adds the attach hook to the options; the user's own hook runs after it.
function M.options(given)
  local options = vim.tbl_extend('force', M.defaults, given or {})
  local own = options.on_attach
  options.on_attach = function(server, buffer)
    M.attached(options, server, buffer)
    if own then
      own(server, buffer)
    end
  end
  return options
end

local function for_server(options)
  local config = vim.tbl_extend('force', {}, options)
  for name in pairs(M.defaults) do
    if name ~= 'cmd' then
      config[name] = nil
    end
  end
  return config
end

function M.setup(given)
  local config = for_server(M.options(given))
  -- Neovim before 0.9 has neither semantic tokens nor these group names.
  if vim.lsp.semantic_tokens then
    for group, link in pairs(HIGHLIGHTS) do
      vim.api.nvim_set_hl(0, group, { link = link, default = true })
    end
  end
  -- Highlights code blocks in hover texts and Markdown.
  local fenced = vim.g.markdown_fenced_languages or {}
  vim.g.markdown_fenced_languages = vim.list_extend({ 'cx=calyx', 'calyx' }, fenced)
  commands.register()
  vim.api.nvim_create_user_command('CalyxRestart', function()
    client.stop()
    vim.defer_fn(function() client.start_all(config) end, 500)
  end, { desc = 'Stop the server and start it anew' })
  if vim.lsp.config and vim.lsp.enable then
    vim.lsp.config('calyx', client.configuration(config))
    vim.lsp.enable('calyx')
    return
  end
  vim.api.nvim_create_autocmd('FileType', {
    group = vim.api.nvim_create_augroup('calyx', { clear = true }),
    pattern = 'calyx',
    callback = function(event) client.start(config, event.buf) end,
  })
end

return M
