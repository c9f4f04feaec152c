-- Indentation on typing, as in the formatter: one step for each line with unclosed brackets, one
-- for a continuation line, one below a `case`.

local M = {}

local STEP = 4
-- Largest number of lines that are searched for an unclosed bracket.
local REACH = 1000

--- Returns a line without strings, comments and surrounding blanks. Strings end on their line.
local function code(number)
  local line = vim.fn.getline(number):gsub('\\.', '')
  line = line:gsub('"[^"]*"?', '""'):gsub('/%*.-%*/', ''):gsub('//.*$', '')
  return vim.trim(line)
end

local CLOSES = { [')'] = '(', [']'] = '[', ['}'] = '{' }

--- Returns the innermost unclosed bracket before a line: its line and the bracket.
local function opener(number)
  local closed = 0
  for above = number - 1, math.max(1, number - REACH), -1 do
    local line = code(above)
    for at = #line, 1, -1 do
      local character = line:sub(at, at)
      if CLOSES[character] then
        closed = closed + 1
      elseif character:match('[%(%[{]') then
        if closed == 0 then
          return above, character
        end
        closed = closed - 1
      end
    end
  end
  return 0, nil
end

--- Returns the next line above, but below `limit`, that is not only a comment.
local function line_before(number, limit)
  for above = number - 1, limit + 1, -1 do
    local line = code(above)
    if line ~= '' then
      return line
    end
  end
  return nil
end

--- Returns the indentation of a line in columns.
function M.line(number)
  local at, bracket = opener(number)
  local here = code(number)
  local base = at > 0 and vim.fn.indent(at) or -STEP
  if here:match('^[%)%]}]') then
    return math.max(base, 0)
  end
  base = base + STEP
  if bracket == '{' and code(at):match('^switch%f[^%w_]') then
    if here:match('^case%f[^%w_]') or here:match('^default%f[^%w_]') then
      return base
    end
    base = base + STEP
  end
  local before = line_before(number, at)
  -- The line after a header such as `else` or `if (...)` is a continuation, unless it is a block.
  if before and not before:match('[;{},:]$') and not here:match('^{') then
    return base + STEP
  end
  return base
end

return M
