-- Indentation while typing, as the formatter has it: a step for each line that leaves brackets open, one for what goes on from the
-- line before, one below a `case`.

local M = {}

local STEP = 4
-- Further back than any bracket is open.
local REACH = 1000

--- A line without strings, comments and blanks around it. Strings end on their line.
local function code(number)
  local line = vim.fn.getline(number):gsub('\\.', '')
  line = line:gsub('"[^"]*"?', '""'):gsub('/%*.-%*/', ''):gsub('//.*$', '')
  return vim.trim(line)
end

local CLOSES = { [')'] = '(', [']'] = '[', ['}'] = '{' }

--- Of the brackets that are open before a line, the innermost: its line and the bracket.
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

--- The next line above that is not only a comment, but below `limit`.
local function line_before(number, limit)
  for above = number - 1, limit + 1, -1 do
    local line = code(above)
    if line ~= '' then
      return line
    end
  end
  return nil
end

--- How many columns a line is to be indented.
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
  -- A header such as `else` or `if (...)` goes on as an operator does, but a block stands below it.
  if before and not before:match('[;{},:]$') and not here:match('^{') then
    return base + STEP
  end
  return base
end

return M
