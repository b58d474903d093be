"""The tour of the full screen, a page at a time: what each key does there. ``screen-tour-PAGE-LINE``.

The keys are filled in as they are on this screen; a test does what the lines say.
"""

from donnie_tui.i18n.sentence import Sentence

_PAGES: tuple[tuple[tuple[str, str, str], ...], ...] = (
    (
        (
            "Donnie is a robot on a floor. Your program drives it.",
            "Donnie é um robô num piso. Seu programa o conduz.",
            "Donnie es un robot en un piso. Tu programa lo conduce.",
        ),
        (
            "Enter turns this page, Backspace turns back.",
            "Enter vira esta página, Backspace volta uma.",
            "Enter pasa esta página, Retroceso vuelve una.",
        ),
        (
            "Esc closes it, so that you can try what it says.",
            "Esc fecha a página, para você tentar o que ela diz.",
            "Esc cierra la página, para que pruebes lo que dice.",
        ),
        (
            "{tour}, or the word TOUR, brings it back.",
            "{tour}, ou a palavra PASSEIO, traz a página de volta.",
            "{tour}, o la palabra PASEO, trae la página de vuelta.",
        ),
    ),
    (
        (
            "You begin in the program. Type FW 3 there.",
            "Você começa no programa. Digite PF 3 ali.",
            "Empiezas en el programa. Escribe ahí AV 3.",
        ),
        (
            "{run} runs the program, and so does Esc.",
            "{run} executa o programa, e Esc também.",
            "{run} ejecuta el programa, y Esc también.",
        ),
        (
            "{stop} or Ctrl+C stops Donnie at any time.",
            "{stop} ou Ctrl+C para o Donnie a qualquer hora.",
            "{stop} o Ctrl+C detiene a Donnie en todo momento.",
        ),
        (
            "What Donnie tells stands in the log.",
            "O que o Donnie conta fica no registro.",
            "Lo que Donnie cuenta queda en el registro.",
        ),
    ),
    (
        (
            "Tab goes on: program, map, log, command line.",
            "Tab segue: programa, mapa, registro, linha de comando.",
            "Tab sigue: programa, mapa, registro, línea de comandos.",
        ),
        ("Shift+Tab goes back.", "Shift+Tab volta.", "Mayús+Tab vuelve."),
        (
            "The status line tells where you are.",
            "A linha de estado diz onde você está.",
            "La línea de estado dice dónde estás.",
        ),
        (
            "{show_variables} shows the variables and the distances.",
            "{show_variables} mostra as variáveis e as distâncias.",
            "{show_variables} muestra las variables y las distancias.",
        ),
    ),
    (
        (
            "In the map the arrow keys go from square to square.",
            "No mapa as setas vão de quadrado em quadrado.",
            "En el mapa las flechas van de casilla en casilla.",
        ),
        (
            "Each square is told: what is there, and where.",
            "Cada quadrado é dito: o que há ali, e onde.",
            "Cada casilla se dice: qué hay ahí, y dónde.",
        ),
        (
            "N goes to the next thing, Home back to Donnie.",
            "N vai à próxima coisa, Home volta ao Donnie.",
            "N va a la cosa siguiente, Inicio vuelve a Donnie.",
        ),
        (
            "F marks a square, W tells the way from it.",
            "F marca um quadrado, W diz o caminho a partir dele.",
            "F marca una casilla, W dice el camino desde ella.",
        ),
    ),
    (
        (
            "The command line does at once what you type: TR 90 and Enter.",
            "A linha de comando faz na hora o que você digita: GD 90 e Enter.",
            "La línea de comandos hace enseguida lo que escribes: GD 90 y Enter.",
        ),
        (
            "It knows words, too: WHERE, AROUND, SPEED 3.",
            "Ela também conhece palavras: ONDE, AO REDOR, VELOCIDADE 3.",
            "También conoce palabras: DÓNDE, ALREDEDOR, VELOCIDAD 3.",
        ),
        (
            "The up arrow brings back what you typed before.",
            "A seta para cima traz o que você digitou antes.",
            "La flecha arriba trae lo que escribiste antes.",
        ),
    ),
    (
        (
            "A line with a mistake has a sign, and what is wrong behind it.",
            "Uma linha com erro tem um sinal, e atrás dela o que está errado.",
            "Una línea con un error tiene un signo, y detrás lo que está mal.",
        ),
        (
            "{fix} puts the word that you meant.",
            "{fix} põe a palavra que você quis dizer.",
            "{fix} pone la palabra que quisiste decir.",
        ),
        (
            "{complete} lists the words that fit at the cursor.",
            "{complete} lista as palavras que cabem no cursor.",
            "{complete} lista las palabras que caben en el cursor.",
        ),
        (
            "{undo} takes your last change back.",
            "{undo} desfaz a sua última mudança.",
            "{undo} deshace tu último cambio.",
        ),
    ),
    (
        (
            "{step} does one command after the other.",
            "{step} faz um comando de cada vez.",
            "{step} hace un comando cada vez.",
        ),
        (
            "{pause} pauses the program, and lets it go on.",
            "{pause} pausa o programa, e o deixa continuar.",
            "{pause} pausa el programa, y lo deja seguir.",
        ),
        (
            "{break_} makes a line a breakpoint: there it holds.",
            "{break_} faz da linha uma parada: ali ele espera.",
            "{break_} hace de la línea una parada: ahí espera.",
        ),
        (
            "{slower} and {faster} change the speed.",
            "{slower} e {faster} mudam a velocidade.",
            "{slower} y {faster} cambian la velocidad.",
        ),
    ),
    (
        (
            "{help} helps: the keys where you are, then all words.",
            "{help} ajuda: as teclas de onde você está, depois as palavras.",
            "{help} ayuda: las teclas de donde estás, luego las palabras.",
        ),
        (
            "{palette} lists all that can be done. Type a part of its name.",
            "{palette} lista tudo o que se pode fazer. Digite parte do nome.",
            "{palette} lista todo lo que se puede hacer. Escribe parte del nombre.",
        ),
        (
            "{menu} lists more keys, and then waits for one of them.",
            "{menu} lista mais teclas, e então espera uma delas.",
            "{menu} lista más teclas, y luego espera una de ellas.",
        ),
    ),
    (
        (
            "{save} saves the program, {open} opens one.",
            "{save} salva o programa, {open} abre um.",
            "{save} guarda el programa, {open} abre uno.",
        ),
        (
            "{worlds} lists the worlds, each with a task to try.",
            "{worlds} lista os mundos, cada um com uma tarefa.",
            "{worlds} lista los mundos, cada uno con una tarea.",
        ),
        (
            "{quit} leaves, and asks before anything is lost.",
            "{quit} sai, e pergunta antes de perder algo.",
            "{quit} sale, y pregunta antes de perder algo.",
        ),
        (
            "Now it is up to you. Have fun.",
            "Agora é com você. Divirta-se.",
            "Ahora te toca a ti. Diviértete.",
        ),
    ),
)

SENTENCES = {
    f"screen-tour-{page}-{line}": Sentence(*texts)
    for page, lines in enumerate(_PAGES, 1)
    for line, texts in enumerate(lines, 1)
} | {
    "screen-tour-title": Sentence(
        "Tour, page {page} of {pages}. Enter goes on, Esc closes",
        "Passeio, página {page} de {pages}. Enter segue, Esc fecha",
        "Paseo, página {page} de {pages}. Enter sigue, Esc cierra",
    ),
}
