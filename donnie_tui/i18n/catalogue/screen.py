"""What the full screen says beyond running and files: the map, the editor, questions.

``action-NAME`` is the purpose of an action of the screen alone.
"""

from donnie_tui.i18n.sentence import Sentence

_OPTIONS = {
    "option-plain": Sentence(
        "the full screen in one column, without decoration",
        "a tela cheia em uma coluna, sem enfeites",
        "la pantalla completa en una columna, sin adornos",
    ),
}

_SERVING = {
    "usage-serve": Sentence(
        "Show the full screen in a browser on this machine.",
        "Mostrar a tela cheia num navegador nesta máquina.",
        "Mostrar la pantalla completa en un navegador en esta máquina.",
    ),
    "option-serve-port": Sentence("where it listens", "onde ele escuta", "dónde escucha"),
    "serve-address": Sentence(
        "Open http://{host}:{port} in a browser here. Ctrl+C ends it.",
        "Abra http://{host}:{port} num navegador aqui. Ctrl+C termina.",
        "Abre http://{host}:{port} en un navegador aquí. Ctrl+C termina.",
    ),
    "serve-missing": Sentence(
        "This needs textual-serve: pip install 'donnie-tui[serve]'.",
        "Isto precisa de textual-serve: pip install 'donnie-tui[serve]'.",
        "Esto necesita textual-serve: pip install 'donnie-tui[serve]'.",
    ),
    "serve-bad-port": Sentence(
        "{port} is no port; a port is a number from 1 to 65535.",
        "{port} não é uma porta; uma porta é um número de 1 a 65535.",
        "{port} no es un puerto; un puerto es un número de 1 a 65535.",
    ),
    "serve-failed": Sentence(
        "Port {port} can't be used: {reason}.",
        "A porta {port} não pode ser usada: {reason}.",
        "El puerto {port} no se puede usar: {reason}.",
    ),
}

_MAP = {
    "cell-other": Sentence("another robot", "outro robô", "otro robot"),
    "cell-ray": Sentence(
        "free, seen by a sensor", "livre, visto por um sensor", "libre, visto por un sensor"
    ),
    "map-way": Sentence(
        "From {from_x}, {from_y} to {x}, {y}: {place}.",
        "De {from_x}, {from_y} até {x}, {y}: {place}.",
        "De {from_x}, {from_y} a {x}, {y}: {place}.",
    ),
    "map-marked": Sentence("From {x}, {y}.", "De {x}, {y}.", "De {x}, {y}."),
    "map-shows-all": Sentence(
        "All of the map, {steps} {steps:step|steps} a square.",
        "O mapa inteiro, {steps} {steps:passo|passos} por quadrado.",
        "Todo el mapa, {steps} {steps:paso|pasos} por cuadro.",
    ),
    "map-follows": Sentence(
        "The map follows the robot, {steps} {steps:step|steps} a square.",
        "O mapa segue o robô, {steps} {steps:passo|passos} por quadrado.",
        "El mapa sigue al robot, {steps} {steps:paso|pasos} por cuadro.",
    ),
    "legend-title": Sentence("Legend", "Legenda", "Leyenda"),
    "legend-robot": Sentence(
        "^ > v < is {name}, looking north, east, south, west; / and \\ between them.",
        "^ > v < é {name}, virado para norte, leste, sul, oeste; / e \\ entre eles.",
        "^ > v < es {name}, mirando al norte, este, sur, oeste; / y \\ entre ellos.",
        brief=(
            "^ > v < is {name}; / and \\ in between.",
            "^ > v < é {name}; / e \\ entre eles.",
            "^ > v < es {name}; / y \\ entre ellos.",
        ),
    ),
    "legend-start": Sentence("A is the start.", "A é o início.", "A es el inicio."),
    "legend-trail": Sentence("o is the trail.", "o é o rastro.", "o es el rastro."),
    "legend-wall": Sentence("# is wall.", "# é parede.", "# es pared."),
    "legend-ray": Sentence(
        "' is where a sensor looked last.",
        "' é por onde um sensor olhou por último.",
        "' es donde miró un sensor por último.",
    ),
    "legend-free": Sentence(". is free floor.", ". é chão livre.", ". es suelo libre."),
    "screen-names-on": Sentence("Names on the map.", "Nomes no mapa.", "Nombres en el mapa."),
    "screen-names-off": Sentence("No names on the map.", "Sem nomes no mapa.", "Sin nombres en el mapa."),
    "screen-coordinates-on": Sentence(
        "Coordinates beside the map.", "Coordenadas ao lado do mapa.", "Coordenadas junto al mapa."
    ),
    "screen-coordinates-off": Sentence("No coordinates.", "Sem coordenadas.", "Sin coordenadas."),
}

