"""Mistakes in a program. ``mistake-KIND`` says what is wrong, ``hint-...`` what would put it right.

The most important word comes first; what was found is quoted as it was typed, words of GoDonnie are in
the learner's language.
"""

from donnie_tui.i18n.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    # --- around a mistake
    "error-at": Sentence(
        "Error, line {line}, column {column}: {message}",
        "Erro, linha {line}, coluna {column}: {message}",
        "Error, línea {line}, columna {column}: {message}",
        brief=(
            "Error, line {line}: {message}",
            "Erro, linha {line}: {message}",
            "Error, línea {line}: {message}",
        ),
    ),
    "error-line": Sentence("Line {line}: {text}", "Linha {line}: {text}", "Línea {line}: {text}"),
    "called-from": Sentence(
        "Called from line {line}.", "Chamado na linha {line}.", "Llamado en la línea {line}."
    ),
    "internal-error": Sentence(
        "Something went wrong inside Donnie.",
        "Algo deu errado dentro do Donnie.",
        "Algo salió mal dentro de Donnie.",
    ),
    "more-mistakes": Sentence(
        "Only the first {limit} mistakes are told.",
        "Só conto os primeiros {limit} erros.",
        "Solo digo los primeros {limit} errores.",
    ),
    # --- form
    "mistake-syntax": Sentence(
        "I expected {expected}, not {found}.",
        "Esperava {expected}, não {found}.",
        "Esperaba {expected}, no {found}.",
    ),
    "mistake-syntax-at-end": Sentence(
        "Missing at the end: {expected}.", "Falta no fim: {expected}.", "Falta al final: {expected}."
    ),
    "mistake-syntax-misplaced": Sentence(
        "I did not expect {found} here.", "Não esperava {found} aqui.", "No esperaba {found} aquí."
    ),
    "mistake-syntax-cut-off": Sentence(
        "The program ends too early.", "O programa acaba cedo demais.", "El programa acaba demasiado pronto."
    ),
    "mistake-syntax-stray-else": Sentence(
        "{found} belongs to no {IF}.", "{found} não pertence a nenhum {IF}.", "{found} no es de ningún {IF}."
    ),
    "mistake-syntax-text-plus": Sentence(
        "A text can't be calculated with.",
        "Não dá para fazer conta com um texto.",
        "Con un texto no se puede calcular.",
    ),
    "mistake-syntax-two-equals": Sentence(
        "A value is given with one equals sign.",
        "O valor se dá com um só igual.",
        "El valor se da con un solo igual.",
    ),
    "mistake-syntax-single-equals": Sentence(
        "Here two values are compared.", "Aqui dois valores são comparados.", "Aquí se comparan dos valores."
    ),
    "mistake-unknown-command": Sentence(
        "I do not know {found}.", "Não conheço {found}.", "No conozco {found}."
    ),
    "mistake-unknown-command-procedure": Sentence(
        "{found} is a procedure.", "{found} é um procedimento.", "{found} es un procedimiento."
    ),
    "mistake-unknown-character": Sentence(
        "I can't use {sign} here.", "Não posso usar {sign} aqui.", "No puedo usar {sign} aquí."
    ),
    "mistake-unterminated-string": Sentence(
        "This text has no closing quote.",
        "Falta fechar as aspas deste texto.",
        "Falta cerrar las comillas de este texto.",
    ),
    "mistake-invalid-name": Sentence(
        "{found} is no name.", "{found} não é um nome.", "{found} no es un nombre."
    ),
    "mistake-reserved-word": Sentence(
        "{found} is a word of GoDonnie.",
        "{found} é uma palavra de GoDonnie.",
        "{found} es una palabra de GoDonnie.",
    ),
    "mistake-bad-argument": Sentence(
        "I do not know {found} here.", "Não conheço {found} aqui.", "No conozco {found} aquí."
    ),
    "mistake-bad-argument-of": Sentence(
        "{word} can't take {found}.", "{word} não aceita {found}.", "{word} no acepta {found}."
    ),
    "mistake-bad-argument-missing-argument": Sentence(
        "{word} needs {expected}.", "{word} precisa de {expected}.", "{word} necesita {expected}."
    ),
    "mistake-bad-argument-unseen-colour": Sentence(
        "The robot does not see {found}.", "O robô não vê {found}.", "El robot no ve {found}."
    ),
    "mistake-missing-end": Sentence(
        "{opener} has no {closer}.", "{opener} não tem {closer}.", "{opener} no tiene {closer}."
    ),
    "mistake-wrong-end": Sentence(
        "{found} does not close {opener} of line {opener_line}.",
        "{found} não fecha {opener} da linha {opener_line}.",
        "{found} no cierra {opener} de la línea {opener_line}.",
    ),
    "mistake-wrong-end-nothing-open": Sentence(
        "{found} closes nothing.", "{found} não fecha nada.", "{found} no cierra nada."
    ),
    "mistake-too-deep": Sentence(
        "Too many things in each other.",
        "Coisas demais uma dentro da outra.",
        "Demasiadas cosas una en otra.",
    ),
    "mistake-too-deep-blocks": Sentence(
        "Too many blocks in blocks.", "Blocos demais dentro de blocos.", "Demasiados bloques en bloques."
    ),
    "mistake-too-deep-parentheses": Sentence(
        "Too many parentheses in each other.",
        "Parênteses demais um dentro do outro.",
        "Demasiados paréntesis uno en otro.",
    ),
    "mistake-too-deep-expression": Sentence(
        "This calculation is too long.", "Esta conta é longa demais.", "Este cálculo es demasiado largo."
    ),
    "mistake-number-too-large": Sentence(
        "This number is too large.", "Este número é grande demais.", "Este número es demasiado grande."
    ),
    # --- meaning
    "mistake-undeclared-variable": Sentence(
        "There is no variable {name}.", "Não existe a variável {name}.", "No existe la variable {name}."
    ),
    "mistake-undeclared-variable-in-procedure": Sentence(
        "{name} is not known in {in_procedure}.",
        "{name} não é conhecida em {in_procedure}.",
        "{name} no se conoce en {in_procedure}.",
    ),
    "mistake-undeclared-procedure": Sentence(
        "There is no procedure {name} yet.",
        "Ainda não existe o procedimento {name}.",
        "Aún no existe el procedimiento {name}.",
    ),
    "mistake-already-declared": Sentence(
        "{found} exists already.", "{found} já existe.", "{found} ya existe."
    ),
    "mistake-already-declared-before": Sentence(
        "{found} exists already, from line {first_line}.",
        "{found} já existe, da linha {first_line}.",
        "{found} ya existe, de la línea {first_line}.",
    ),
    "mistake-wrong-argument-count": Sentence(
        "{name} takes {wanted} {wanted:value|values}, not {given}.",
        "{name} recebe {wanted} {wanted:valor|valores}, não {given}.",
        "{name} recibe {wanted} {wanted:valor|valores}, no {given}.",
    ),
    "mistake-division-by-zero": Sentence(
        "I can't divide by zero.", "Não posso dividir por zero.", "No puedo dividir por cero."
    ),
    "mistake-recursion-limit": Sentence(
        "{name} calls itself too often.",
        "{name} chama a si mesmo demais.",
        "{name} se llama demasiadas veces.",
    ),
    "mistake-terminal-only": Sentence(
        "{found} works in the terminal only.",
        "{found} só funciona no terminal.",
        "{found} solo funciona en la terminal.",
    ),
    "mistake-belt-off": Sentence("The belt is off.", "O cinto está desligado.", "El cinturón está apagado."),
    "mistake-robot": Sentence(
        "The robot can't do that.", "O robô não consegue fazer isso.", "El robot no puede hacer eso."
    ),
    "mistake-unused-value": Sentence(
        "{word} alone tells nothing.", "{word} sozinho não diz nada.", "{word} solo no dice nada."
    ),
    "mistake-unused-value-steps": Sentence(
        "A number below 0 moves nothing here.",
        "Um número menor que 0 não move nada.",
        "Un número menor que 0 no mueve nada.",
    ),
    # --- what would put it right
    "hint-meant": Sentence(
        "Did you mean {meant}?", "Você quis dizer {meant}?", "Quizá querías decir {meant}."
    ),
    "hint-procedure": Sentence("Call it {call}.", "Chame assim: {call}.", "Llámalo así: {call}."),
    "hint-call-brackets": Sentence(
        "A procedure is called {found} [1].",
        "Um procedimento se chama {found} [1].",
        "Un procedimiento se llama {found} [1].",
    ),
    "hint-text-plus": Sentence(
        "Write another {SPEAK} for the rest.",
        "Escreva outro {SPEAK} para o resto.",
        "Escribe otro {SPEAK} para el resto.",
    ),
    "hint-whole-numbers": Sentence(
        "Numbers are whole, such as 2.",
        "Os números são inteiros, como 2.",
        "Los números son enteros, como 2.",
    ),
    "hint-head-end": Sentence(
        "Write {missing} before {found}.",
        "Escreva {missing} antes de {found}.",
        "Escribe {missing} antes de {found}.",
    ),
    "hint-head-end-before": Sentence(
        "{missing} belongs at the end of line {line}.",
        "{missing} vai no fim da linha {line}.",
        "{missing} va al final de la línea {line}.",
    ),
    "hint-different": Sentence(
        "Different is written <>.", "Diferente se escreve <>.", "Distinto se escribe <>."
    ),
    "hint-double-quotes": Sentence(
        "Text stands between double quotes.",
        "O texto fica entre aspas duplas.",
        "El texto va entre comillas dobles.",
    ),
    "hint-invalid-name": Sentence(
        "A name begins with a letter.", "Um nome começa com uma letra.", "Un nombre empieza con una letra."
    ),
    "hint-reserved-word": Sentence("Choose another name.", "Escolha outro nome.", "Elige otro nombre."),
    "hint-words": Sentence("It takes {words}.", "Aceita {words}.", "Acepta {words}."),
    "hint-write-closer": Sentence(
        "Write {closer} where it ends.", "Escreva {closer} onde ele acaba.", "Escribe {closer} donde acaba."
    ),
    "hint-expected-closer": Sentence(
        "Here belongs {closer}.", "Aqui o certo é {closer}.", "Aquí va {closer}."
    ),
    "hint-at-most": Sentence("At most {limit}.", "No máximo {limit}.", "Como máximo {limit}."),
    "hint-digits": Sentence(
        "At most {limit} digits.", "No máximo {limit} algarismos.", "Como máximo {limit} cifras."
    ),
    "hint-declare": Sentence(
        "Write {var} {name} first.", "Escreva antes {var} {name}.", "Escribe antes {var} {name}."
    ),
    "hint-own-variables": Sentence(
        "A procedure sees only its own variables.",
        "Um procedimento só vê suas variáveis.",
        "Un procedimiento solo ve sus variables.",
    ),
    "hint-declare-procedure": Sentence(
        "Its {procedure} must come before the call.",
        "O {procedure} dele deve vir antes da chamada.",
        "Su {procedure} debe ir antes de la llamada.",
    ),
    "hint-call-depth": Sentence(
        "At most {limit} calls in each other.",
        "No máximo {limit} chamadas aninhadas.",
        "Como máximo {limit} llamadas anidadas.",
    ),
    "hint-terminal-only": Sentence(
        "A file ends by itself.", "Um arquivo acaba sozinho.", "Un archivo acaba por sí solo."
    ),
    "hint-change-it": Sentence(
        "To change it, leave out {VAR}.", "Para mudar, tire {VAR}.", "Para cambiarla, quita {VAR}."
    ),
    "hint-belt-on": Sentence(
        "{belt} {on} switches it on.", "{belt} {on} liga o cinto.", "{belt} {on} lo enciende."
    ),
    "hint-speak-it": Sentence(
        "{speak} {value} says the number.", "{speak} {value} diz o número.", "{speak} {value} dice el número."
    ),
    # --- lists and classes of words
    "or": Sentence("{first} or {last}", "{first} ou {last}", "{first} o {last}"),
    "and": Sentence("{first} and {last}", "{first} e {last}", "{first} y {last}"),
    "and-before-i": Sentence("{first} and {last}", "{first} e {last}", "{first} e {last}"),
    "class-number": Sentence("a number", "um número", "un número"),
    "class-name": Sentence("a name", "um nome", "un nombre"),
    "class-expression": Sentence("a value", "um valor", "un valor"),
    "class-text": Sentence("a text", "um texto", "un texto"),
    "class-command": Sentence("a command", "um comando", "un comando"),
    "class-comparison": Sentence("a comparison", "uma comparação", "una comparación"),
    "class-direction": Sentence("a direction", "uma direção", "una dirección"),
    "class-axis": Sentence("X, Y or A", "X, Y ou A", "X, Y o A"),
    "class-colour": Sentence("a colour", "uma cor", "un color"),
    "class-operator": Sentence("an operator", "um operador", "un operador"),
    "class-end-of-text": Sentence("the end", "o fim", "el final"),
}
