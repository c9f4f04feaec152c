-- Starts the server and attaches buffers, on Neovim 0.7 and later. Missing functions of older
-- versions are implemented here.

local M = {}

--- Root folder of a file: its repository, else its own folder.
function M.root(file)
  local folder = vim.fn.fnamemodify(file, ':p:h')
  local git = vim.fn.finddir('.git', vim.fn.escape(folder, ' ') .. ';')
  if git == '' then
    git = vim.fn.findfile('.git', vim.fn.escape(folder, ' ') .. ';')
  end
  return git == '' and folder or vim.fn.fnamemodify(git, ':p:h:h')
end

--- Configuration for `vim.lsp.start_client` and its successors.
function M.config(options)
  local config = vim.tbl_deep_extend('force', {
    name = 'calyx',
    cmd = { 'calyx', 'lsp' },
    capabilities = vim.lsp.protocol.make_client_capabilities(),
  }, options or {})
  config.filetypes = nil
  return config
end

--- Clients of this server.
function M.clients(buffer)
  local found = {}
  local list
  if vim.lsp.get_clients then
    list = vim.lsp.get_clients({ name = 'calyx', bufnr = buffer })
  elseif buffer then
    list = vim.tbl_values(vim.lsp.buf_get_clients(buffer))
  else
    list = vim.lsp.get_active_clients()
  end
  for _, client in ipairs(list) do
    if client.name == 'calyx' then
      table.insert(found, client)
    end
  end
  return found
end

local function executable(config)
  local program = config.cmd[1]
  if vim.fn.executable(program) == 1 then
    return true
  end
  local message = 'calyx: `' .. program .. '` is not a program on the PATH. '
    .. 'Install it with `cargo install --path compiler` in a copy of Calyx, or name it: '
    .. 'require("calyx").setup({ cmd = { "/path/to/calyx", "lsp" } })'
  vim.notify_once(message, vim.log.levels.WARN)
  return false
end

--- Returns true if a buffer shows a file; false for a terminal or one side of a diff.
local function is_file(buffer)
  return vim.bo[buffer].buftype == '' and not vim.api.nvim_buf_get_name(buffer):match('^%a+://')
end

--- Root folder of a buffer. Library files opened from a model belong to the server that returned
--- them.
local function root_of(buffer)
  local file = vim.api.nvim_buf_get_name(buffer)
  local running = M.clients()[1]
  if running and file:match('/calyx/library%-') then
    return running.config.root_dir
  end
  return M.root(file)
end

--- Configuration for `vim.lsp.config` of Neovim 0.11.
function M.configuration(options)
  local config = M.config(options)
  config.filetypes = { 'calyx' }
  config.root_dir = config.root_dir or function(buffer, use)
    if is_file(buffer) and executable(config) then
      use(root_of(buffer))
    end
  end
  return config
end

--- Starts the server for a buffer, or attaches the buffer to the server of its root folder.
function M.start(options, buffer)
  local config = M.config(options)
  if not is_file(buffer) or not executable(config) then
    return
  end
  config.root_dir = config.root_dir or root_of(buffer)
  if vim.lsp.start then
    vim.lsp.start(config, { bufnr = buffer })
    return
  end
  for _, client in ipairs(M.clients()) do
    if client.config.root_dir == config.root_dir then
      vim.lsp.buf_attach_client(buffer, client.id)
      return
    end
  end
  local id = vim.lsp.start_client(config)
  if id then
    vim.lsp.buf_attach_client(buffer, id)
  end
end

--- Starts the server for every open model.
function M.start_all(options)
  for _, buffer in ipairs(vim.api.nvim_list_bufs()) do
    if vim.api.nvim_buf_is_loaded(buffer) and vim.bo[buffer].filetype == 'calyx' then
      M.start(options, buffer)
    end
  end
end

--- Stops the server; buffers remain unchanged.
function M.stop()
  for _, client in ipairs(M.clients()) do
    -- A method since Neovim 0.11, a function before.
    if vim.fn.has('nvim-0.11') == 1 then
      client:stop()
    else
      client.stop()
    end
  end
end

return M