_EDITOR = {
    "status-mistake": Sentence(
        "Program, line {line} of {lines}: {message}",
        "Programa, linha {line} de {lines}: {message}",
        "Programa, línea {line} de {lines}: {message}",
    ),
    "status-mistake-meant": Sentence(
        "Program, line {line} of {lines}: {message} {key} puts {meant}.",
        "Programa, linha {line} de {lines}: {message} {key} põe {meant}.",
        "Programa, línea {line} de {lines}: {message} {key} pone {meant}.",
    ),
    "screen-nothing-to-complete": Sentence(
        "No word begins like this.", "Nenhuma palavra começa assim.", "Ninguna palabra empieza así."
    ),
    "screen-nothing-to-fix": Sentence(
        "No mistakes were found.", "Nenhum erro foi encontrado.", "No se encontró ningún error."
    ),
    "screen-no-fix": Sentence(
        "I don't know what was meant.", "Não sei o que se queria dizer.", "No sé qué se quería decir."
    ),
    "screen-open-block": Sentence(
        "Here a block is one line, with its {closer}. More lines go into the program.",
        "Aqui um bloco é uma linha só, com {closer}. Mais linhas vão no programa.",
        "Aquí un bloque es una sola línea, con {closer}. Más líneas van en el programa.",
        brief=(
            "One line here, with its {closer}.",
            "Aqui uma linha só, com {closer}.",
            "Aquí una sola línea, con {closer}.",
        ),
    ),
    "screen-fixed": Sentence(
        "Line {line}: {word} now.", "Linha {line}: agora {word}.", "Línea {line}: ahora {word}."
    ),
    "screen-break-on": Sentence(
        "Line {line} has a breakpoint.",
        "A linha {line} tem um ponto de parada.",
        "La línea {line} tiene un punto de parada.",
    ),
    "screen-break-off": Sentence(
        "Line {line} has no breakpoint now.",
        "A linha {line} não tem mais ponto de parada.",
        "La línea {line} ya no tiene punto de parada.",
    ),
    "screen-not-found": Sentence(
        "{word} is not in the program.", "{word} não está no programa.", "{word} no está en el programa."
    ),
    "replace-otherwise": Sentence(
        "Line {line} has {word}. REPLACE takes a word as it is written there.",
        "A linha {line} tem {word}. SUBSTITUIR toma a palavra como está escrita ali.",
        "La línea {line} tiene {word}. REEMPLAZAR toma la palabra como está escrita allí.",
        brief=("Line {line} has {word}.", "A linha {line} tem {word}.", "La línea {line} tiene {word}."),
    ),
    "screen-replaced": Sentence(
        "{count} {count:time|times} replaced.",
        "Substituído {count} {count:vez|vezes}.",
        "Reemplazado {count} {count:vez|veces}.",
    ),
    "screen-formatted": Sentence("Laid out anew.", "Formatado de novo.", "Formateado de nuevo."),
    "screen-not-formatted": Sentence(
        "There is a mistake in line {line}; it must be mended first.",
        "Há um erro na linha {line}; é preciso corrigi-lo antes.",
        "Hay un error en la línea {line}; hay que corregirlo antes.",
        brief=(
            "Mend the mistake in line {line} first.",
            "Corrija antes o erro na linha {line}.",
            "Corrige antes el error, línea {line}.",
        ),
    ),
    "screen-no-setting": Sentence(
        "No setting is called {name}. SET lists them.",
        "Nenhum ajuste se chama {name}. AJUSTAR lista.",
        "Ningún ajuste se llama {name}. AJUSTAR los lista.",
    ),
    "key-typed": Sentence("Typed before", "Digitado antes", "Escrito antes"),
    "screen-no-way": Sentence(
        "There is no such line from here.", "Daqui não há essa linha.", "Desde aquí no hay esa línea."
    ),
    "screen-no-recent": Sentence(
        "No program was opened yet.", "Nenhum programa foi aberto ainda.", "Todavía no se abrió un programa."
    ),
    "screen-turned-to": Sentence("Now {name}.", "Agora {name}.", "Ahora {name}."),
    "screen-no-pager": Sentence(
        "There is no pager here; SAVE LOG writes the log into a file.",
        "Não há um paginador aqui; SALVAR REGISTRO grava o registro num arquivo.",
        "No hay un paginador aquí; GUARDAR REGISTRO escribe el registro en un archivo.",
    ),
    "screen-pager-failed": Sentence(
        "The log can't be shown: {reason}. SAVE LOG writes it into a file.",
        "Não é possível mostrar o registro: {reason}. SALVAR REGISTRO grava num arquivo.",
        "No se puede mostrar el registro: {reason}. GUARDAR REGISTRO lo escribe en un archivo.",
    ),
    "screen-redrawn": Sentence(
        "The screen is painted anew.", "A tela foi pintada de novo.", "La pantalla se pintó de nuevo."
    ),
    "screen-is-visual": Sentence(
        "This is the full screen.", "Esta é a tela cheia.", "Esta es la pantalla completa."
    ),
    "program-changed": Sentence(
        "{name}, {lines} {lines:line|lines}, changed",
        "{name}, {lines} {lines:linha|linhas}, alterado",
        "{name}, {lines} {lines:línea|líneas}, cambiado",
    ),
    "program-kept": Sentence(
        "{name}, {lines} {lines:line|lines}",
        "{name}, {lines} {lines:linha|linhas}",
        "{name}, {lines} {lines:línea|líneas}",
    ),
    "another-program": Sentence("another, empty program", "outro programa, vazio", "otro programa, vacío"),
}

