" How Calyx is edited, with or without the server.

if exists('b:did_ftplugin')
  finish
endif
let b:did_ftplugin = 1

setlocal commentstring=//\ %s
setlocal comments=:///,://,s1:/*,mb:*,ex:*/
setlocal formatoptions-=t formatoptions+=croql
setlocal expandtab shiftwidth=4 softtabstop=4
setlocal textwidth=100
setlocal suffixesadd=.cx
setlocal include=^\\s*import
setlocal includeexpr=substitute(v:fname,'\\.','/','g')

let b:undo_ftplugin = 'setlocal commentstring< comments< formatoptions< expandtab< shiftwidth< softtabstop<'
      \ .. ' textwidth< suffixesadd< include< includeexpr<'
