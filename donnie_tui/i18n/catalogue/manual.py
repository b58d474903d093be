"""The manual of the language, as F1 and the word MANUAL show it: a few chapters, each with an example.

The commands themselves, one by one, are the help's; here is how they go together.
"""

from donnie_tui.i18n.sentence import Sentence

CHAPTERS = ("begin", "move", "look", "numbers", "decide", "repeat", "procedures", "mistakes")

SENTENCES = {
    "manual-commands": Sentence("Every command", "Todos os comandos", "Todos los comandos"),
    "manual-begin": Sentence("A program", "Um programa", "Un programa"),
    "manual-begin-text": Sentence(
        "A program is a list of commands. Donnie does them one after the other.\n"
        "Capital and small letters and accents make no difference. A line may hold several commands.\n"
        "Words in quotation marks are spoken as they are. What follows -- is a comment.\n"
        'SPEAK "hello" -- Donnie says hello',
        "Um programa é uma lista de comandos. O Donnie os faz um depois do outro.\n"
        "Maiúsculas, minúsculas e acentos não fazem diferença. Uma linha pode ter vários comandos.\n"
        "Palavras entre aspas são faladas como estão. O que vem depois de -- é um comentário.\n"
        'FALAR "olá" -- o Donnie diz olá',
        "Un programa es una lista de comandos. Donnie los hace uno después del otro.\n"
        "Mayúsculas, minúsculas y acentos no importan. Una línea puede tener varios comandos.\n"
        "Las palabras entre comillas se dicen como están. Lo que sigue a -- es un comentario.\n"
        'HABLAR "hola" -- Donnie dice hola',
    ),
    "manual-move": Sentence("Moving", "Andar", "Moverse"),
    "manual-move-text": Sentence(
        "FW walks forward and BW backward, so many steps. A step is 5 centimetres.\n"
        "TR turns to the right and TL to the left, so many degrees. 90 is a quarter of a turn.\n"
        "Before an obstacle Donnie stops, says so, and goes on with the next command.\n"
        "FW 5 TR 90 FW 3",
        "PF anda para a frente e PT para trás, tantos passos. Um passo tem 5 centímetros.\n"
        "GD gira para a direita e GE para a esquerda, tantos graus. 90 é um quarto de volta.\n"
        "Diante de um obstáculo o Donnie para, avisa, e segue com o próximo comando.\n"
        "PF 5 GD 90 PF 3",
        "AV camina adelante y RE atrás, tantos pasos. Un paso tiene 5 centímetros.\n"
        "GD gira a la derecha y GI a la izquierda, tantos grados. 90 es un cuarto de vuelta.\n"
        "Ante un obstáculo Donnie se detiene, lo dice, y sigue con el comando siguiente.\n"
        "AV 5 GD 90 AV 3",
    ),
    "manual-look": Sentence("Looking", "Olhar", "Mirar"),
    "manual-look-text": Sentence(
        "SCAN tells what is in front, with angle, distance and color. STATE tells the last movement.\n"
        "DISTANCE F is the number of free steps ahead; also FR, FL, B, BR, BL.\n"
        "POS X and POS Y are the place, POS A the angle. COLOR RED is how many red things are seen.\n"
        "SPEAK DISTANCE F",
        "ESPIAR diz o que está à frente, com ângulo, distância e cor. ESTADO diz o último movimento.\n"
        "DISTÂNCIA F é o número de passos livres à frente; também FD, FE, T, TD, TE.\n"
        "POS X e POS Y são o lugar, POS A o ângulo. COR VERMELHO é quantas coisas vermelhas são vistas.\n"
        "FALAR DISTÂNCIA F",
        "MIRAR dice qué hay delante, con ángulo, distancia y color. ESTADO dice el último movimiento.\n"
        "DISTANCIA F es el número de pasos libres delante; también FD, FI, T, TD, TI.\n"
        "POS X y POS Y son el lugar, POS A el ángulo. COLOR ROJO es cuántas cosas rojas se ven.\n"
        "HABLAR DISTANCIA F",
    ),
    "manual-numbers": Sentence("Numbers and variables", "Números e variáveis", "Números y variables"),
    "manual-numbers-text": Sentence(
        "A variable is a number with a name. VAR makes it, = changes it.\n"
        "Numbers are whole; + - * / calculate, and a division leaves the fraction out.\n"
        "VAR side = 4\nside = side + 1\nFW side",
        "Uma variável é um número com nome. CRIAR a faz, = a muda.\n"
        "Os números são inteiros; + - * / calculam, e a divisão deixa a fração de fora.\n"
        "CRIAR lado = 4\nlado = lado + 1\nPF lado",
        "Una variable es un número con nombre. CREAR la hace, = la cambia.\n"
        "Los números son enteros; + - * / calculan, y la división deja fuera la fracción.\n"
        "CREAR lado = 4\nlado = lado + 1\nAV lado",
    ),
    "manual-decide": Sentence("Deciding", "Decidir", "Decidir"),
    "manual-decide-text": Sentence(
        "IF does something only if a comparison is true; ELSE is for when it is not.\n"
        "Comparisons are == equal, <> different, < less, > greater, <= and >=.\n"
        "IF DISTANCE F > 3 THEN\n  FW 3\nELSE\n  TR 90\nEND IF",
        "SE faz algo só se uma comparação é verdadeira; SENÃO vale quando não é.\n"
        "As comparações são == igual, <> diferente, < menor, > maior, <= e >=.\n"
        "SE DISTÂNCIA F > 3 ENTÃO\n  PF 3\nSENÃO\n  GD 90\nFIM SE",
        "SI hace algo solo si una comparación es verdadera; SINO vale cuando no lo es.\n"
        "Las comparaciones son == igual, <> diferente, < menor, > mayor, <= y >=.\n"
        "SI DISTANCIA F > 3 ENTONCES\n  AV 3\nSINO\n  GD 90\nFIN SI",
    ),
    "manual-repeat": Sentence("Repeating", "Repetir", "Repetir"),
    "manual-repeat-text": Sentence(
        "REPEAT does its commands so many times. WHILE does them as long as a comparison is true.\n"
        "FOR counts with a variable.\n"
        "REPEAT 4 TIMES\n  FW 2 TR 90\nEND REPEAT\n"
        "WHILE DISTANCE F > 1 DO\n  FW 1\nEND WHILE\n"
        "FOR VAR i = 1; i < 4; i = i + 1 DO\n  SPEAK i\nEND FOR",
        "REPITA faz seus comandos tantas vezes. ENQUANTO os faz enquanto uma comparação é verdadeira.\n"
        "PARA conta com uma variável.\n"
        "REPITA 4 VEZES\n  PF 2 GD 90\nFIM REPITA\n"
        "ENQUANTO DISTÂNCIA F > 1 FAÇA\n  PF 1\nFIM ENQUANTO\n"
        "PARA CRIAR i = 1; i < 4; i = i + 1 FAÇA\n  FALAR i\nFIM PARA",
        "REPETIR hace sus comandos tantas veces. MIENTRAS los hace mientras una comparación es verdadera.\n"
        "PARA cuenta con una variable.\n"
        "REPETIR 4 VECES\n  AV 2 GD 90\nFIN REPETIR\n"
        "MIENTRAS DISTANCIA F > 1 HACER\n  AV 1\nFIN MIENTRAS\n"
        "PARA CREAR i = 1; i < 4; i = i + 1 HACER\n  HABLAR i\nFIN PARA",
    ),
    "manual-procedures": Sentence("Procedures", "Procedimentos", "Procedimientos"),
    "manual-procedures-text": Sentence(
        "A procedure is a command of your own. Behind its name stand the numbers that it needs.\n"
        "It is called by its name, with the numbers in brackets.\n"
        "PROCEDURE SQUARE: side DO\n  REPEAT 4 TIMES\n    FW side TR 90\n  END REPEAT\nEND PROCEDURE\n"
        "SQUARE [3]",
        "Um procedimento é um comando seu. Atrás do nome ficam os números de que precisa.\n"
        "Ele é chamado pelo nome, com os números entre colchetes.\n"
        "APRENDER QUADRADO: lado FAÇA\n  REPITA 4 VEZES\n    PF lado GD 90\n  FIM REPITA\nFIM APRENDER\n"
        "QUADRADO [3]",
        "Un procedimiento es un comando tuyo. Detrás del nombre van los números que necesita.\n"
        "Se llama por su nombre, con los números entre corchetes.\n"
        "PROCEDIMIENTO CUADRADO: lado HACER\n  REPETIR 4 VECES\n    AV lado GD 90\n  FIN REPETIR\n"
        "FIN PROCEDIMIENTO\nCUADRADO [3]",
    ),
    "manual-mistakes": Sentence("Mistakes", "Erros", "Errores"),
    "manual-mistakes-text": Sentence(
        "A mistake names its line, what stands there and what was probably meant.\n"
        "ERROR says it again, EXPLAIN says it in other words with what to do.",
        "Um erro diz a linha, o que está lá e o que provavelmente se queria dizer.\n"
        "ERRO diz de novo, EXPLICAR diz com outras palavras e o que fazer.",
        "Un error dice la línea, qué hay allí y qué se quería decir probablemente.\n"
        "ERROR lo dice otra vez, EXPLICAR lo dice con otras palabras y qué hacer.",
    ),
}