_QUESTIONS = {
    "ask-search": Sentence("Search for:", "Procurar:", "Buscar:"),
    "ask-replace-by": Sentence(
        'Instead of {word}, everywhere; Enter leaves it, "" deletes it:',
        'No lugar de {word}, em todo lugar; Enter deixa, "" apaga:',
        'En lugar de {word}, en todas partes; Enter lo deja, "" lo borra:',
        brief=(
            "Instead of {word} (Enter: leave it):",
            "No lugar de {word} (Enter: deixa):",
            "En lugar de {word} (Enter: lo deja):",
        ),
    ),
    "ask-translate": Sentence(
        "Keywords in which language", "Palavras-chave em que idioma", "Palabras clave en qué idioma"
    ),
    "ask-argument": Sentence(
        "{word}, for example {example}:", "{word}, por exemplo {example}:", "{word}, por ejemplo {example}:"
    ),
    "ask-line": Sentence("Line:", "Linha:", "Línea:"),
    "ask-recent": Sentence("Recent programs", "Programas recentes", "Programas recientes"),
    "ask-worlds": Sentence("Worlds", "Mundos", "Mundos"),
    "ask-programs": Sentence("Open programs", "Programas abertos", "Programas abiertos"),
    "ask-save-log": Sentence(
        "Write the log into the file:", "Gravar o registro no arquivo:", "Escribir el registro en el archivo:"
    ),
    "settings-title": Sentence("Settings", "Configurações", "Configuración"),
    "lines-title": Sentence("{title}. Esc goes back", "{title}. Esc volta", "{title}. Esc vuelve"),
    "manual-title": Sentence(
        "GoDonnie, the manual. Esc goes back",
        "GoDonnie, o manual. Esc volta",
        "GoDonnie, el manual. Esc vuelve",
    ),
    "menu-title": Sentence(
        "Now one of these keys. Esc goes back",
        "Agora uma destas teclas. Esc volta",
        "Ahora una de estas teclas. Esc vuelve",
    ),
    "help-typed-theme": Sentence("light", "claro", "claro"),
}

