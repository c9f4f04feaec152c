autocmd BufRead,BufNewFile *.cx setfiletype calyx
