"""The tour: Donnie in five minutes, a page at a time, for ears. ``tour-PAGE-LINE``.

The lines say what to type; a test types it.
"""

from donnie_tui.i18n import first_words
from donnie_tui.i18n.sentence import Sentence

_PAGES: tuple[tuple[tuple[str, str, str], ...], ...] = (
    (
        (
            "Welcome. Donnie is a robot on a floor.",
            "Bem-vindo. Donnie é um robô num piso.",
            "Hola. Donnie es un robot en un piso.",
        ),
        (
            "You write what it does, line by line.",
            "Você escreve o que ele faz, por linhas.",
            "Tú escribes qué hace, línea por línea.",
        ),
        (
            "Type FW 3 and Enter, then Enter alone.",
            "Digite PF 3 e Enter, depois só Enter.",
            "Escribe AV 3 y Enter, luego solo Enter.",
        ),
        (
            "Then Donnie walks and tells it.",
            "Então o Donnie anda e conta.",
            "Entonces Donnie camina y lo cuenta.",
        ),
    ),
    (
        (
            "TR turns right, TL turns left.",
            "GD gira à direita, GE à esquerda.",
            "GD gira a la derecha, GI a la izquierda.",
        ),
        (
            "90 degrees are a quarter turn.",
            "90 graus são um quarto de volta.",
            "90 grados son un cuarto de vuelta.",
        ),
        (
            "Type TR 90 and Enter, then Enter alone.",
            "Digite GD 90 e Enter, depois só Enter.",
            "Escribe GD 90 y Enter, luego solo Enter.",
        ),
    ),
    (
        (
            "Where is Donnie now? Type WHERE.",
            "Onde está o Donnie? Digite ONDE.",
            "¿Dónde está Donnie? Escribe DÓNDE.",
        ),
        (
            "AROUND tells what is on each side.",
            "AO REDOR diz o que há por perto.",
            "ALREDEDOR dice qué hay cerca.",
        ),
        (
            "MAP tells all the things of the world.",
            "MAPA diz todos os objetos do mundo.",
            "MAPA dice todas las cosas del mundo.",
        ),
    ),
    (
        ("Donnie has ears and eyes.", "O Donnie tem ouvidos e olhos.", "Donnie tiene oídos y ojos."),
        (
            "Type SCAN: it tells what it sees.",
            "Digite ESPIAR: ele diz o que vê.",
            "Escribe MIRAR: dice qué ve.",
        ),
        (
            "SPEAK DISTANCE F: how far to a wall.",
            "FALAR DISTÂNCIA F: até a parede.",
            "HABLAR DISTANCIA F: hasta la pared.",
        ),
    ),
    (
        ("A loop does things again.", "Um laço repete as coisas.", "Un bucle repite las cosas."),
        ("REPEAT 4 TIMES, Enter.", "REPITA 4 VEZES, Enter.", "REPETIR 4 VECES, Enter."),
        ("FW 2 TR 90, Enter.", "PF 2 GD 90, Enter.", "AV 2 GD 90, Enter."),
        (
            "END REPEAT, Enter, and Enter alone.",
            "FIM REPITA, Enter, e só Enter.",
            "FIN REPETIR, Enter, y solo Enter.",
        ),
        ("That is a square.", "Isso é um quadrado.", "Eso es un cuadrado."),
    ),
    (
        (
            "Your lines are kept. LIST says them.",
            "Suas linhas ficam. LISTAR diz todas.",
            "Tus líneas quedan. LISTAR las dice.",
        ),
        ("CHANGE 1 edits line 1.", "MUDAR 1 edita a linha 1.", "CAMBIAR 1 edita la línea 1."),
        (
            "AGAIN runs all from the start.",
            "NOVAMENTE faz tudo do início.",
            "NUEVAMENTE hace todo desde el inicio.",
        ),
    ),
    (
        (
            "Something wrong? ERROR says it again.",
            "Algum erro? ERRO diz de novo.",
            "¿Algo mal? ERROR lo repite.",
        ),
        ("EXPLAIN says it in plain words.", "EXPLICAR diz mais simples.", "EXPLICAR lo dice más simple."),
        (
            "LAST says the last answer again.",
            "ÚLTIMO diz a última resposta.",
            "ÚLTIMO repite la última respuesta.",
        ),
        (
            "Ctrl+C stops Donnie at any time.",
            "Ctrl+C para o Donnie sempre.",
            "Ctrl+C detiene a Donnie siempre.",
        ),
    ),
    (
        (
            "STEP runs one command after the other.",
            "PASSO executa um comando por vez.",
            "PASO ejecuta un comando a la vez.",
        ),
        (
            "STEP BACK tells what was before.",
            "PASSO ATRÁS diz o que foi antes.",
            "PASO ATRÁS dice qué fue antes.",
        ),
        (
            "SLOWER and FASTER change the speed.",
            "O ritmo: MAIS DEVAGAR e MAIS RÁPIDO.",
            "El ritmo: MÁS LENTO y MÁS RÁPIDO.",
        ),
    ),
    (
        (
            "SAVE name keeps your program.",
            "SALVAR nome guarda o programa.",
            "GUARDAR nombre guarda el programa.",
        ),
        ("OPEN name brings it back.", "ABRIR nome traz de volta.", "ABRIR nombre lo trae de vuelta."),
        (
            "HELP has all words, QUIT leaves.",
            "AJUDA tem as palavras, SAIR sai.",
            "AYUDA tiene las palabras, SALIR sale.",
        ),
        ("That was the tour. Have fun.", "Este foi o passeio. Divirta-se.", "Este fue el paseo. Diviértete."),
    ),
)

SENTENCES = {
    f"tour-{page}-{line}": Sentence(*texts)
    for page, lines in enumerate(_PAGES, 1)
    for line, texts in enumerate(lines, 1)
} | {
    "tour-offer": Sentence(*first_words.TOUR),
    "tour-on": Sentence(
        "Page {page} of {pages}. Try it; Enter alone goes on.",
        "Página {page} de {pages}. Tente; só Enter continua.",
        "Página {page} de {pages}. Prueba; solo Enter sigue.",
        brief=(
            "{page} of {pages}. Enter alone goes on.",
            "{page} de {pages}. Só Enter continua.",
            "{page} de {pages}. Solo Enter sigue.",
        ),
    ),
}