_ACTIONS = {
    f"action-{name}": Sentence(en, pt, es)
    for name, en, pt, es in (
        ("zoom_in", "Shows the map nearer.", "Mostra o mapa mais de perto.", "Muestra el mapa más de cerca."),
        ("zoom_out", "Shows more of the map.", "Mostra mais do mapa.", "Muestra más del mapa."),
        (
            "whole_map",
            "Shows all, or follows Donnie.",
            "Mostra tudo, ou segue o Donnie.",
            "Muestra todo, o sigue a Donnie.",
        ),
        (
            "names",
            "Writes names on the map, or not.",
            "Escreve nomes no mapa, ou não.",
            "Escribe nombres en el mapa, o no.",
        ),
        (
            "coordinates",
            "Shows coordinates, or not.",
            "Mostra coordenadas, ou não.",
            "Muestra coordenadas, o no.",
        ),
        (
            "legend",
            "Tells what the letters mean.",
            "Diz o que as letras significam.",
            "Dice qué significan las letras.",
        ),
        ("next_thing", "Goes to the next thing.", "Vai para a próxima coisa.", "Va a la cosa siguiente."),
        (
            "previous_thing",
            "Goes to the thing before.",
            "Vai para a coisa anterior.",
            "Va a la cosa anterior.",
        ),
        (
            "to_robot",
            "Goes back to Donnie on the map.",
            "Volta ao Donnie no mapa.",
            "Vuelve a Donnie en el mapa.",
        ),
        (
            "from_here",
            "Marks this square of the map.",
            "Marca este quadrado do mapa.",
            "Marca este cuadro del mapa.",
        ),
        (
            "to_there",
            "Tells the way from the mark.",
            "Diz o caminho desde a marca.",
            "Dice el camino desde la marca.",
        ),
        (
            "complete",
            "Lists words that may follow.",
            "Lista palavras que cabem aqui.",
            "Lista palabras que caben aquí.",
        ),
        (
            "fix",
            "Puts what was probably meant.",
            "Põe o que se queria dizer.",
            "Pone lo que se quería decir.",
        ),
        ("search", "Searches in the program.", "Procura no programa.", "Busca en el programa."),
        (
            "search_again",
            "The same again.",
            "O mesmo de novo.",
            "Lo mismo de nuevo.",
        ),
        (
            "replace",
            "Replaces a word.",
            "Troca uma palavra.",
            "Cambia una palabra.",
        ),
        ("go_to", "Goes to a line.", "Vai para uma linha.", "Va a una línea."),
        ("format", "Lays the program out.", "Formata o programa.", "Formatea el programa."),
        ("translate", "Translates the keywords.", "Traduz as palavras-chave.", "Traduce las palabras clave."),
        ("recent", "Lists recent programs.", "Lista programas recentes.", "Lista programas recientes."),
        (
            "programs",
            "Lists the open programs.",
            "Lista os programas abertos.",
            "Lista los programas abiertos.",
        ),
        ("theme", "Chooses the look.", "Escolhe a aparência.", "Elige el aspecto."),
        (
            "plain",
            "One column, or all panes.",
            "Uma coluna, ou todos os painéis.",
            "Una columna, o todos los paneles.",
        ),
        ("redraw", "Paints the screen anew.", "Pinta a tela de novo.", "Vuelve a pintar la pantalla."),
        ("settings", "Lists all settings.", "Lista as configurações.", "Lista la configuración."),
        ("manual", "Shows the manual.", "Mostra o manual.", "Muestra el manual."),
        (
            "open_log",
            "Shows the log in the pager.",
            "Mostra o registro no paginador.",
            "Muestra el registro en el paginador.",
        ),
    )
}

SENTENCES = _OPTIONS | _SERVING | _MAP | _EDITOR | _QUESTIONS | _ACTIONS
