-- Headless session: an outer Neovim types into an inner one, which uses the real server.
--
--   CALYX=target/debug/calyx nvim --headless -u NONE -c 'luafile lsp/editors/neovim/tests/session.lua'
--
-- Prints one line per step and exits with status 1 at the first failure. The model is opened from
-- `examples/` and never written.

local here = vim.fn.fnamemodify(debug.getinfo(1, 'S').source:sub(2), ':p:h')
local model = vim.fn.fnamemodify(here .. '/../../../../examples/spur_pair.cx', ':p')
local patience = tonumber(os.getenv('CALYX_PATIENCE') or '20') * 1000

local function say(text)
  io.stdout:write(text .. '\n')
  io.stdout:flush()
end

-- The inner editor --------------------------------------------------------------------------------

local editor = vim.fn.jobstart({
  vim.v.progpath, '--embed', '--headless', '-u', here .. '/init.lua', '-i', 'NONE', model,
}, {
  rpc = true,
  on_stderr = function(_, lines)
    for _, line in ipairs(lines) do
      if line ~= '' then say('# ' .. line) end
    end
  end,
})

--- Evaluates Lua in the inner editor.
local function lua(code, ...)
  local answer = vim.rpcrequest(editor, 'nvim_exec_lua', code, { ... })
  if answer == vim.NIL then
    return nil
  end
  return answer
end

--- Types keys.
local function type_keys(keys)
  vim.rpcrequest(editor, 'nvim_input', keys)
end

