# Makes a literal of the file `from`, written to `to`.
file(READ ${from} text)
file(WRITE ${to} "R\"text(${text})text\"\n")
