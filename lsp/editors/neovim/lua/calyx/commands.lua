-- Running a model and explaining its plan, from the command line of Neovim and from code lenses.

local client = require('calyx.client')

local M = {}

local function request(command, uri, answer, ...)
  local buffer = vim.uri_to_bufnr(uri)
  local server = client.clients(buffer)[1] or client.clients()[1]
  if not server then
    vim.notify('calyx: the server is not running', vim.log.levels.WARN)
    return
  end
  local function handler(problem, result)
    if problem then
      vim.notify('calyx: ' .. (problem.message or vim.inspect(problem)), vim.log.levels.ERROR)
    elseif answer then
      answer(result)
    end
  end
  local params = { command = command, arguments = { uri, ... } }
  -- A method since Neovim 0.11, a function before.
  if vim.fn.has('nvim-0.11') == 1 then
    server:request('workspace/executeCommand', params, handler, buffer)
  else
    server.request('workspace/executeCommand', params, handler, buffer)
  end
end

local function here()
  return vim.uri_from_bufnr(0)
end

--- Shows a read-only text next to the model; replaces the previous one.
local function show(name, text)
  local buffer = vim.fn.bufnr('^' .. name .. '$')
  if buffer < 0 then
    buffer = vim.api.nvim_create_buf(false, true)
    vim.api.nvim_buf_set_name(buffer, name)
    vim.bo[buffer].bufhidden = 'wipe'
  end
  vim.bo[buffer].modifiable = true
  vim.api.nvim_buf_set_lines(buffer, 0, -1, false, vim.split(text, '\n'))
  vim.bo[buffer].modifiable = false
  if vim.fn.bufwinid(buffer) < 0 then
    local window = vim.api.nvim_get_current_win()
    vim.cmd('vertical sbuffer ' .. buffer)
    vim.api.nvim_set_current_win(window)
  end
end

local function save(uri)
  local buffer = vim.uri_to_bufnr(uri)
  if vim.bo[buffer].modified then
    vim.api.nvim_buf_call(buffer, function() vim.cmd('silent write') end)
  end
end

--- Saves the model and runs it. The server shows the results as inlay hints and messages.
function M.run(uri)
  uri = uri or here()
  save(uri)
  request('calyx.run', uri)
end

--- Saves the model and runs one of its tests.
function M.test(uri, name)
  save(uri)
  request('calyx.test', uri, nil, name)
end

--- Shows the plan of the analysis: the modelling decisions and their reasons.
function M.plan(uri)
  uri = uri or here()
  request('calyx.plan', uri, function(text)
    if type(text) == 'string' then
      show('calyx-plan://' .. vim.fn.fnamemodify(vim.uri_to_fname(uri), ':t:r'), text)
    end
  end)
end

--- Stops the run of the model.
function M.cancel(uri)
  request('calyx.cancel', uri or here())
end

function M.register()
  local command = vim.api.nvim_create_user_command
  command('CalyxRun', function() M.run() end, { desc = 'Save the model and run it' })
  command('CalyxPlan', function() M.plan() end, { desc = 'Show what the engine would model' })
  command('CalyxCancel', function() M.cancel() end, { desc = 'Stop the run of the model' })
  -- Handlers of code lenses, whose first argument is the model.
  vim.lsp.commands['calyx.run'] = function(lens) M.run(lens.arguments[1]) end
  vim.lsp.commands['calyx.plan'] = function(lens) M.plan(lens.arguments[1]) end
  vim.lsp.commands['calyx.test'] = function(lens) M.test(lens.arguments[1], lens.arguments[2]) end
end

return M