local function fail(what, detail)
  say('FAILED: ' .. what)
  if detail ~= nil then
    say(type(detail) == 'string' and detail or vim.inspect(detail))
  end
  pcall(function()
    say('# messages: ' .. lua('return vim.fn.execute("messages")'))
    say('# of the server: ' .. vim.inspect(lua('return seen.messages')))
    say('# mode: ' .. vim.inspect(vim.rpcrequest(editor, 'nvim_get_mode')))
    local log = lua('return vim.lsp.get_log_path()')
    local lines = vim.fn.filereadable(log) == 1 and vim.fn.readfile(log) or {}
    say('# log:\n' .. table.concat(vim.list_slice(lines, math.max(1, #lines - 20)), '\n'))
  end)
  vim.cmd('cquit 1')
end

--- Waits until a query returns a true value, and returns that value.
local function eventually(what, ask, detail)
  local answer
  local done = vim.wait(patience, function()
    answer = ask()
    return answer
  end, 20)
  if not done then
    fail(what, detail and detail() or nil)
  end
  return answer
end

local function step(what, body)
  local began = vim.loop.hrtime()
  local fine, problem = pcall(body)
  if not fine then
    fail(what, problem)
  end
  say(string.format('ok %s (%d ms)', what, (vim.loop.hrtime() - began) / 1e6))
end

-- Queries of its state ----------------------------------------------------------------------------

local function text()
  return table.concat(vim.rpcrequest(editor, 'nvim_buf_get_lines', 0, 0, -1, false), '\n')
end

local function diagnostics()
  return lua([[
    local found = {}
    for _, d in ipairs(vim.diagnostic.get(0)) do
      local code = d.code or (d.user_data and d.user_data.lsp and d.user_data.lsp.code)
      table.insert(found, { line = d.lnum + 1, severity = d.severity, code = code, message = d.message })
    end
    return found
  ]])
end

local function errors()
  return vim.tbl_filter(function(d) return d.severity == 1 end, diagnostics())
end

--- Moves the cursor to the first occurrence of a text, `inside` characters after its start.
local function go_to(needle, inside)
  local found = lua([[
    local needle, inside = ...
    for number, line in ipairs(vim.api.nvim_buf_get_lines(0, 0, -1, false)) do
      local column = line:find(needle, 1, true)
      if column then
        vim.api.nvim_win_set_cursor(0, { number, column - 1 + inside })
        return number
      end
    end
  ]], needle, inside or 0)
  assert(found, 'the model has no `' .. needle .. '`')
  return found
end

--- Text of the floating windows, such as hover texts.
local function floats()
  return lua([[
    local texts = {}
    for _, window in ipairs(vim.api.nvim_list_wins()) do
      if vim.api.nvim_win_get_config(window).relative ~= '' then
        local lines = vim.api.nvim_buf_get_lines(vim.api.nvim_win_get_buf(window), 0, -1, false)
        table.insert(texts, table.concat(lines, '\n'))
      end
    end
    return table.concat(texts, '\n')
  ]])
end

-- The session -------------------------------------------------------------------------------------

local original

step('the model is opened, known as Calyx, and the server takes it', function()
  eventually('the server is attached', function()
    return lua("return #require('calyx.client').clients(vim.api.nvim_get_current_buf()) > 0")
  end)
  assert(lua('return vim.bo.filetype') == 'calyx', 'the file type')
  original = text()
end)

step('the model is right as it stands', function()
  eventually('diagnostics are published', function() return lua('return seen.published > 0') end)
  local wrong = diagnostics()
  assert(#wrong == 0, vim.inspect(wrong))
end)

step('indenting it anew leaves it as the formatter has it', function()
  type_keys('gg=G')
  vim.wait(200)
  assert(text() == original, text())
end)

step('a wrong unit is reported on its line, while typing', function()
  local line = go_to('pressure_angle = 20 deg')
  type_keys('/20 deg<CR>wcwmm')
  eventually('E0401 on line ' .. line, function()
    for _, d in ipairs(errors()) do
      if d.line == line and d.code == 'E0401' then return true end
    end
  end, diagnostics)
  type_keys('<Esc>u')
  eventually('the error goes when the change is undone', function() return #diagnostics() == 0 end, diagnostics)
end)

step('broken grammar is reported, and what follows stays right', function()
  local line = go_to('var speed = 3 rpm;')
  type_keys('$x')
  eventually('an error near line ' .. line, function()
    for _, d in ipairs(errors()) do
      if d.line == line or d.line == line + 1 then return #errors() == 1 end
    end
  end, diagnostics)
  type_keys('u')
  eventually('the error goes', function() return #diagnostics() == 0 end, diagnostics)
end)

step('a named argument is completed in half-typed code', function()
  go_to('tip_radius = tip_radius);')
  type_keys('Cti<C-x><C-o>')
  local items = eventually('the menu is shown', function()
    local info = lua("return vim.fn.complete_info({ 'pum_visible', 'items' })")
    return info.pum_visible == 1 and info.items
  end, text)
  -- The first item is the missing argument of the call.
  assert((items[1].abbr or items[1].word):match('^tip_radius'), vim.inspect(items[1]))
  type_keys('<C-n><C-y>')
  eventually('it is put in', function() return text():find('\n%s+tip_radius') end, text)
  type_keys('<Esc>u')
  eventually('undone', function() return text() == original end, text)
end)

step('hovering over a parameter shows its dimension', function()
  go_to('moment = torque * e3', #'moment = ')
  type_keys('K')
  eventually('a window with what `torque` is', function()
    local shown = floats()
    return shown:find('torque', 1, true) and shown:find('Moment', 1, true)
  end, floats)
  type_keys('<Esc>jk')
end)

step('a function of the library is shown in its source', function()
  go_to('gears.external(', #'gears.')
  type_keys('gd')
  eventually('the library is opened', function()
    return lua('return vim.api.nvim_buf_get_name(0)'):match('gears%.cx$')
  end, function() return lua('return vim.api.nvim_buf_get_name(0)') end)
  local line = lua('return vim.api.nvim_get_current_line()')
  assert(line:find('function external', 1, true), line)
  assert(lua("return #require('calyx.client').clients(vim.api.nvim_get_current_buf())") == 1, 'the same server has it')
  type_keys('<C-o>')
  eventually('and left again', function() return text() == original end)
end)

step('a name is renamed everywhere', function()
  local before = select(2, original:gsub('%f[%w_]steel%f[^%w_]', ''))
  go_to('var steel', #'var ')
  type_keys('grn')
  eventually('the new name is asked for', function()
    return vim.rpcrequest(editor, 'nvim_get_mode').mode:match('^c')
  end)
  type_keys('<C-u>iron<CR>')
  local renamed = eventually('it is changed', function()
    local now = text()
    return not now:find('%f[%w_]steel%f[^%w_]') and now
  end, text)
  assert(select(2, renamed:gsub('%f[%w_]iron%f[^%w_]', '')) == before, renamed)
  eventually('nothing is wrong', function() return #diagnostics() == 0 end, diagnostics)
  type_keys('u')
  eventually('undone', function() return text() == original end, text)
end)

step('a quick fix mends a misspelt name', function()
  go_to('material = steel', #'material = ')
  type_keys('cwsteal<Esc>')
  eventually('it is reported', function() return #errors() > 0 end)
  local fixed = lua([[
    local params = vim.lsp.util.make_range_params()
    params.context = { diagnostics = vim.lsp.diagnostic.get_line_diagnostics() }
    local answers = vim.lsp.buf_request_sync(0, 'textDocument/codeAction', params, 20000)
    for _, answer in pairs(answers or {}) do
      for _, action in ipairs(answer.result or {}) do
        if action.kind == 'quickfix' and action.edit then
          vim.lsp.util.apply_workspace_edit(action.edit, 'utf-16')
          return action.title
        end
      end
    end
  ]])
  assert(fixed, 'no fix is offered')
  eventually('it is right again', function() return text() == original and #diagnostics() == 0 end, text)
end)

step('an untidy model is formatted', function()
  go_to('var speed = 3 rpm;')
  type_keys('ccvar   speed=3   rpm ;<Esc>')
  eventually('it is untidy', function() return text() ~= original end)
  lua([[
    if vim.lsp.buf.format then vim.lsp.buf.format({ timeout_ms = 20000 }) else vim.lsp.buf.formatting_sync(nil, 20000) end
  ]])
  assert(text() == original, text())
end)

step('the plan of the model is shown beside it', function()
  lua("vim.cmd('CalyxPlan')")
  local plan = eventually('a window with the plan', function()
    return lua([[
      for _, window in ipairs(vim.api.nvim_list_wins()) do
        local buffer = vim.api.nvim_win_get_buf(window)
        if vim.api.nvim_buf_get_name(buffer):match('calyx%-plan') then
          return table.concat(vim.api.nvim_buf_get_lines(buffer, 0, -1, false), '\n')
        end
      end
    ]])
  end)
  assert(plan:find('pinion', 1, true), plan)
  assert(text() == original, 'the model keeps the cursor')
end)

step('the server ends when the editor does', function()
  lua([[
    require('calyx.client').stop()
  ]])
  eventually('it has ended', function() return lua('return vim.g.calyx_exit') == '0 0' end, function()
    return lua('return vim.g.calyx_exit')
  end)
  assert(#lua('return seen.messages') == 0, vim.inspect(lua('return seen.messages')))
  vim.rpcnotify(editor, 'nvim_command', 'qall!')
  assert(vim.fn.jobwait({ editor }, patience)[1] == 0, 'the editor leaves')
end)

vim.cmd('qall!')
