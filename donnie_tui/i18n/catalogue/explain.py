"""The kinds of mistakes again in plain words: what it means, and what to do, with an example.

``explain-KIND`` is what it means, ``mend-KIND`` what to do. Both front ends say them for EXPLAIN.
"""

from donnie_tui.i18n.sentence import Sentence, Texts

_EXPLAINED: dict[str, tuple[Texts, Texts]] = {
    "syntax": (
        (
            "Something is missing or out of place.",
            "Falta algo, ou está no lugar errado.",
            "Falta algo, o está en otro lugar.",
        ),
        (
            "HELP with the word says its form.",
            "AJUDA com a palavra diz a forma.",
            "AYUDA con la palabra dice la forma.",
        ),
    ),
    "unknown-command": (
        (
            "Donnie does not know this word.",
            "O Donnie não conhece essa palavra.",
            "Donnie no conoce esa palabra.",
        ),
        ("Check its letters: FW 3.", "Confira as letras: PF 3.", "Revisa las letras: AV 3."),
    ),
    "whole-numbers": (
        (
            "Numbers are whole: no comma, no point.",
            "Números são inteiros: sem vírgula.",
            "Los números son enteros: sin coma.",
        ),
        (
            "Take a whole one: FW 2, or FW 3.",
            "Use um inteiro: PF 2, ou PF 3.",
            "Usa uno entero: AV 2, o AV 3.",
        ),
    ),
    "unknown-character": (
        (
            "That sign is not used in GoDonnie.",
            "Esse sinal não existe em GoDonnie.",
            "Ese signo no existe en GoDonnie.",
        ),
        ("Take it out, then run again.", "Apague o sinal e execute.", "Bórralo y ejecuta otra vez."),
    ),
    "unterminated-string": (
        (
            "A text needs a quote at both ends.",
            "Um texto tem aspas nas duas pontas.",
            "Un texto lleva comillas en ambos lados.",
        ),
        ('Like this: SPEAK "hello".', 'Assim: FALAR "oi".', 'Así: HABLAR "hola".'),
    ),
    "invalid-name": (
        ("A name begins with a letter.", "Um nome começa com uma letra.", "Un nombre empieza con una letra."),
        ("Like this: VAR a1 = 5.", "Assim: CRIAR a1 = 5.", "Así: CREAR a1 = 5."),
    ),
    "reserved-word": (
        ("GoDonnie uses this word itself.", "GoDonnie já usa essa palavra.", "GoDonnie ya usa esa palabra."),
        (
            "Choose another name: VAR size = 5.",
            "Use outro nome: CRIAR lado = 5.",
            "Usa otro nombre: CREAR lado = 5.",
        ),
    ),
    "bad-argument": (
        (
            "This word needs something else behind.",
            "Essa palavra pede outra coisa depois.",
            "Esa palabra pide otra cosa después.",
        ),
        (
            "HELP with the word has an example.",
            "AJUDA com a palavra dá um exemplo.",
            "AYUDA con la palabra da un ejemplo.",
        ),
    ),
    "missing-end": (
        (
            "A block was opened and not closed.",
            "Um bloco foi aberto e não fechado.",
            "Un bloque se abrió y no se cerró.",
        ),
        (
            "Close it: END REPEAT, END IF, END FOR.",
            "Feche: FIM REPITA, FIM SE, FIM PARA.",
            "Ciérralo: FIN REPETIR, FIN SI, FIN PARA.",
        ),
    ),
    "wrong-end": (
        (
            "This END does not fit what is open.",
            "Esse FIM não fecha o que está aberto.",
            "Ese FIN no cierra lo que está abierto.",
        ),
        (
            "Close the last one first, or delete it.",
            "Feche antes o último, ou apague esse.",
            "Cierra antes el último, o borra ese.",
        ),
    ),
    "too-deep": (
        (
            "Too many blocks are in each other.",
            "Há blocos demais um no outro.",
            "Hay demasiados bloques uno en otro.",
        ),
        ("Put a part into a PROCEDURE.", "Ponha uma parte em APRENDER.", "Pon una parte en PROCEDIMIENTO."),
    ),
    "number-too-large": (
        (
            "The number is too large for Donnie.",
            "O número é grande demais.",
            "El número es demasiado grande.",
        ),
        ("Use a smaller one: FW 100.", "Use um menor: PF 100.", "Usa uno menor: AV 100."),
    ),
    "undeclared-variable": (
        (
            "No variable has this name yet.",
            "Nenhuma variável tem esse nome.",
            "Ninguna variable tiene ese nombre.",
        ),
        ("Make it first: VAR x = 5.", "Crie antes: CRIAR x = 5.", "Créala antes: CREAR x = 5."),
    ),
    "undeclared-procedure": (
        (
            "No procedure has this name yet.",
            "Nenhum procedimento tem esse nome.",
            "Ningún procedimiento tiene ese nombre.",
        ),
        ("Teach it first with PROCEDURE.", "Ensine antes com APRENDER.", "Enséñalo antes con PROCEDIMIENTO."),
    ),
    "already-declared": (
        ("This name is taken already.", "Esse nome já está em uso.", "Ese nombre ya está en uso."),
        ("Without VAR it is changed: x = 5.", "Sem CRIAR ela muda: x = 5.", "Sin CREAR ella cambia: x = 5."),
    ),
    "wrong-argument-count": (
        (
            "The procedure wants other values.",
            "O procedimento pede outros valores.",
            "El procedimiento pide otros valores.",
        ),
        ("One for each name: RECT [4, 2].", "Um por nome: RET [4, 2].", "Uno por nombre: RECT [4, 2]."),
    ),
    "division-by-zero": (
        (
            "Nothing can be shared among zero.",
            "Não se pode dividir por zero.",
            "No se puede dividir por cero.",
        ),
        (
            "Ask first: IF x <> 0 THEN.",
            "Pergunte antes: SE x <> 0 ENTÃO.",
            "Pregunta antes: SI x <> 0 ENTONCES.",
        ),
    ),
    "recursion-limit": (
        (
            "The procedure calls itself for ever.",
            "O procedimento se chama sem fim.",
            "El procedimiento se llama sin fin.",
        ),
        (
            "It must stop at some point, with IF.",
            "Ele deve parar um dia, com SE.",
            "Debe parar alguna vez, con SI.",
        ),
    ),
    "terminal-only": (
        (
            "This word is for typing, not programs.",
            "Essa palavra só se digita.",
            "Esa palabra solo se escribe.",
        ),
        (
            "Take it out. FW 3 alone is a program.",
            "Tire. PF 3 sozinho é um programa.",
            "Quítala. AV 3 ya es un programa.",
        ),
    ),
    "belt-off": (
        ("The belt was not switched on.", "O cinto não foi ligado.", "El cinturón no se encendió."),
        (
            "Switch it on first: BELT ON.",
            "Ligue antes: CINTO LIGADO.",
            "Enciéndelo: CINTURÓN ENCENDIDO.",
        ),
    ),
    "robot": (
        ("The program is right.", "O programa está certo.", "El programa está bien."),
        (
            "But this robot can't do that now.",
            "Mas esse robô não pode isso agora.",
            "Pero ese robot no puede eso ahora.",
        ),
    ),
    "internal": (
        (
            "The fault is Donnie's, not yours.",
            "A falha é do Donnie, não sua.",
            "La falla es de Donnie, no tuya.",
        ),
        (
            "Save it, then start Donnie again.",
            "Salve e inicie o Donnie de novo.",
            "Guárdalo e inicia Donnie otra vez.",
        ),
    ),
    "unused-value": (
        (
            "The sensor was read for nobody.",
            "O sensor foi lido para ninguém.",
            "El sensor se leyó para nadie.",
        ),
        ("Say it: SPEAK DISTANCE F.", "Diga: FALAR DISTÂNCIA F.", "Dilo: HABLAR DISTANCIA F."),
    ),
}

_OF_A_CODE = {
    "mend-text-without-quotes": Sentence(
        'Or, for a text: SPEAK "hello".',
        'Ou, se é um texto: FALAR "oi".',
        'O, si es un texto: HABLAR "hola".',
    ),
    "explain-unknown-command-procedure": Sentence(
        "A procedure is called with brackets.",
        "Um procedimento se chama com colchetes.",
        "Un procedimiento lleva corchetes.",
    ),
}

SENTENCES = (
    {f"explain-{kind}": Sentence(*what) for kind, (what, _) in _EXPLAINED.items()}
    | {f"mend-{kind}": Sentence(*do) for kind, (_, do) in _EXPLAINED.items()}
    | _OF_A_CODE
)
