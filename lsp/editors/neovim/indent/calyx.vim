" Indentation while typing; what stands in the end is the formatter's.

if exists('b:did_indent')
  finish
endif
let b:did_indent = 1

setlocal indentexpr=v:lua.require'calyx.indent'.line(v:lnum)
setlocal indentkeys=0{,0},0),0],!^F,o,O,0=case,0=default
setlocal nosmartindent nocindent

let b:undo_indent = 'setlocal indentexpr< indentkeys<'
